// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/simulated_ring_link.h"

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
    return m_ring->structure();
}

void SimulatedRingLink::close()
{
    m_open = false;
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
    return m_ring->exchange(out, in);
}

} // namespace codewheel
