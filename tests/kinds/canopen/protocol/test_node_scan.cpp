// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/node_scan.h"
#include "tests/kinds/canopen/protocol/frame_literal.h"

#include <gtest/gtest.h>
#include <map>

using namespace std::chrono_literals;

namespace codewheel::canopen {
namespace {

// Nodes that answer after a while, and the bus with them.
struct ScannedBus
{
    NodeScan scan;
    Instant now = 1s;
    std::map<int, Instant> nodes{}; // and how long each takes
    std::multimap<Instant, CanFrame> underWay{};
    int requests = 0;
    int answers = 0;
    std::map<int, int> asked{}; // how often for 1000h

    explicit ScannedBus(int rate)
        : scan({.rate = rate}, 1s)
    {}

    void request(const CanFrame &frame)
    {
        ++requests;
        const int node = static_cast<int>(frame.id) - 0x600;
        const bool isType = frame.bytes[1] == 0x00;
        asked[node] += isType ? 1 : 0;
        EXPECT_EQ(frame.bytes[0], 0x40);
        if (!nodes.contains(node))
            return;
        CanFrame answer = frame;
        answer.id = 0x580 + static_cast<std::uint32_t>(node);
        answer.bytes[0] = 0x43;
        answer.bytes[4] = isType ? 0x96 : frame.bytes[3];
        answer.bytes[5] = static_cast<std::uint8_t>(isType ? 0x01 : node);
        underWay.emplace(now + nodes.at(node), answer);
    }
    void run()
    {
        for (int step = 0; !scan.isDone() && step < 100'000; ++step) {
            if (const auto frame = scan.next(now))
                request(*frame);
            else if (const auto wakes = scan.wakesAt())
                passUntil(*wakes);
        }
        EXPECT_TRUE(scan.isDone());
    }
    void passUntil(Instant until)
    {
        if (!underWay.empty() && underWay.begin()->first <= until) {
            now = std::max(now, underWay.begin()->first);
            ++answers;
            EXPECT_TRUE(scan.take(underWay.begin()->second, now));
            underWay.erase(underWay.begin());
        } else {
            EXPECT_GT(until, now);
            now = until;
        }
    }
};

FoundNode foundAs(int node)
{
    FoundNode found{.node = node, .deviceType = 0x0196};
    for (std::uint32_t word = 0; word < 4; ++word)
        found.identity[word] = static_cast<std::uint32_t>(node) << 8 | (word + 1);
    return found;
}

TEST(NodeScan, FindsFiveOf127InTwoSecondsAt125kBd)
{
    ScannedBus bus(125'000);
    for (const int node : {1, 5, 32, 64, 127})
        bus.nodes[node] = 2ms;
    bus.run();
    EXPECT_EQ(bus.scan.found(),
              (std::vector<FoundNode>{foundAs(1), foundAs(5), foundAs(32), foundAs(64), foundAs(127)}));
    EXPECT_EQ(bus.scan.progress(), 127);
    EXPECT_FALSE(bus.scan.wakesAt());
    EXPECT_EQ(bus.requests, 5 * 5 + 122 * 2);
    EXPECT_LT(bus.now - 1s, 2s);
}

TEST(NodeScan, TakesAtMostThirtyPercentOfTheBus)
{
    for (const int rate : {10'000, 125'000, 1'000'000}) {
        ScannedBus bus(rate);
        for (int node = 1; node <= 127; node += 3)
            bus.nodes[node] = 1ms;
        bus.run();
        const double seconds = std::chrono::duration<double>(bus.now - 1s).count();
        EXPECT_LE((bus.requests + bus.answers - 2) * 135 / seconds, 0.301 * rate);
        EXPECT_EQ(bus.scan.found().size(), 43);
    }
}

TEST(NodeScan, ALateAnswerIsOfItsNode)
{
    ScannedBus bus(125'000);
    bus.nodes[5] = 150ms; // each time after the time-out
    bus.nodes[6] = 350ms; // when it was given up
    bus.run();
    while (!bus.underWay.empty())
        bus.passUntil(bus.now + 1s);
    EXPECT_EQ(bus.scan.found(), (std::vector<FoundNode>{foundAs(5), foundAs(6)}));
    EXPECT_EQ(bus.asked[7], 2);
}

TEST(NodeScan, AnAbortIsAnAnswer)
{
    NodeScan scan({}, 1s);
    Instant now = 1s;
    EXPECT_EQ(textOf(*scan.next(now)), "601#4000100000000000");
    EXPECT_TRUE(scan.take(frameFrom("581# 80 00 10 00 00 00 02 06"), now));
    now += 100ms;
    EXPECT_EQ(textOf(*scan.next(now)), "601#4018100100000000");
    EXPECT_EQ(scan.found(), std::vector{FoundNode{.node = 1}});
    EXPECT_FALSE(scan.take(frameFrom("601# 40 00 10 00 .."), now));
    EXPECT_FALSE(scan.take(frameFrom("181# 43 00 10 00 .."), now));
}

TEST(NodeScan, AnswersToOthersTellThatANodeIsThereAndNoValue)
{
    NodeScan scan({}, 1s);
    scan.take(frameFrom("589# 43 04 60 00 88 13 00 00"), 1s);
    EXPECT_EQ(scan.found(), std::vector{FoundNode{.node = 9}});
    EXPECT_EQ(textOf(*scan.next(2s)), "609#4000100000000000");
}

TEST(NodeScan, AFullQueueMeansWait)
{
    NodeScan scan({}, 1s);
    Instant now = 1s;
    for (int each = 0; each < 10; ++each) {
        const auto frame = scan.next(now);
        ASSERT_TRUE(frame);
        EXPECT_EQ(textOf(*frame), "601#4000100000000000");
        scan.queueFull(now);
        EXPECT_FALSE(scan.next(now));
        now = scan.wakesAt().value();
    }
    EXPECT_EQ(textOf(*scan.next(now)), "601#4000100000000000");
    now = scan.wakesAt().value();
    EXPECT_EQ(textOf(*scan.next(now)), "602#4000100000000000");
}

TEST(NodeScan, WhatWasRefusedIsAskedAgain)
{
    NodeScan scan({}, 1s);
    Instant now = 1s;
    for (int each = 0; each < 3; ++each) { // more often than a number is asked
        EXPECT_EQ(textOf(*scan.next(now)), "601#4000100000000000");
        scan.fate(1, CanFate::refused, now);
        now = scan.wakesAt().value();
    }
    EXPECT_EQ(textOf(*scan.next(now)), "601#4000100000000000");
    scan.fate(1, CanFate::done, now);
    now = scan.wakesAt().value();
    EXPECT_EQ(textOf(*scan.next(now)), "602#4000100000000000");
}

TEST(NodeScan, IsNotStuckForLongWhereOthersAreHeard)
{
    NodeScan scan({}, 1s);
    Instant now = 1s;
    for (; now < 30s; now = scan.wakesAt().value()) {
        EXPECT_FALSE(scan.isStuck(now));
        scan.hear(now);
        if (scan.next(now))
            scan.queueFull(now);
    }
    EXPECT_TRUE(scan.isStuck(31s)) << "an adapter that sends nothing, though it receives";
}

TEST(NodeScan, IsStuckWhereNothingGoesOutAnyMore)
{
    NodeScan scan({}, 1s);
    Instant now = 1s;
    for (; now < 3s; now = scan.wakesAt().value()) {
        EXPECT_FALSE(scan.isStuck(now));
        if (scan.next(now))
            scan.queueFull(now);
    }
    EXPECT_TRUE(scan.isStuck(now));
    scan.fate(1, CanFate::done, now);
    EXPECT_FALSE(scan.isStuck(now));
}

} // namespace
} // namespace codewheel::canopen
