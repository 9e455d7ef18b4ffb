// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/last_positions.h"

#include "bus/buses.h"
#include "transfer/project_places.h"

namespace codewheel {

LastPositions::LastPositions(const Buses &buses, QObject *parent)
    : QObject(parent)
    , m_buses(buses)
{
    connect(&buses, &Buses::updated, this, [this](BusId updated) {
        if (const EncoderBus *bus = m_buses.open(updated); bus != nullptr && !bus->isReplay())
            look(*bus);
    });
    for (const EncoderBus *bus : m_buses.connected())
        look(*bus);
}

std::optional<SeenPosition> LastPositions::at(Place number) const
{
    const auto found = m_watched.find(number);
    if (found == m_watched.end())
        return std::nullopt;
    return found->second.beforeGone ? found->second.beforeGone : found->second.last;
}

std::optional<SeenPosition> LastPositions::newest(Place number) const
{
    const auto found = m_watched.find(number);
    if (found == m_watched.end())
        return std::nullopt;
    return found->second.last ? found->second.last : found->second.beforeGone;
}

void LastPositions::look(const EncoderBus &bus)
{
    const Instant now = bus.now();
    for (const Place number : bus.places()) {
        const EncoderSession *encoder = bus.encoder(number);
        if (encoder == nullptr)
            continue;
        Watched &watched = m_watched[number];
        const bool hasGone = now < watched.lastAt || now - watched.lastAt >= untilGone;
        if (watched.last && hasGone) {
            watched.beforeGone = watched.last;
            watched.beforeGone->beforeItWent = true;
            watched.last.reset();
        }
        if (!bus.isRunning() || !encoder->showsPosition())
            continue;
        const Reading &reading = encoder->latest();
        watched.last = SeenPosition{*reading.position, bus.dateTime(reading.at)};
        watched.lastAt = now;
    }
}

std::optional<LastPosition> positionToKeep(const EncoderSession &encoder)
{
    if (!encoder.showsPosition())
        return std::nullopt;
    const Reading &reading = encoder.latest();
    return LastPosition{*reading.position, encoder.dateTime(reading.at).toUTC()};
}

Project withLastPositions(Project project, const LastPositions &positions, const Buses &buses)
{
    const ProjectPlaces places(project, buses);
    for (ProjectDevice &device : project.devices) {
        if (!places.isTheProjects(device.place()))
            continue;
        if (const auto seen = positions.newest(device.place()))
            device.lastPosition = LastPosition{seen->position, seen->at.toUTC()};
    }
    return project;
}

} // namespace codewheel
