// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/planned_device.h"

namespace codewheel {

std::optional<DeviceDescription> plannedDescription(const ProjectDevice &device, const Catalog &catalog)
{
    const auto *found = catalog.find(device.participant.deviceKey, device.participant.deviceCode);
    return found ? std::optional(found->labelled(device.label.turns, device.label.stepsPerTurn))
                 : std::nullopt;
}

} // namespace codewheel
