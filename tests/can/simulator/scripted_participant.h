// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/simulator/simulated_can_bus.h"

#include <algorithm>
#include <deque>

namespace codewheel::test {

struct Script
{
    int bitRate = 125'000;
    bool on = true;
    bool onlyListens = false;
    bool returns = true; // after bus off
    std::deque<CanFrame> waiting{};
    std::optional<Instant> later{}; // when it begins to send
};

// A participant that sends what it is given, and keeps what happens to it.
struct ScriptedParticipant final : CanParticipant, Script
{
    struct Heard
    {
        CanFrame frame;
        Instant at{};
    };

    explicit ScriptedParticipant(Script script)
        : Script(std::move(script))
    {}

    std::vector<Heard> heard{};
    std::vector<Heard> done{};
    std::vector<CanDisturbance> disturbances{};
    std::vector<CanState> states{};

    bool isOn() const override { return on; }
    int rate() const override { return bitRate; }
    bool acknowledges() const override { return !onlyListens; }
    bool comesBack() const override { return returns; }
    const CanFrame *toSend() const override { return waiting.empty() || later ? nullptr : &waiting.front(); }
    void sent(const CanFrame &frame, Instant now) override
    {
        waiting.pop_front();
        done.push_back({frame, now});
    }
    void take(const CanFrame &frame, Instant now) override { heard.push_back({frame, now}); }
    void disturbed(CanDisturbance how, Instant /*now*/) override { disturbances.push_back(how); }
    void stateChanged(CanState state, Instant /*now*/) override { states.push_back(state); }
    std::optional<Instant> wakesAt() const override { return later; }
    void proceed(Instant /*now*/) override { later.reset(); }
};

inline std::shared_ptr<ScriptedParticipant> join(SimulatedCanBus &bus, Script script = {})
{
    auto joined = std::make_shared<ScriptedParticipant>(std::move(script));
    bus.add(joined);
    return joined;
}

inline std::vector<std::uint32_t> idsOf(const std::vector<ScriptedParticipant::Heard> &heard)
{
    std::vector<std::uint32_t> ids;
    std::ranges::transform(heard, std::back_inserter(ids), [](const auto &each) { return each.frame.id; });
    return ids;
}

} // namespace codewheel::test
