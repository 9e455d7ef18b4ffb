// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/deviations.h"

namespace codewheel {
namespace {

void addDifferences(Deviations &found, const CamProgram &wanted, const StoredCams &known)
{
    const CamFieldSet differ = differences(wanted, known.program);
    for (std::size_t i = 0; i < camFieldCount; ++i)
        if (differ[i])
            found.cams.push_back({wanted.number, camField(i), valueOf(wanted, camField(i)),
                                  valueOf(known.program, camField(i)), known.evidence});
}

} // namespace

Deviations deviationsOf(const ReportedDevice &device)
{
    Deviations found;
    for (const ParameterValue &wanted : device.planned->wanted) {
        const StoredValue *known = device.known(wanted.parameter);
        if (!known)
            ++found.notKnown;
        else if (known->value != wanted.value)
            found.values.push_back({wanted.parameter, wanted.value, *known});
    }
    for (const CamProgram &wanted : device.planned->wantedCams) {
        if (const StoredCams *known = device.knownCams(wanted.number))
            addDifferences(found, wanted, *known);
        else
            ++found.notKnown;
    }
    return found;
}

DeviationCounts countDeviations(const std::vector<ReportedDevice> &devices)
{
    DeviationCounts counts;
    for (const ReportedDevice &device : devices) {
        const Deviations found = deviationsOf(device);
        counts.deviations += static_cast<int>(found.count());
        counts.notKnown += found.notKnown;
    }
    return counts;
}

} // namespace codewheel
