// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/simulator/simulated_can_adapter.h"
#include "can/simulator/simulated_can_bus.h"

namespace codewheel {

// The link to a simulated CAN bus. Without a clock its time is virtual, that of the bus: it passes only in
// receive() and wait(), which return at once, receive() with one frame after another. With a clock, it keeps
// to its time and waits.
class SimulatedCanLink final : public CanLink
{
public:
    using Clock = std::function<Instant()>; // with any starting point; never goes back

    explicit SimulatedCanLink(std::shared_ptr<SimulatedCanBus> bus, int rate = 125'000, Clock clock = {});
    ~SimulatedCanLink() override;
    SimulatedCanLink(const SimulatedCanLink &) = delete;
    SimulatedCanLink &operator=(const SimulatedCanLink &) = delete;

    Result<void> open(CanUse use) override;
    void close() override;
    Instant now() const override { return m_clock ? m_clock() - m_begin : m_bus->now() - m_busBegin; }
    void wait(Instant until) override { passTime(until, false); }
    Result<CanNews> receive(Instant until) override;
    // In bus off it takes what it is given, and refuses it.
    Result<bool> send(const CanFrame &frame) override;
    CanStatus status() const override;
    QString name() const override;
    bool isSimulated() const override { return true; }
    void interrupt() override { m_adapter->wake(); }

    // For the trainer, who may keep it longer than the link is there: what is plugged in, and its counters.
    std::shared_ptr<SimulatedCanAdapter> adapter() const { return m_adapter; }

private:
    Result<void> usable();
    void passTime(Instant until, bool upToNews);

    std::shared_ptr<SimulatedCanBus> m_bus;
    const Clock m_clock;
    const Instant m_begin;    // on the clock
    const Instant m_busBegin; // on the bus
    std::shared_ptr<SimulatedCanAdapter> m_adapter;
    bool m_open = false;
};

} // namespace codewheel
