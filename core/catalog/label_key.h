// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/refusal.h"

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
        LocalText meaning; // empty if any letters and digits may appear
    };

    std::vector<Part> parts;
    std::optional<int> turns; // if the key gives them
    std::optional<int> stepsPerTurn;
};

// Where a key stops being understood.
struct LabelProblem
{
    qsizetype understood = 0; // letters and digits before it
    QString written;          // the part as typed; empty: the key ends too early
    QString expected;         // what may come there, in the user's language; empty: nothing more
};

// Letters in either case; spaces, dots and dashes are ignored.
tl::expected<LabelReading, LabelProblem> readLabelKey(const OrderingKey &key, QStringView typed);

// A device a label may belong to.
struct LabelMatch
{
    const DeviceDescription *device = nullptr;
    LabelReading reading;
    int turns = 0; // of the key, otherwise of the description; 0: not known
    int stepsPerTurn = 0;
};

// The device as its label describes it: with the turns and steps of the key.
DeviceDescription describedDevice(const LabelMatch &match);

// All devices whose ordering key understands `typed`, in the order of the catalog: one key may stand for
// several (FRABA's does not give the profile). Leaves out those whose words could not hold the positions,
// unless that leaves none. Refuses with labelKeyNotUnderstood for the description that understands most of
// it.
Result<std::vector<LabelMatch>> findByLabel(const Catalog &catalog, const QString &typed);

} // namespace codewheel
