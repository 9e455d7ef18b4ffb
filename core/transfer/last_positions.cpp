// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/last_positions.h"

#include "ring/bus_session.h"
#include "transfer/project_places.h"

#include <algorithm>

namespace codewheel {

LastPositions::LastPositions(EncoderBus &bus, QObject *parent)
    : QObject(parent)
    , m_bus(bus)
{
    connect(&bus, &EncoderBus::updated, this, &LastPositions::look);
    look();
}

std::optional<SeenPosition> LastPositions::at(Place number) const
{
    const auto found = m_watched.find(number);
    if (found == m_watched.end())
        return std::nullopt;
    return dated(found->second.beforeGone ? found->second.beforeGone : found->second.last);
}

std::optional<SeenPosition> LastPositions::newest(Place number) const
{
    const auto found = m_watched.find(number);
    if (found == m_watched.end())
        return std::nullopt;
    return dated(found->second.last ? found->second.last : found->second.beforeGone);
}

std::optional<SeenPosition> LastPositions::dated(const std::optional<Seen> &seen) const
{
    if (!seen)
        return std::nullopt;
    return SeenPosition{seen->position, m_bus.dateTime(seen->at), seen->beforeItWent};
}

void LastPositions::look()
{
    const Instant now = m_bus.now();
    for (const Place number : m_bus.places()) {
        const EncoderSession *encoder = m_bus.encoder(number);
        if (encoder == nullptr)
            continue;
        Watched &watched = m_watched[number];
        const Reading &reading = encoder->latest();
        const bool isSeen = m_bus.isRunning() && reading.state == EncoderState::operation && reading.in != 0;
        if (watched.last && now - watched.lastAt >= untilGone) {
            watched.beforeGone = watched.last;
            watched.beforeGone->beforeItWent = true;
            watched.last.reset();
        }
        if (!isSeen || !reading.position)
            continue;
        watched.last = Seen{*reading.position, reading.at};
        watched.lastAt = now;
    }
}

std::optional<LastPosition> positionToKeep(const EncoderSession &encoder)
{
    const Reading &reading = encoder.latest();
    if (reading.state != EncoderState::operation || reading.in == 0 || !reading.position)
        return std::nullopt;
    return LastPosition{*reading.position, encoder.dateTime(reading.at).toUTC()};
}

Project withLastPositions(Project project, const LastPositions &positions, const BusSession &bus)
{
    const ProjectPlaces places(project, bus);
    for (ProjectDevice &device : project.devices) {
        if (!places.isAtItsPlace(device.place()))
            continue;
        if (const auto seen = positions.newest(device.place()))
            device.lastPosition = LastPosition{seen->position, seen->at.toUTC()};
    }
    return project;
}

} // namespace codewheel
