// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/gateway_plan.h"

#include "catalog/catalog.h"
#include "catalog/total_range.h"
#include "project/ring_plan.h"

namespace codewheel {
namespace {

ParameterValues valuesOf(const ProjectDevice &device)
{
    ParameterValues values;
    for (const StoredValue &stored : device.stored)
        values.push_back({stored.parameter, stored.value});
    return values;
}

// With the values the encoder was known to have; without them, what its disc gives: no scaling has more.
std::optional<std::int64_t> rangeOf(const ProjectDevice &device, const DeviceDescription &described)
{
    if (const auto known = totalRange(described, valuesOf(device)))
        return known;
    const std::int64_t physical = std::int64_t{described.physicalStepsPerTurn} * described.physicalTurns;
    return physical > 0 ? std::optional(physical) : std::nullopt;
}

SendingEncoder senderOf(const ProjectDevice &device, const Catalog &catalog)
{
    const DeviceDescription *described =
        catalog.find(device.participant.deviceKey, device.participant.deviceCode);
    if (described == nullptr)
        return {};
    const DeviceDescription its = described->labelled(device.label.turns, device.label.stepsPerTurn);
    return {its, rangeOf(device, its)};
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
        const Participant &its = device.participant;
        const DeviceDescription *described = catalog.find(its.deviceKey, its.deviceCode);
        devices.push_back({its, described ? std::optional(described->profile) : std::nullopt});
    }
    return devices;
}

std::vector<CheckedDevice> checkedDevices(const Project &project, BusId ring, const Catalog &catalog)
{
    std::vector<CheckedDevice> devices;
    for (const ProjectDevice &device : devicesOn(project, ring))
        devices.push_back({device.participant, senderOf(device, catalog)});
    return devices;
}

} // namespace codewheel
