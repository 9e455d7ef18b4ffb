// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/refusal.h"

#include <QStringList>

namespace codewheel {

class Catalog;

// What the key on a label says, part by part.
struct LabelReading
{
    struct Part
    {
        LocalText name;
        QString written;
        LocalText meaning; // empty where any letters and digits may stand
    };

    std::vector<Part> parts;
    std::optional<int> turns; // where the key tells them
    std::optional<int> stepsPerTurn;
};

// Where a key stops to be understood.
struct LabelProblem
{
    qsizetype understood = 0; // letters and digits before it
    QString written;          // the part as typed; empty: the key ends too early
    QString expected;         // what may stand there, in the user's language; empty: nothing more
};

// Letters in either case; spaces, dots and dashes are passed over.
tl::expected<LabelReading, LabelProblem> readLabelKey(const OrderingKey &key, QStringView typed);

// A device a label may belong to.
struct LabelMatch
{
    const DeviceDescription *device = nullptr;
    LabelReading reading;
    int turns = 0; // of the key, or else of the description; 0: not known
    int stepsPerTurn = 0;
};

// The device as its label tells it: with the turns and steps of the key.
DeviceDescription describedDevice(const LabelMatch &match);

// All devices whose ordering key understands `typed`, in the order of the catalog: one key may stand for
// several (FRABA's does not tell the profile). Leaves out those whose words could not hold the positions,
// if any could. Refuses with labelKeyNotUnderstood about the description that understands most of it.
Result<std::vector<LabelMatch>> findByLabel(const Catalog &catalog, const QString &typed);

} // namespace codewheel
