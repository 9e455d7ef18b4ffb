// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/node_watch.h"
#include "tests/kinds/canopen/protocol/frame_literal.h"

#include <gtest/gtest.h>

using namespace std::chrono_literals;

namespace codewheel::canopen {
namespace {

class NodeWatchTest : public ::testing::Test
{
protected:
    NodeWatch watch{5};
    Instant now = 10s;

    void comes(std::string_view text)
    {
        CanFrame frame = frameFrom(text);
        frame.time = now;
        watch.take(frame, now);
    }
    void beatsFor(Instant duration, Instant each, std::string_view frame = "705# 05")
    {
        for (const Instant end = now + duration; now < end; now += each)
            comes(frame);
    }
};

TEST_F(NodeWatchTest, StatesAreThoseThatTheNodeShows)
{
    EXPECT_FALSE(watch.state());
    comes("705# 7F");
    EXPECT_EQ(watch.state(), NmtState::preOperational);
    comes("705# 05");
    EXPECT_EQ(watch.state(), NmtState::operational);
    comes("706# 04"); // another node
    EXPECT_EQ(watch.state(), NmtState::operational);
    comes("705# 04");
    EXPECT_EQ(watch.state(), NmtState::stopped);
}

// Some start by themselves behind it.
TEST_F(NodeWatchTest, AfterBootUpTheStateIsNotKnownUntilTheNodeShowsItOrIsCommanded)
{
    EXPECT_FALSE(watch.hasBooted());
    int bootUps = 0;
    for (const auto &[told, state] :
         {std::pair("185# 88 13 00 00", NmtState::operational), std::pair("705# 05", NmtState::operational),
          std::pair("705# 7F", NmtState::preOperational), std::pair("705# 04", NmtState::stopped)}) {
        comes("705# 05");
        comes("705# 00");
        EXPECT_EQ(watch.bootUps(), ++bootUps);
        EXPECT_FALSE(watch.state());
        EXPECT_TRUE(watch.hasBooted());
        comes("205# 00"); // to the node
        EXPECT_FALSE(watch.state());
        comes(told);
        EXPECT_EQ(watch.state(), state);
        EXPECT_FALSE(watch.hasBooted());
    }
    comes("705# 00");
    comes("000# 80 05");
    EXPECT_FALSE(watch.hasBooted());
    EXPECT_EQ(watch.commandedState(), NmtState::preOperational);
}

TEST_F(NodeWatchTest, PdosMayHaveOtherIdentifiers)
{
    watch.setTpdos({0x1A7});
    comes("185# 88 13 00 00");
    EXPECT_FALSE(watch.state());
    comes("1A7# 88 13 00 00");
    EXPECT_EQ(watch.state(), NmtState::operational);
}

TEST_F(NodeWatchTest, ACommandIsNoState)
{
    comes("705# 05");
    comes("000# 02 06");
    EXPECT_EQ(watch.state(), NmtState::operational);
    comes("000# 02 00");
    EXPECT_FALSE(watch.state());
    EXPECT_EQ(watch.command(), NmtCommand::stop);
    CanFrame underWay = frameFrom("185# 88 13 00 00");
    underWay.time = now - 1us;
    watch.take(underWay, now);
    EXPECT_FALSE(watch.state());
    comes("705# 04");
    EXPECT_EQ(watch.state(), NmtState::stopped);
    EXPECT_FALSE(watch.command());
}

TEST_F(NodeWatchTest, AStoppedNodeIsStoppedUntilItShowsSomethingElse)
{
    EXPECT_FALSE(watch.isStopped());
    for (const char *told : {"705# 7F", "705# 00", "185# 88 13 00 00", "000# 01 05"}) {
        comes("000# 02 00");
        now += 1s;
        EXPECT_TRUE(watch.isStopped());
        comes(told);
        EXPECT_FALSE(watch.isStopped()) << told;
        comes("705# 04");
        now += 1s;
        EXPECT_TRUE(watch.isStopped());
        comes(told);
        EXPECT_FALSE(watch.isStopped()) << told;
    }
    comes("605# 40 04 60 00 ..");
    now += 1ms;
    comes("000# 02 05");
    now += 1ms;
    comes("185# 88 13 00 00"); // both were under way
    comes("585# 43 04 60 00 88 13 00 00");
    EXPECT_TRUE(watch.isStopped());
    EXPECT_EQ(watch.command(), NmtCommand::stop);
    watch.forget();
    EXPECT_TRUE(watch.isStopped()) << "the link was lost, not the node";
    comes("605# 40 04 60 00 ..");
    now += 1ms;
    comes("585# 43 04 60 00 88 13 00 00");
    EXPECT_FALSE(watch.isStopped());
}

TEST_F(NodeWatchTest, PdosCountSinceTheNodeWasLastOperational)
{
    EXPECT_FALSE(watch.pdoAt());
    for (const char *end : {"000# 02 05", "000# 80 00", "000# 81 05", "705# 7F", "705# 04", "705# 00"}) {
        comes("000# 01 05");
        now += 1s;
        comes("185# 88 13 00 00");
        EXPECT_EQ(watch.pdoAt(), now);
        comes("705# 05");
        EXPECT_TRUE(watch.pdoAt());
        comes(end);
        EXPECT_FALSE(watch.pdoAt()) << end;
    }
}

TEST_F(NodeWatchTest, WhatItWasToldToIsKnownUntilItShowsItself)
{
    comes("000# 02 05");
    EXPECT_EQ(watch.commandedState(), NmtState::stopped);
    comes("000# 80 05");
    EXPECT_EQ(watch.commandedState(), NmtState::preOperational);
    comes("000# 01 05");
    EXPECT_EQ(watch.commandedState(), NmtState::operational);
    comes("705# 05");
    EXPECT_FALSE(watch.commandedState());
    comes("000# 81 05");
    EXPECT_FALSE(watch.commandedState());
}

TEST_F(NodeWatchTest, AHeartbeatIsLateAndThenLost)
{
    watch.setProducerTime(100ms, now);
    EXPECT_EQ(watch.heartbeat(now + 1h), Heartbeat::notHeard);
    EXPECT_FALSE(watch.wakesAt(now));
    comes("705# 05");
    EXPECT_EQ(watch.heartbeat(now + 150ms), Heartbeat::present);
    EXPECT_EQ(watch.wakesAt(now), now + 150ms + 1us);
    EXPECT_EQ(watch.heartbeat(now + 150ms + 1us), Heartbeat::late);
    EXPECT_EQ(watch.wakesAt(now + 151ms), now + 300ms + 1us);
    EXPECT_EQ(watch.heartbeat(now + 300ms + 1us), Heartbeat::lost);
    EXPECT_FALSE(watch.wakesAt(now + 301ms));
    now += 400ms;
    comes("705# 05");
    EXPECT_EQ(watch.heartbeat(now), Heartbeat::present);
    comes("705# 00");
    EXPECT_EQ(watch.heartbeat(now + 1h), Heartbeat::notHeard);
}

TEST_F(NodeWatchTest, NoHeartbeatIsMissedWhileTheNodeStores)
{
    watch.setProducerTime(100ms, now);
    comes("705# 05");
    watch.setMayBeSilent(true, now);
    now += 5s;
    EXPECT_EQ(watch.heartbeat(now), Heartbeat::present);
    EXPECT_FALSE(watch.wakesAt(now));
    watch.setMayBeSilent(false, now);
    EXPECT_EQ(watch.heartbeat(now + 150ms), Heartbeat::present);
    EXPECT_EQ(watch.heartbeat(now + 301ms), Heartbeat::lost);
}

TEST_F(NodeWatchTest, WithoutProducerTimeNothingIsMissed)
{
    EXPECT_EQ(watch.heartbeat(now), Heartbeat::notHeard);
    comes("705# 05");
    EXPECT_EQ(watch.heartbeat(now + 1h), Heartbeat::heard);
    watch.setProducerTime(0ms, now);
    EXPECT_EQ(watch.heartbeat(now + 1h), Heartbeat::heard);
}

TEST_F(NodeWatchTest, GuardingOfAnotherMasterIsNoHeartbeat)
{
    watch.setProducerTime(100ms, now);
    comes("705#R");
    comes("705# 05");
    comes("705#R");
    comes("705# 85");
    EXPECT_EQ(watch.state(), NmtState::operational);
    EXPECT_EQ(watch.heartbeat(now + 1h), Heartbeat::notHeard);
    comes("705# 00");
    EXPECT_EQ(watch.bootUps(), 1);
    comes("705# 05");
    EXPECT_EQ(watch.heartbeat(now + 1h), Heartbeat::lost) << "guarding has ended";
}

TEST_F(NodeWatchTest, ErrorsStandUntilTheyAreGone)
{
    comes("085# 10 42 09 00 00 00 00 00"); // temperature
    comes("085# 20 81 11 00 00 00 00 00"); // communication
    comes("085# 00 FF 81 01 02 03 04 05"); // of the maker
    comes("085# 10 42 09");                // no EMCY
    comes("086# 10 42 09 00 00 00 00 00"); // another node
    ASSERT_EQ(watch.errors().size(), 3);
    EXPECT_EQ(watch.errors().back().ofMaker[0], 1);
    EXPECT_EQ(watch.standing().size(), 3);
    comes("085# 00 00 91 00 00 00 00 00"); // the temperature is well again
    ASSERT_EQ(watch.standing().size(), 2);
    EXPECT_EQ(watch.standing()[0].code, 0x8120);
    comes("085# 00 FF 81 01 02 03 04 05");
    EXPECT_EQ(watch.standing().size(), 2);
    EXPECT_EQ(watch.errors().size(), 4);
    comes("085# 00 00 00 00 00 00 00 00");
    EXPECT_TRUE(watch.standing().empty());
    for (int each = 0; each < 100; ++each)
        comes("085# 00 FF 81 00 00 00 00 00");
    EXPECT_EQ(watch.errors().size(), NodeWatch::mostErrors);
}

TEST_F(NodeWatchTest, TwoAnswersToEachRequestAreTwoNodes)
{
    for (int each = 0; each < 3; ++each) {
        EXPECT_FALSE(watch.isDoubled());
        comes("605# 40 04 60 00 ..");
        comes("585# 43 04 60 00 88 13 00 00");
        comes("585# 43 04 60 00 88 13 00 00");
    }
    EXPECT_EQ(watch.secondAnswers(), 3);
    EXPECT_TRUE(watch.isDoubled());
}

// A node that answers late goes on answering what has timed out, was given up or was asked before its
// boot-up.
TEST_F(NodeWatchTest, LateAnswersAreOfOneNode)
{
    constexpr int many = 20;
    for (int each = 0; each < many; ++each) {
        comes("605# 40 04 60 00 ..");
        now += 500ms;
    }
    comes("605# 80 04 60 00 00 00 04 05");
    comes("705# 00");
    for (int each = 0; each < many; ++each) {
        now += 300ms;
        comes("585# 43 04 60 00 88 13 00 00");
    }
    EXPECT_EQ(watch.secondAnswers(), 0);
    EXPECT_FALSE(watch.isDoubled());
    comes("605# 40 04 60 00 .."); // gets no answer
    comes("605# 40 05 65 00 ..");
    comes("585# 4B 05 65 00 00 00 00 00");
    comes("585# 43 04 60 00 88 13 00 00");
    EXPECT_EQ(watch.secondAnswers(), 1) << "it answers in turn";
    comes("605# 40 04 60 00 ..");
    now += 11s;
    comes("605# 40 04 60 00 ..");
    comes("585# 43 04 60 00 88 13 00 00");
    comes("585# 43 04 60 00 88 13 00 00");
    EXPECT_EQ(watch.secondAnswers(), 2) << "nothing is that late";
}

// A log may have been made where only answers are heard.
TEST_F(NodeWatchTest, AnswersWithoutAnyRequestAreOfOneNode)
{
    for (int each = 0; each < 5; ++each) {
        comes("585# 43 04 60 00 88 13 00 00");
        comes("585# 43 04 60 00 89 13 00 00");
    }
    EXPECT_EQ(watch.secondAnswers(), 0);
    EXPECT_FALSE(watch.isDoubled());
}

TEST_F(NodeWatchTest, ASecondAnswerThatSaysSomethingElseIsOfAnotherNode)
{
    for (const char *other : {"585# 43 04 60 00 11 00 00 00", "585# 80 04 60 00 00 00 02 06"}) {
        comes("605# 40 04 60 00 ..");
        comes("585# 43 04 60 00 88 13 00 00");
        EXPECT_FALSE(watch.isDoubled());
        comes(other);
        EXPECT_TRUE(watch.isDoubled()) << other;
        for (int each = 0; each < 3; ++each) {
            comes("605# 40 04 60 00 ..");
            comes("585# 43 04 60 00 88 13 00 00");
        }
        EXPECT_FALSE(watch.isDoubled()) << "one has gone";
        comes("605# 40 04 60 00 ..");
        comes("585# 43 04 60 00 88 13 00 00");
        comes("605# 40 05 65 00 ..");
        comes(other);
        EXPECT_TRUE(watch.isDoubled()) << "after the next request " << other;
        for (int each = 0; each < 4; ++each) {
            comes("605# 40 04 60 00 ..");
            comes("585# 43 04 60 00 88 13 00 00");
        }
    }
    comes("605# 40 04 60 00 ..");
    comes("605# 40 04 60 00 .."); // repeated, as nothing has come
    comes("585# 43 04 60 00 88 13 00 00");
    comes("585# 43 04 60 00 11 00 00 00");
    EXPECT_FALSE(watch.isDoubled());
}

TEST_F(NodeWatchTest, TwoStatesInTurnAreTwoNodes)
{
    comes("705# 7F");
    now += 100ms;
    comes("705# 05"); // one node may have been started
    now += 900ms;
    EXPECT_FALSE(watch.isDoubled());
    comes("705# 7F");
    EXPECT_TRUE(watch.isDoubled());
    beatsFor(5s, 1s);
    EXPECT_FALSE(watch.isDoubled());
    comes("000# 80 05");
    comes("705# 7F");
    comes("000# 01 05");
    comes("705# 05");
    EXPECT_FALSE(watch.isDoubled()) << "it was told to";
}

TEST_F(NodeWatchTest, TwoBootUpsAtOnceAreTwoNodes)
{
    comes("705# 00");
    now += 600ms;
    comes("705# 00");
    EXPECT_FALSE(watch.isDoubled());
    comes("000# 81 05");
    comes("705# 00");
    EXPECT_FALSE(watch.isDoubled());
    now += 20ms;
    comes("705# 00");
    EXPECT_TRUE(watch.isDoubled());
}

TEST_F(NodeWatchTest, ABootUpBehindAResetWasAskedFor)
{
    comes("705# 00");
    EXPECT_EQ(watch.unaskedBootUps(), 1);
    for (const char *reset : {"000# 81 05", "000# 82 05", "000# 81 00"}) {
        comes(reset);
        now += 10s; // it takes its time
        comes("705# 00");
    }
    EXPECT_EQ(watch.unaskedBootUps(), 1);
    now += 10s;
    comes("000# 81 06");
    now += 100ms;
    comes("705# 00"); // it was node 6 until then
    EXPECT_EQ(watch.unaskedBootUps(), 1);
    comes("000# 81 05");
    now += 10s;
    comes("705# 05"); // its boot-up was not heard
    now += 10s;
    comes("705# 00");
    EXPECT_EQ(watch.unaskedBootUps(), 2);
    watch.mayBeReset({NmtCommand::resetNode, 5}, now); // and it is not known yet that this has gone out
    comes("705# 00");
    EXPECT_EQ(watch.unaskedBootUps(), 2);
    EXPECT_EQ(watch.bootUps(), 7);
}

TEST_F(NodeWatchTest, ADoubledFrameNowAndThenIsNoSecondNode)
{
    for (int each = 0; each < 100; ++each) {
        comes("605# 40 04 60 00 ..");
        comes("585# 43 04 60 00 88 13 00 00");
        if (each % 10 == 0)
            comes("585# 43 04 60 00 88 13 00 00");
    }
    EXPECT_EQ(watch.secondAnswers(), 10);
    EXPECT_FALSE(watch.isDoubled());
}

TEST_F(NodeWatchTest, HeartbeatsTwiceAsOftenAreTwoNodes)
{
    watch.setProducerTime(100ms, now);
    beatsFor(10s, 99ms);
    EXPECT_FALSE(watch.isDoubled());
    beatsFor(1s, 50ms);
    EXPECT_TRUE(watch.isDoubled());
    beatsFor(1s, 100ms);
    EXPECT_FALSE(watch.isDoubled());
}

TEST_F(NodeWatchTest, BlockTransfersHaveManyAnswers)
{
    comes("605# A0 08 10 00 7F 00 00 00");
    comes("585# C2 08 10 00 20 00 00 00");
    comes("605# A3 ..");
    for (int each = 1; each < 5; ++each)
        comes("585# 01 41 41 41 41 41 41 41");
    EXPECT_EQ(watch.secondAnswers(), 0);
}

} // namespace
} // namespace codewheel::canopen
