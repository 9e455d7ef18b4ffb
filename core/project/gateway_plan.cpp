// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/gateway_plan.h"

#include "catalog/catalog.h"
#include "project/ring_plan.h"

namespace codewheel {

std::optional<Result<GatewaySettings>> plannedGateway(const Project &project, BusId ring)
{
    const ProjectLink &link = ringPlan(project, ring).link;
    if (!isGatewayLink(link.kind))
        return std::nullopt;
    return gatewaySettings(link.kind, link.settings);
}

std::vector<GatewayDevice> gatewayDevices(const Project &project, BusId ring, const Catalog &catalog)
{
    std::vector<GatewayDevice> devices;
    for (const ProjectDevice &device : devicesOn(project, ring)) {
        const Participant &its = device.participant;
        const DeviceDescription *described = catalog.find(its.deviceKey, its.deviceCode);
        devices.push_back({its, described ? std::optional(described->profile) : std::nullopt});
    }
    return devices;
}

} // namespace codewheel
