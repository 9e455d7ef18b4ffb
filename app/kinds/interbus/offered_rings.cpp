// SPDX-License-Identifier: GPL-3.0-or-later
#include "offered_rings.h"

namespace codewheel {
namespace {

constexpr std::chrono::milliseconds offeredCycle{1};

} // namespace

void OfferedRings::start(Ring &ring)
{
    ring.training.bus->offerTo(ring.guests);
    if (!ring.training.bus->open(EncoderBus::Start::operating)) // a simulated link always opens
        Q_UNREACHABLE();
    ring.training.bus->advance(1); // so that the first client finds it running
    ring.training.bus->startThread(offeredCycle);
}

void OfferedRings::start()
{
    for (Ring &ring : m_rings)
        start(ring);
}

void OfferedRings::pump()
{
    for (Ring &ring : m_rings)
        ring.training.bus->pump();
}

void OfferedRings::replace(std::size_t ring, TrainingSession training)
{
    Ring &its = m_rings.at(ring);
    its.training.bus->offerTo(nullptr);
    its.training.bus->close(); // its guests are told that it has gone
    its.training = std::move(training);
    start(its);
}

ServedUnits OfferedRings::units(ServedUnits::Writing writing) const
{
    std::map<int, std::shared_ptr<RingGuests>> units;
    for (std::size_t i = 0; i < m_rings.size(); ++i)
        units[static_cast<int>(i) + 1] = m_rings[i].guests;
    return ServedUnits(units, writing);
}

} // namespace codewheel
