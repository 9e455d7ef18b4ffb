// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/driver/wanted_objects.h"
#include "kinds/canopen/eds/compare_files.h"

#include <QTime>

namespace codewheel {

// An object of a node, and what is known of it.
struct ObjectRow
{
    enum class Source : std::uint8_t {
        file,     // of the node
        compared, // only the file that is compared with has it
        project,  // only the project wants something of it
    };

    canopen::FileObject object{};
    Source source = Source::file;
    std::optional<canopen::FileValue> now{};
    QString refused{};                         // why the node gave no value
    QTime at{};                                // of the answer
    std::optional<canopen::FileValue> heard{}; // since then, by others
    QTime heardAt{};
    std::optional<canopen::WantedObject> wanted{};         // by the project
    std::optional<canopen::ObjectDifference> difference{}; // to the file compared with

    // The newest, of which `heard` tells who has asked for it.
    const std::optional<canopen::FileValue> &shown() const { return heard ? heard : now; }
    bool differsFromDefault(std::optional<int> node) const;
    bool differsFromFile(std::optional<int> node) const; // from its own value in the file of the node
    bool differsFromProject() const { return shown() && wanted && !wanted->isMetBy(*shown()); }
};

// By index and subindex: what the file of the node has, and what only the others have.
std::vector<ObjectRow> objectRows(const canopen::DeviceFile &file, const canopen::DeviceFile *compared,
                                  const std::vector<canopen::WantedObject> &wanted);
// What the node has told of these goes along.
void takeAnswers(std::vector<ObjectRow> &rows, const std::vector<ObjectRow> &before);

} // namespace codewheel
