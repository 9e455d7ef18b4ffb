// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_bridge.h"
#include "can/simulator/simulated_can_link.h"
#include "tests/can/simulator/scripted_participant.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using namespace test;

struct Bridged
{
    std::shared_ptr<SimulatedCanBus> farBus = std::make_shared<SimulatedCanBus>();
    std::shared_ptr<SimulatedCanBus> nearBus = std::make_shared<SimulatedCanBus>();
    std::shared_ptr<ScriptedParticipant> master = join(*farBus);
    std::shared_ptr<ScriptedParticipant> node = join(*nearBus);
    SimulatedCanLink far{farBus};
    SimulatedCanLink near{nearBus, 125'000, [this] { return farBus->now(); }};
    CanBridge bridge{far, near};

    Bridged()
    {
        EXPECT_TRUE(far.open(CanUse::operate));
        EXPECT_TRUE(near.open(CanUse::operate));
    }
    void pass(Instant time)
    {
        for (const Instant end = far.now() + time; far.now() < end;)
            ASSERT_TRUE(bridge.carry(1ms));
    }
};

std::vector<std::uint32_t> idsHeardBy(const ScriptedParticipant &participant)
{
    std::vector<std::uint32_t> ids;
    for (const auto &heard : participant.heard)
        ids.push_back(heard.frame.id);
    return ids;
}

TEST(CanBridge, FramesPassBothWaysInTheirOrder)
{
    Bridged both;
    for (std::uint32_t id = 0x601; id < 0x603; ++id)
        both.master->waiting.push_back({.id = id, .length = 1, .bytes = {7}});
    both.node->waiting.push_back({.id = 0x701, .length = 1});
    both.pass(20ms);
    EXPECT_EQ(idsHeardBy(*both.node), (std::vector<std::uint32_t>{0x601, 0x602}));
    EXPECT_EQ(both.node->heard.front().frame.bytes[0], 7);
    EXPECT_EQ(idsHeardBy(*both.master), std::vector<std::uint32_t>{0x701});
}

// The adapter takes 16 frames at once.
TEST(CanBridge, WhatDoesNotFitAtOnceFollows)
{
    Bridged both;
    for (std::uint32_t id = 0; id < 100; ++id)
        both.master->waiting.push_back({.id = id, .length = 8});
    both.pass(500ms);
    EXPECT_EQ(both.node->heard.size(), 100U);
    EXPECT_EQ(both.bridge.lost(), 0U);
}

TEST(CanBridge, ItEndsWithItsLink)
{
    Bridged both;
    both.far.adapter()->setUnplugged(true);
    EXPECT_FALSE(both.bridge.carry(1ms));
}

} // namespace
} // namespace codewheel
