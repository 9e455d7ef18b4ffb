// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/plan/gateway_plan.h"

#include "catalog/catalog.h"
#include "kinds/interbus/plan/ring_plan.h"

namespace codewheel {
namespace {

ParameterValues valuesOf(const ProjectDevice &device)
{
    ParameterValues values;
    for (const StoredValue &stored : device.stored)
        values.push_back({stored.parameter, stored.value});
    return values;
}

SendingEncoder plannedSender(const ProjectDevice &device, const Catalog &catalog)
{
    const DeviceDescription *described =
        catalog.find(device.participant.deviceKey, device.participant.deviceCode);
    if (described == nullptr)
        return {};
    return senderOf(described->labelled(device.label.turns, device.label.stepsPerTurn), valuesOf(device));
}

} // namespace

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
        const RingDevice its = ringDevice(device.participant);
        const DeviceDescription *described = catalog.find(its.deviceKey, its.deviceCode);
        devices.push_back({its, described ? std::optional(described->profile) : std::nullopt});
    }
    return devices;
}

std::vector<CheckedDevice> checkedDevices(const Project &project, BusId ring, const Catalog &catalog)
{
    std::vector<CheckedDevice> devices;
    for (const ProjectDevice &device : devicesOn(project, ring))
        devices.push_back({ringDevice(device.participant), plannedSender(device, catalog)});
    return devices;
}

} // namespace codewheel
