// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/simulator/simulated_slcan_adapter.h"
#include "tests/can/simulator/scripted_participant.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using namespace test;

class SlcanAdapterOnBus : public testing::Test
{
protected:
    // What is read after 10 ms, its ends of line shown as "|", and the bell as "!".
    std::string tell(const QByteArray &commands)
    {
        m_adapter.take(commands, m_now);
        return pass(10ms);
    }
    std::string pass(Instant time)
    {
        m_now += time;
        m_adapter.advance(m_now);
        QByteArray out = m_adapter.unfetched();
        m_adapter.fetched(out.size());
        return out.replace('\r', '|').replace('\a', '!').toStdString();
    }
    void nodeSends(const CanFrame &frame)
    {
        m_bus->locked([&] { m_node->waiting.push_back(frame); });
    }

    std::shared_ptr<SimulatedCanBus> m_bus = std::make_shared<SimulatedCanBus>();
    std::shared_ptr<ScriptedParticipant> m_node = join(*m_bus);
    std::shared_ptr<ScriptedParticipant> m_other = join(*m_bus); // acknowledges what the node sends
    SimulatedSlcanAdapter m_adapter{m_bus};
    Instant m_now{};
};

TEST_F(SlcanAdapterOnBus, CommandsAreAnsweredAsByLawicelsFirmware)
{
    const std::pair<const char *, const char *> rows[] = {
        {"V\r", "V1013|"},     {"N\r", "NCW01|"},
        {"C\r", "!"},                        // it is closed
        {"F\r", "!"},          {"O\r", "!"}, // it has no rate
        {"S9\r", "!"},         {"S4\r", "|"},
        {"t1230\r", "!"},      {"Z1\r", "|"},
        {"Z0\r", "|"},         {"Z2\r", "!"},
        {"O\r", "|"},          {"O\r", "!"},
        {"S4\r", "!"},         {"L\r", "!"},
        {"Z1\r", "!"},         {"F\r", "F00|"},
        {"t1232AABB\r", "z|"}, {"T000001230\r", "Z|"},
        {"r1238\r", "z|"},     {"R000001232\r", "Z|"},
        {"t1232AA\r", "!"}, // half of its data
        {"t8000\r", "!"},   // there is no such identifier
        {"X1\r", "!"},         {"\r", "|"},
        {"C\r", "|"},          {"L\r", "|"},
        {"t1230\r", "!"}, // it only listens
        {"C\rO\r", "||"},
    };
    for (const auto &[command, answer] : rows)
        EXPECT_EQ(tell(command), answer) << command;
}

TEST_F(SlcanAdapterOnBus, FramesPassBothWays)
{
    tell("S4\rO\r");
    tell("t1232AABB\rT000001230\rr1238\r");
    ASSERT_EQ(m_node->heard.size(), 3U);
    EXPECT_EQ(m_node->heard[0].frame.id, 0x123U);
    EXPECT_EQ(m_node->heard[0].frame.bytes[1], 0xBB);
    EXPECT_TRUE(m_node->heard[2].frame.isRemote || m_node->heard[1].frame.isRemote);
    nodeSends({.id = 0x185, .length = 2, .bytes = {0x88, 0x13}});
    nodeSends({.id = 0x12345, .isExtended = true, .isRemote = true, .length = 3});
    EXPECT_EQ(pass(10ms), "t18528813|R000123453|");
}

TEST_F(SlcanAdapterOnBus, AStampIsTheTimeOnTheBusAndBeginsAnewAfterAMinute)
{
    tell("S4\rZ1\rO\r");
    nodeSends({.id = 0x185});
    EXPECT_EQ(pass(10ms), "t1850000A|"); // the 10th ms
    pass(60s - m_now - 10ms);
    nodeSends({.id = 0x185});
    EXPECT_EQ(pass(100us), "");
    pass(9'900us);
    nodeSends({.id = 0x185});
    EXPECT_EQ(pass(10ms), "t18500000|");
}

TEST_F(SlcanAdapterOnBus, WhatOnlyListensAcknowledgesNothing)
{
    m_bus->locked([&] { m_other->on = false; });
    tell("S4\rL\r");
    nodeSends({.id = 0x185});
    pass(20ms);
    EXPECT_TRUE(m_node->done.empty());
    tell("C\rO\r");
    EXPECT_FALSE(m_node->done.empty());
}

TEST_F(SlcanAdapterOnBus, AnotherRateShowsInTheStatus)
{
    tell("S5\rO\r");
    nodeSends({.id = 0x185, .length = 8});
    pass(50ms);
    const std::string status = tell("F\r");
    EXPECT_EQ(status.substr(0, 1), "F");
    EXPECT_EQ(std::stoi(status.substr(1, 2), nullptr, 16) & 0x80, 0x80) << status; // a bus error
}

TEST_F(SlcanAdapterOnBus, WhatNobodyFetchesIsLostAsWholeFrames)
{
    tell("S4\rO\r");
    m_bus->locked([&] {
        for (int i = 0; i < 1'000; ++i)
            m_node->waiting.push_back({.id = 0x185, .length = 8});
    });
    for (int i = 0; i < 2'000; ++i)
        m_adapter.advance(m_now += 1ms);
    const QByteArray out = m_adapter.unfetched();
    EXPECT_LT(out.size(), SimulatedSlcanAdapter::mostUnfetched + 30);
    EXPECT_TRUE(out.endsWith("t18580000000000000000\r"));
    m_adapter.fetched(out.size());
    EXPECT_EQ(tell("F\r"), "F09|"); // queue full, overrun
    EXPECT_EQ(tell("F\r"), "F00|"); // told once
}

TEST_F(SlcanAdapterOnBus, AfterARestartItIsClosed)
{
    tell("S4\rZ1\rO\r");
    m_adapter.restart();
    EXPECT_EQ(tell("O\r"), "!");
    EXPECT_EQ(tell("S4\rO\r"), "||");
}

} // namespace
} // namespace codewheel
