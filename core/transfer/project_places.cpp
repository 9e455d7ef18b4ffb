// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/project_places.h"

#include "bus/buses.h"
#include "project/bus_kind.h"

namespace codewheel {

bool isTheProjects(const Project &project, const EncoderBus &bus)
{
    return !bus.isSimulated() || plansTraining(project, bus.id());
}

ProjectPlaces::ProjectPlaces(const Project &project, const Buses &buses)
{
    for (const ProjectDevice &device : project.devices)
        m_places[device.place()].asStranger = notConnected(device.place());
    for (const EncoderBus *bus : buses.open()) {
        if (!codewheel::isTheProjects(project, *bus))
            m_simulated.insert(bus->id());
        const auto strangers = bus->strangers(participantsOn(project, bus->id()));
        for (const ProjectDevice &device : devicesOn(project, bus->id())) {
            const auto stranger = strangers.find(device.participant.number);
            m_places[device.place()] = {
                stranger == strangers.end() ? std::nullopt : std::optional(stranger->second),
                bus->isOther(device.place(), device.participant.deviceKey, device.label.serialNumber)};
        }
    }
}

std::optional<Refusal> ProjectPlaces::hindrance(Place place) const
{
    const auto found = m_places.find(place);
    if (found == m_places.end())
        return std::nullopt;
    return found->second.asStranger ? found->second.asStranger : found->second.asOther;
}

std::optional<Refusal> ProjectPlaces::hindranceToReplace(Place place) const
{
    const auto found = m_places.find(place);
    return found == m_places.end() ? std::nullopt : found->second.asStranger;
}

bool ProjectPlaces::isTheProjects(Place place) const
{
    return isAtItsPlace(place) && !m_simulated.contains(place.bus);
}

} // namespace codewheel
