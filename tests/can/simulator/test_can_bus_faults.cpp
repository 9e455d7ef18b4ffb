// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/can/simulator/scripted_participant.h"

#include <gtest/gtest.h>
#include <set>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using namespace test;

// Frames 0, 1, 2 .. of one sender, by the first octets of their data.
struct FaultyRun
{
    explicit FaultyRun(const CanBusFaults &faults, std::uint32_t seed = 1, std::uint8_t frames = 200)
        : bus(seed)
    {
        bus.setFaults(faults);
        listener = join(bus);
        sender = join(bus);
        for (std::uint8_t i = 0; i < frames; ++i)
            sender->waiting.push_back({.id = 0x185, .length = 1, .bytes = {i}});
        bus.advance(60s);
    }
    std::vector<int> numbers() const
    {
        std::vector<int> numbers;
        for (const auto &heard : listener->heard)
            numbers.push_back(heard.frame.bytes[0]);
        return numbers;
    }

    SimulatedCanBus bus;
    std::shared_ptr<ScriptedParticipant> listener;
    std::shared_ptr<ScriptedParticipant> sender;
};

TEST(CanBusFaults, ALostFrameWasAcknowledged)
{
    const FaultyRun run({.lost = 100});
    EXPECT_EQ(run.sender->done.size(), 200U);
    EXPECT_LT(run.listener->heard.size(), 195U);
    EXPECT_GT(run.listener->heard.size(), 150U);
    EXPECT_TRUE(run.sender->disturbances.empty());
}

TEST(CanBusFaults, ADamagedFrameIsSentAgainAndArrivesOnce)
{
    const FaultyRun run({.damaged = 100});
    EXPECT_EQ(run.sender->done.size(), 200U);
    EXPECT_EQ(run.listener->heard.size(), 200U);
    EXPECT_TRUE(std::ranges::is_sorted(run.numbers()));
    EXPECT_GT(run.sender->disturbances.size(), 5U);
}

TEST(CanBusFaults, ADoubledFrameArrivesTwiceInARow)
{
    const FaultyRun run({.doubled = 100});
    EXPECT_EQ(run.sender->done.size(), 200U);
    EXPECT_GT(run.listener->heard.size(), 205U);
    const std::vector<int> numbers = run.numbers();
    EXPECT_TRUE(std::ranges::is_sorted(numbers));
    EXPECT_EQ(std::set(numbers.begin(), numbers.end()).size(), 200U);
}

TEST(CanBusFaults, ALateFrameHoldsUpThoseAfterIt)
{
    const FaultyRun run({.late = 50, .delay = 100ms});
    EXPECT_EQ(run.listener->heard.size(), 200U);
    EXPECT_TRUE(std::ranges::is_sorted(run.numbers()));
    int gaps = 0;
    for (std::size_t i = 1; i < run.listener->heard.size(); ++i)
        gaps += run.listener->heard[i].at - run.listener->heard[i - 1].at >= 100ms ? 1 : 0;
    EXPECT_GT(gaps, 2);
    EXPECT_LT(gaps, 25);
}

TEST(CanBusFaults, TheSeedDecidesWhatHappens)
{
    const CanBusFaults faults{.lost = 100, .damaged = 50, .doubled = 50, .late = 10};
    EXPECT_EQ(FaultyRun(faults, 5).numbers(), FaultyRun(faults, 5).numbers());
    EXPECT_NE(FaultyRun(faults, 5).numbers(), FaultyRun(faults, 6).numbers());
}

TEST(CanBusFaults, ABrokenWirePartsTheBus)
{
    SimulatedCanBus bus;
    std::vector<std::shared_ptr<ScriptedParticipant>> all;
    for (std::uint32_t i = 0; i < 4; ++i) {
        all.push_back(join(bus));
        all.back()->waiting = {{.id = 0x700 + i}};
    }
    bus.setFaults({.brokenAfter = 3});
    bus.advance(1s);
    EXPECT_EQ(idsOf(all[0]->heard), (std::vector<std::uint32_t>{0x701, 0x702}));
    EXPECT_TRUE(all[3]->heard.empty());
    EXPECT_EQ(all[3]->states.back(), CanState::passive) << "alone";
    bus.setFaults({});
    bus.advance(2s);
    EXPECT_EQ(idsOf(all[0]->heard), (std::vector<std::uint32_t>{0x701, 0x702, 0x703}));
}

TEST(CanBusFaults, BothSidesOfABreakGoOnByThemselves)
{
    SimulatedCanBus bus;
    std::vector<std::shared_ptr<ScriptedParticipant>> all;
    for (std::uint32_t i = 0; i < 4; ++i) {
        all.push_back(join(bus));
        all.back()->waiting = {{.id = 0x700 + i}};
    }
    bus.setFaults({.brokenAfter = 2});
    bus.advance(1s);
    EXPECT_EQ(idsOf(all[0]->heard), std::vector<std::uint32_t>{0x701});
    EXPECT_EQ(idsOf(all[3]->heard), std::vector<std::uint32_t>{0x702});
}

TEST(CanBusFaults, OneIsTakenOffWhileItsFrameIsOnTheWire)
{
    SimulatedCanBus bus;
    const auto listener = join(bus);
    const auto sender = join(bus, {.waiting = {{.id = 0x185}}});
    bus.advance(100us);
    bus.remove(*sender);
    bus.advance(1s);
    EXPECT_TRUE(sender->done.empty());
    EXPECT_EQ(bus.nextEvent(), std::nullopt);
}

} // namespace
} // namespace codewheel
