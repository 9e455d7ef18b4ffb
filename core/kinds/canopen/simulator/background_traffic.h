// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/simulator/can_participant.h"

#include <deque>

namespace codewheel::canopen {

// What goes on beside the encoders of a simulated bus.
struct BackgroundPlan
{
    static constexpr int highestLoad = 95;

    int load = 0;           // of the bus, in percent: PDOs and heartbeats of devices that are no encoders
    bool hasMaster = false; // that sends SYNC, and asks one of those devices

    bool isAny() const { return load > 0 || hasMaster; }

    friend bool operator==(const BackgroundPlan &, const BackgroundPlan &) = default;
};

// The other devices of a plant, as one participant: three that are no encoders, nodes 110 to 112, and a
// master.
class BackgroundTraffic final : public CanParticipant
{
public:
    explicit BackgroundTraffic(int rate)
        : m_rate(rate)
    {}

    void set(const BackgroundPlan &plan);
    const BackgroundPlan &plan() const { return m_plan; }

    bool isOn() const override { return m_plan.isAny(); }
    int rate() const override { return m_rate; }
    const CanFrame *toSend() const override { return m_waiting.empty() ? nullptr : &m_waiting.front(); }
    void sent(const CanFrame &frame, Instant now) override;
    void take(const CanFrame & /*frame*/, Instant /*now*/) override {}
    std::optional<Instant> wakesAt() const override;
    void proceed(Instant now) override;

private:
    void addHeartbeats();
    void addMastersFrames();
    void addPdo();

    int m_rate;
    BackgroundPlan m_plan;
    std::deque<CanFrame> m_waiting;
    Instant m_beatAt{};
    Instant m_syncAt{};
    Instant m_pdoAt{}; // earlier its share of the bus is used up
    unsigned m_pdos = 0;
    unsigned m_syncs = 0;
};

} // namespace codewheel::canopen
