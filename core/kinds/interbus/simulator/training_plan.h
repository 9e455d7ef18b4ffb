// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "kinds/interbus/words/device_number.h"

#include <vector>

namespace codewheel {

// One participant of a training bus, as its file describes it.
struct TrainingParticipant
{
    NodeId number;
    const DeviceDescription *device = nullptr; // from the catalog; null: a bus terminal
    std::int64_t position = 0;                 // physical steps of the shaft
    std::int64_t revolutionsPerMinute = 0;     // positive: clockwise, looking at the shaft
    std::int64_t rodMillimetres = 0;           // measuring length of a rod
    std::int64_t millimetres = 0;              // where its magnet is
    std::int64_t millimetresPerSecond = 0;
    std::int64_t serialNumber = 0;   // FRABA K3
    std::int64_t operatingTime = 0;  // FRABA K3, 10 min
    ParameterValues known;           // what the user is assumed to know about it
    ParameterValues knownInWindow{}; // in addition: so that the first frame of the window shows all positions
};
using TrainingPlan = std::vector<TrainingParticipant>; // in ring order

// Whether there is a simulator for it.
bool canBeSimulated(const DeviceDescription &device);

// The plan in `json`, or the first thing wrong with it. Its form is documented in docs/training-plans.md. The
// plan points into the catalog.
tl::expected<TrainingPlan, Catalog::Fault> readTrainingPlan(const QByteArray &json, const QString &file,
                                                            const Catalog &catalog);

} // namespace codewheel
