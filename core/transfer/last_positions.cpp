// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/last_positions.h"

#include "ring/bus_session.h"

namespace codewheel {

LastPositions::LastPositions(BusSession &bus, QObject *parent)
    : QObject(parent)
    , m_bus(bus)
{
    connect(&bus, &BusSession::updated, this, &LastPositions::look);
    look();
}

std::optional<SeenPosition> LastPositions::at(DeviceNumber number) const
{
    const auto found = m_watched.find(number);
    if (found == m_watched.end())
        return std::nullopt;
    return found->second.beforeGone ? found->second.beforeGone : found->second.last;
}

void LastPositions::look()
{
    const Instant now = m_bus.latest().at;
    for (const DeviceNumber number : m_bus.numbers()) {
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
        watched.last = SeenPosition{*reading.position, m_bus.dateTime(reading.at)};
        watched.lastAt = now;
    }
}

} // namespace codewheel
