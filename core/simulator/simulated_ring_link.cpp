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

void SimulatedRingLink::idleCycle()
{
    m_ring->idleCycle();
}

Result<MasterLink::IdCycle> SimulatedRingLink::createConfiguration()
{
    m_ring->idleCycle();
    return m_ring->withMaster([](SimulatedMaster &master) { return master.createConfiguration(); });
}

Result<RingStructure> SimulatedRingLink::activateConfiguration()
{
    return m_ring->withMaster([](SimulatedMaster &master) { return master.activateConfiguration(); });
}

Result<void> SimulatedRingLink::deactivateConfiguration()
{
    return m_ring->withMaster([](SimulatedMaster &master) { return master.deactivateConfiguration(); });
}

Result<void> SimulatedRingLink::startDataTransfer()
{
    return m_ring->withMaster([](SimulatedMaster &master) { return master.startDataTransfer(); });
}

Result<void> SimulatedRingLink::stopDataTransfer()
{
    return m_ring->withMaster([](SimulatedMaster &master) { return master.stopDataTransfer(); });
}

void SimulatedRingLink::alarmStop()
{
    m_ring->withMaster([](SimulatedMaster &master) { master.alarmStop(); });
}

Result<void> SimulatedRingLink::switchSegment(int segment, bool on)
{
    return m_ring->withMaster(
        [segment, on](SimulatedMaster &master) { return master.switchSegment(segment, on); });
}

Result<void> SimulatedRingLink::confirmDiagnostics()
{
    return m_ring->withMaster([](SimulatedMaster &master) { return master.confirmDiagnostics(); });
}

Result<void> SimulatedRingLink::keepConfiguration(const KeptConfiguration &configuration)
{
    return m_ring->withMaster(
        [&configuration](SimulatedMaster &master) { return master.keepConfiguration(configuration); });
}

Result<KeptConfiguration> SimulatedRingLink::keptConfiguration()
{
    return m_ring->withMaster([](const SimulatedMaster &master) { return master.keptConfiguration(); });
}

} // namespace codewheel
