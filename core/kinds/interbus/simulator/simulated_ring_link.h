// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/master_link.h"
#include "kinds/interbus/ring/process_data_link.h"
#include "kinds/interbus/simulator/simulated_ring.h"

#include <algorithm>
#include <memory>

namespace codewheel {

// The link to a simulated ring and its master, in virtual time. Never blocks, so there is nothing to
// interrupt. Ring and master stay as they are when the link is closed.
class SimulatedRingLink final : public ProcessDataLink, private MasterLink
{
public:
    explicit SimulatedRingLink(std::shared_ptr<SimulatedRing> ring);

    Result<RingStructure> open() override;
    void close() override { m_open = false; }
    Result<std::vector<Word>> readBackOut() override;
    // Refused (linkFailed) while it is not open, and if there is not one word per device.
    Result<void> exchange(std::span<const Word> out, std::span<Word> in) override;
    Instant now() const override { return m_now; }
    void wait(Instant until) override { m_now = std::max(m_now, until); }
    bool boundsWordsToCycles() const override { return true; }
    bool isSimulated() const override { return true; }
    void interrupt() override {}
    MasterLink *master() override { return this; }

private:
    const MasterStatus &status() const override { return m_ring->master().status(); }
    std::uint64_t statusChanges() const override { return m_ring->master().statusChanges(); }
    void idleCycle() override
    {
        passTime();
        m_ring->idleCycle();
    }
    Result<IdCycle> createConfiguration() override
    {
        idleCycle();
        return m_ring->withMaster(&SimulatedMaster::createConfiguration);
    }
    Result<RingStructure> activateConfiguration() override
    {
        return m_ring->withMaster(&SimulatedMaster::activateConfiguration);
    }
    Result<void> deactivateConfiguration() override
    {
        return m_ring->withMaster(&SimulatedMaster::deactivateConfiguration);
    }
    Result<void> startDataTransfer() override
    {
        return m_ring->withMaster(&SimulatedMaster::startDataTransfer);
    }
    Result<void> stopDataTransfer() override
    {
        return m_ring->withMaster(&SimulatedMaster::stopDataTransfer);
    }
    void alarmStop() override { m_ring->withMaster(&SimulatedMaster::alarmStop); }
    Result<void> switchSegment(int segment, bool on) override
    {
        return m_ring->withMaster(&SimulatedMaster::switchSegment, segment, on);
    }
    Result<void> confirmDiagnostics() override
    {
        return m_ring->withMaster(&SimulatedMaster::confirmDiagnostics);
    }
    Result<void> keepConfiguration(const KeptConfiguration &configuration) override
    {
        return m_ring->withMaster(&SimulatedMaster::keepConfiguration, configuration);
    }
    Result<KeptConfiguration> keptConfiguration() override
    {
        return m_ring->withMaster(&SimulatedMaster::keptConfiguration);
    }

    void passTime();

    std::shared_ptr<SimulatedRing> m_ring;
    Instant m_now{};
    Instant m_lastCycle{};
    bool m_open = false;
};

} // namespace codewheel
