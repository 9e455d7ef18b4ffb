// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/simulated_ring_link.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

tl::unexpected<Refusal> notConnected()
{
    return refuse(RefusalKind::link, RefusalId::linkFailed,
                  {QCoreApplication::translate("SimulatedRing", "The training bus is not connected.")});
}

} // namespace

SimulatedRingLink::SimulatedRingLink(std::shared_ptr<SimulatedRing> ring)
    : m_ring(std::move(ring))
{}

Result<RingStructure> SimulatedRingLink::open()
{
    m_open = true;
    m_lastCycle = m_now;
    return m_ring->structure();
}

Result<std::vector<Word>> SimulatedRingLink::readBackOut()
{
    if (!m_open)
        return notConnected();
    return m_ring->lastOut();
}

Result<void> SimulatedRingLink::exchange(std::span<const Word> out, std::span<Word> in)
{
    if (!m_open)
        return notConnected();
    passTime();
    return m_ring->exchange(out, in);
}

// A cycle is 1 ms: any time beyond that on the clock was seen by no cycle.
void SimulatedRingLink::passTime()
{
    using std::chrono::milliseconds;
    const auto missed = std::chrono::floor<milliseconds>(m_now - m_lastCycle) - milliseconds(1);
    m_lastCycle = m_now;
    if (missed.count() > 0)
        m_ring->missCycles(missed);
}

} // namespace codewheel
