// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ring/process_data_link.h"
#include "simulator/simulated_device.h"

#include <memory>
#include <mutex>
#include <vector>

namespace codewheel {

// A ring of simulated devices and the trainer's hand on them. Its clock is the exchange: one is 1 ms. Shared
// by the link (bus thread) and the training panel (any thread); one uncontended lock per cycle.
class SimulatedRing final : public TrainingControls
{
public:
    // Before the ring is used.
    void add(Participant participant, std::unique_ptr<SimulatedDevice> device);

    RingStructure structure() const { return m_structure; }
    std::vector<Word> lastOut() const;
    // Both of the size of the ring.
    void exchange(std::span<const Word> out, std::span<Word> in);

    std::vector<Shaft> shafts() const override;
    std::vector<Rod> rods() const override;
    void turnTo(DeviceNumber number, std::int64_t raw) override;
    void turnBy(DeviceNumber number, std::int64_t rawSteps) override;
    void setSpeed(DeviceNumber number, double revolutionsPerMinute) override;
    void moveMagnetTo(DeviceNumber number, double millimetres) override;
    void setMagnetSpeed(DeviceNumber number, double millimetresPerSecond) override;
    void setMagnetInRange(DeviceNumber number, bool inRange) override;
    void setPower(DeviceNumber number, bool on) override;
    void powerCycle(DeviceNumber number) override;
    void setSlow(DeviceNumber number, bool slow) override;
    void loseParameters(DeviceNumber number) override;
    void setBatteryLow(DeviceNumber number, bool low) override;
    void setEepromWornOut(DeviceNumber number, bool wornOut) override;
    void setCodeDiscFaulty(DeviceNumber number, bool faulty) override;

private:
    template <typename State>
    std::vector<State> states(std::optional<State> (SimulatedDevice::*stateOf)() const) const;
    template <typename Act>
    void with(DeviceNumber number, Act act);

    RingStructure m_structure;
    mutable std::mutex m_mutex; // guards all below
    std::vector<std::unique_ptr<SimulatedDevice>> m_devices;
    std::vector<Word> m_lastOut;
};

// The link to a simulated ring. Never blocks, so there is nothing to interrupt.
class SimulatedRingLink final : public ProcessDataLink
{
public:
    explicit SimulatedRingLink(std::shared_ptr<SimulatedRing> ring);

    Result<RingStructure> open() override;
    void close() override;
    Result<std::vector<Word>> readBackOut() override;
    // Refused (linkFailed) while it is not open, and for words that are not one per device.
    Result<void> exchange(std::span<const Word> out, std::span<Word> in) override;
    bool boundsWordsToCycles() const override { return true; }
    void interrupt() override {}

private:
    std::shared_ptr<SimulatedRing> m_ring;
    std::size_t m_devices;
    bool m_open = false;
};

} // namespace codewheel
