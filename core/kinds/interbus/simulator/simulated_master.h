// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/master_link.h"
#include "kinds/interbus/simulator/ring_wiring.h"

#include <cstdint>
#include <set>

namespace codewheel {

// Decides which data cycles are faulty: as many as requested, at moments that look random but are the same in
// every run. Used by SimulatedMaster.
class SegmentErrors
{
public:
    // Per 1000 cycles. To be called once per cycle and segment.
    bool strikes(int perThousand)
    {
        // Knuth's MMIX generator; its upper bits are good enough for this.
        m_random = m_random * 6'364'136'223'846'793'005U + 1'442'695'040'888'963'407U;
        return static_cast<int>((m_random >> 33) % 1'000) < perThousand;
    }

private:
    std::uint64_t m_random = 1;
};

// The master of a simulated ring: READY, ACTIVE, RUN, BUS FAIL with their status bits and diagnostic
// parameter, the search for a fault, and the configuration it stores. Knows the ring only by its wiring; what
// is assumed about it is in docs/protocols/master.md. Used by SimulatedRing, whose cycles drive it.
class SimulatedMaster
{
public:
    // Error codes of this master that the program only shows as numbers.
    static constexpr std::uint16_t deviceMissing = 0x0C10;
    static constexpr std::uint16_t wrongIdCode = 0x0C40;
    static constexpr std::uint16_t remoteBusBroken = 0x0D10;
    static constexpr std::uint16_t localBusBroken = 0x0D50;
    static constexpr int lookingCycles = 20; // to find the place of a fault
    // Faulty data cycles since the start, or since they were confirmed, above which QUALITY is set.
    static constexpr std::uint32_t tolerableCrcErrors = 20;

    // The wiring must outlive the master.
    explicit SimulatedMaster(const RingWiring &wiring);

    // Switched on and running, with the ring as it is: for the ring, once all devices are there.
    void powerUp();
    void keep(const QString &fileName); // the current configuration

    const MasterStatus &status() const { return m_status; }
    std::uint64_t statusChanges() const { return m_changes; }
    const RingStructure &configuration() const { return m_configuration; } // created or loaded last
    // The places in the ring of the configured devices.
    const std::vector<std::size_t> &places() const { return m_places; }
    bool takesPart(std::size_t device) const { return m_status.devices[device].inRing; }
    bool isWhole() const { return m_isWhole; } // all of the ring takes part

    // Each bus cycle, data or not: looks at the ring, goes on looking for a fault.
    void cycle()
    {
        if (m_looking > 0 || m_seen != m_wiring.changes())
            look();
    }
    bool runs() const { return m_status.state == MasterState::run; }
    // Outputs are held while the configuration is active, otherwise they are 0.
    bool holdsOutputs() const { return runs() || m_status.state == MasterState::active; }
    // Of the current data cycle, whose words are then discarded.
    bool isCycleFaulty();

    // The services of MasterLink.
    Result<MasterLink::IdCycle> createConfiguration();
    Result<RingStructure> activateConfiguration();
    Result<void> deactivateConfiguration();
    Result<void> startDataTransfer();
    Result<void> stopDataTransfer();
    void alarmStop();
    Result<void> switchSegment(int segment, bool on);
    Result<void> confirmDiagnostics();
    Result<void> keepConfiguration(const KeptConfiguration &configuration);
    Result<KeptConfiguration> keptConfiguration() const;

private:
    struct Defect
    {
        std::size_t device = 0; // of the configuration
        std::uint16_t code = 0;
        std::uint16_t parameter = 0;

        friend bool operator==(const Defect &, const Defect &) = default;
    };

    void use(RingStructure configuration, std::vector<std::size_t> places);
    std::vector<bool> stillReported(const RingStructure &configuration,
                                    const std::vector<std::size_t> &places) const;
    void look();
    void lookForPlace();
    void lookAtPeripherals();
    void fail();
    void enter(MasterState state);
    void publish();
    void showWhoTakesPart();
    std::uint16_t statusBits() const;
    bool isSwitchedOff(std::size_t device) const;
    std::optional<Defect> defect() const;
    Defect brokenBefore(std::size_t device) const;
    RingStructure foundAt(const std::vector<std::size_t> &places) const;
    void useLoaded();
    Result<void> checkRing() const;

    const RingWiring &m_wiring;
    MasterStatus m_status;
    std::uint64_t m_changes = 0;
    std::uint64_t m_seen = 0; // RingWiring::changes()

    RingStructure m_configuration;
    std::vector<std::size_t> m_places;
    bool m_isWhole = true;
    std::set<int> m_off; // segments
    std::optional<KeptConfiguration> m_kept;
    std::optional<RingStructure> m_loaded; // to be activated by the next 0711
    std::size_t m_found = 0;               // devices, by the ID cycles of 0710

    int m_looking = 0; // cycles until the place of the fault is known; 0: not looking
    std::optional<Defect> m_located;
    std::vector<bool> m_peripheral; // reported, until it is confirmed
    SegmentErrors m_errors;
    std::uint32_t m_toleratedCrcErrors = 0; // counted towards QUALITY
};

} // namespace codewheel
