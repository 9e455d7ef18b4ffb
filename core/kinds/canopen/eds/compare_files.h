// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/device_file.h"

#include <vector>

namespace codewheel::canopen {

// An object that two device files do not have alike.
struct ObjectDifference
{
    enum class Kind : std::uint8_t {
        differs,    // in its value
        missing,    // in the other one
        additional, // in the other one
    };

    Kind kind = Kind::differs;
    SdoObject object{};
    QString name{};
    std::optional<DataType> type{};
    std::optional<FileValue>
        value{}; // set, or else the default; with the number of the node where it is known
    std::optional<FileValue> other{};
};

// By index and subindex. Values are compared as numbers, however they are written; where one of the files
// says nothing, there is no difference. A file without a node has that of the other one.
std::vector<ObjectDifference> compareFiles(const DeviceFile &file, const DeviceFile &other);

// A real number may be written as an integer, too.
bool isSameValue(const FileValue &one, const FileValue &other);

} // namespace codewheel::canopen
