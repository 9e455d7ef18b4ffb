// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/project.h"

#include "catalog/catalog.h"
#include "vocabulary/find_by.h"

#include <algorithm>
#include <iterator>

namespace codewheel {
namespace {

// Where those of a bus begin and end, or would be.
std::pair<std::size_t, std::size_t> rangeOf(const Project &project, BusId bus)
{
    const auto first = std::ranges::lower_bound(project.devices, bus, {}, &ProjectDevice::bus);
    const auto end = std::ranges::upper_bound(project.devices, bus, {}, &ProjectDevice::bus);
    return {static_cast<std::size_t>(first - project.devices.begin()), static_cast<std::size_t>(end - first)};
}

} // namespace

const PlannedBus *findBus(const Project &project, BusId bus)
{
    return findBy(project.buses, bus, &PlannedBus::id);
}

PlannedBus *findBus(Project &project, BusId bus)
{
    return findBy(project.buses, bus, &PlannedBus::id);
}

const ProjectDevice *findDevice(const Project &project, Place place)
{
    return findBy(project.devices, place, &ProjectDevice::place);
}

ProjectDevice *findDevice(Project &project, Place place)
{
    return findBy(project.devices, place, &ProjectDevice::place);
}

std::span<const ProjectDevice> devicesOn(const Project &project, BusId bus)
{
    const auto [first, count] = rangeOf(project, bus);
    return std::span(project.devices).subspan(first, count);
}

std::span<ProjectDevice> devicesOn(Project &project, BusId bus)
{
    const auto [first, count] = rangeOf(project, bus);
    return std::span(project.devices).subspan(first, count);
}

std::vector<Participant> participantsOn(const Project &project, BusId bus)
{
    std::vector<Participant> participants;
    for (const ProjectDevice &device : devicesOn(project, bus))
        participants.push_back(device.participant);
    return participants;
}

void setDevicesOn(Project &project, BusId bus, std::vector<ProjectDevice> devices)
{
    const auto [first, count] = rangeOf(project, bus);
    const auto begin = project.devices.begin() + static_cast<std::ptrdiff_t>(first);
    const auto at = project.devices.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
    project.devices.insert(at, std::make_move_iterator(devices.begin()),
                           std::make_move_iterator(devices.end()));
}

std::optional<DeviceDescription> plannedDescription(const ProjectDevice &device, const Catalog &catalog)
{
    const auto *found = catalog.find(device.participant.deviceKey, device.participant.deviceCode);
    return found ? std::optional(found->labelled(device.label.turns, device.label.stepsPerTurn))
                 : std::nullopt;
}

} // namespace codewheel
