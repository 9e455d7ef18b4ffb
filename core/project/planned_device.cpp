// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/planned_device.h"

namespace codewheel {

std::optional<DeviceDescription> plannedDescription(const ProjectDevice &device, const Catalog &catalog)
{
    const DeviceDescription *named = catalog.find(device.participant.deviceKey);
    const DeviceDescription *found = named ? named : catalog.generic(device.participant.deviceCode);
    if (found == nullptr)
        return std::nullopt;
    DeviceDescription description = *found;
    if (device.label.turns > 0)
        description.physicalTurns = device.label.turns;
    if (device.label.stepsPerTurn > 0)
        description.physicalStepsPerTurn = device.label.stepsPerTurn;
    return description;
}

} // namespace codewheel
