// SPDX-License-Identifier: GPL-3.0-or-later
// Error counters and states as ISO 11898-1, 12.1.4 has them.
#include "can/can_bits.h"
#include "tests/can/simulator/scripted_participant.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using namespace test;

const CanFrame heartbeat{.id = 0x705, .length = 1, .bytes = {0x05}}; // 56 bits

TEST(CanErrors, AfterThirtyTwoDestroyedFramesASenderIsOff)
{
    SimulatedCanBus bus;
    bus.setFaults({.damaged = 1'000});
    const auto listener = join(bus);
    const auto sender = join(bus, {.returns = false, .waiting = {heartbeat}});
    for (int failed = 1; failed <= 31; ++failed) {
        bus.advance(1h, [&] { return static_cast<int>(sender->disturbances.size()) == failed; });
        EXPECT_EQ(bus.errorsOf(*sender).transmit(), 8 * failed);
        EXPECT_EQ(bus.errorsOf(*listener).receive(), failed);
    }
    bus.advance(bus.now() + 1s);
    EXPECT_EQ(sender->disturbances.size(), 32U);
    EXPECT_EQ(sender->states,
              (std::vector{CanState::warning, CanState::passive, CanState::busOff})); // at 96, 128, 256
    EXPECT_EQ(bus.errorsOf(*sender).transmit(), 256);
    EXPECT_EQ(listener->heard.size(), 0U);
    EXPECT_EQ(listener->states, std::vector<CanState>());
}

TEST(CanErrors, ASentFrameTakesBackOneOfEight)
{
    SimulatedCanBus bus;
    const auto listener = join(bus);
    const auto sender = join(bus, {.waiting = {10, heartbeat}});
    bus.setFaults({.damaged = 1'000});
    bus.advance(1h, [&] { return sender->disturbances.size() == 2; });
    bus.setFaults({});
    bus.advance(1s);
    EXPECT_EQ(sender->done.size(), 10U);
    EXPECT_EQ(bus.errorsOf(*sender).transmit(), 16 - 10);
    EXPECT_EQ(bus.errorsOf(*listener).receive(), 0);
}

TEST(CanErrors, ALoneSenderGoesPassiveAndRepeatsForEver)
{
    SimulatedCanBus bus;
    const auto sender = join(bus, {.bitRate = 1'000'000, .waiting = {heartbeat}});
    bus.advance(1h, [&] { return sender->disturbances.size() == 16; });
    // 48 bits up to the acknowledge slot, 14 of an error frame, 3 between frames.
    EXPECT_EQ(bus.now(), Instant(15 * 65 + 62));
    EXPECT_EQ(sender->states, (std::vector{CanState::warning, CanState::passive}));
    bus.advance(1h, [&] { return sender->disturbances.size() == 18; });
    EXPECT_EQ(bus.now(), Instant(15 * 65 + 62 + 2 * (3 + 8 + 62))) << "8 bits more, as it is passive";
    bus.advance(1s);
    EXPECT_GT(sender->disturbances.size(), 10'000U);
    EXPECT_EQ(bus.errorsOf(*sender).transmit(), 128);
    EXPECT_EQ(sender->states.back(), CanState::passive);
    EXPECT_EQ(sender->waiting.size(), 1U);

    const auto another = join(bus, {.bitRate = 1'000'000});
    bus.advance(2s);
    EXPECT_EQ(another->heard.size(), 1U);
    EXPECT_TRUE(sender->waiting.empty());
    EXPECT_EQ(bus.errorsOf(*sender).transmit(), 127);
    EXPECT_EQ(sender->states.back(), CanState::warning);
}

TEST(CanErrors, WhoOnlyListensAcknowledgesAndCountsNothing)
{
    SimulatedCanBus bus;
    const auto listener = join(bus, {.onlyListens = true, .waiting = {heartbeat}});
    const auto sender = join(bus, {.waiting = {heartbeat}});
    bus.advance(1h, [&] { return sender->disturbances.size() == 16; });
    EXPECT_TRUE(listener->heard.empty()) << "destroyed by its sender, who is active";
    bus.advance(1s);
    EXPECT_EQ(listener->disturbances.size(), 16U);
    EXPECT_GT(listener->heard.size(), 500U) << "again and again from its sender, who is passive";
    EXPECT_TRUE(sender->done.empty());
    EXPECT_EQ(bus.errorsOf(*listener).receive(), 0);
    EXPECT_EQ(listener->waiting.size(), 1U) << "it sends nothing";
}

TEST(CanErrors, ComesBackOnceTheBusWasQuietForLongEnough)
{
    SimulatedCanBus bus;
    const auto listener = join(bus, {.bitRate = 1'000'000});
    const auto sender = join(bus, {.bitRate = 1'000'000});
    bus.forceBusOff(*sender);
    bus.locked([&] { sender->waiting = {heartbeat}; });
    EXPECT_EQ(sender->states, std::vector{CanState::busOff});
    bus.advance(1s);
    ASSERT_EQ(listener->heard.size(), 1U);
    EXPECT_EQ(listener->heard[0].at, Instant(128 * 11 + 56));
    EXPECT_EQ(sender->states.back(), CanState::active);
}

TEST(CanErrors, FramesOfOthersDelayTheReturn)
{
    SimulatedCanBus bus;
    const auto one = join(bus, {.bitRate = 1'000'000, .waiting = {4, heartbeat}});
    join(bus, {.bitRate = 1'000'000});
    const auto off = join(bus, {.bitRate = 1'000'000});
    bus.forceBusOff(*off);
    bus.advance(1h, [&] { return off->states.back() == CanState::active; });
    EXPECT_EQ(bus.now(), Instant(128 * 11 + 4 * (56 - 11)));
    EXPECT_TRUE(off->heard.empty());
}

TEST(CanErrors, WhoDoesNotComeBackIsRestarted)
{
    SimulatedCanBus bus;
    const auto listener = join(bus);
    const auto sender = join(bus, {.returns = false});
    bus.forceBusOff(*sender);
    bus.locked([&] { sender->waiting = {heartbeat}; });
    bus.advance(10s);
    EXPECT_TRUE(listener->heard.empty());
    bus.restart(*sender);
    bus.advance(11s);
    EXPECT_EQ(listener->heard.size(), 1U);
    EXPECT_EQ(bus.errorsOf(*sender).state(), CanState::active);
}

TEST(CanErrors, SwitchedOffItTakesPartInNothingAndThenBeginsAnew)
{
    SimulatedCanBus bus;
    const auto sender = join(bus, {.waiting = {heartbeat}});
    const auto other = join(bus, {.on = false});
    bus.advance(1s);
    EXPECT_TRUE(sender->done.empty()) << "nobody has acknowledged it";
    bus.locked([&] { sender->on = false; });
    bus.advance(2s);
    bus.locked([&] { other->on = sender->on = true; });
    bus.advance(3s);
    EXPECT_EQ(other->heard.size(), 1U);
    EXPECT_EQ(bus.errorsOf(*sender).transmit(), 0);
}

TEST(CanErrors, WhoHasAnotherRateDestroysFramesUntilItIsPassive)
{
    SimulatedCanBus bus;
    const auto listener = join(bus);
    const auto wrong = join(bus, {.bitRate = 250'000});
    const auto sender = join(bus, {.waiting = {20, heartbeat}});
    bus.advance(1h, [&] { return !wrong->states.empty() && wrong->states.back() == CanState::passive; });
    EXPECT_TRUE(listener->heard.empty());
    EXPECT_EQ(bus.errorsOf(*sender).transmit(), 15 * 8);
    EXPECT_EQ(bus.errorsOf(*wrong).receive(), 128); // 9 each: its own error flag was the first
    EXPECT_EQ(bus.errorsOf(*listener).receive(), 15);
    bus.advance(1s);
    EXPECT_EQ(listener->heard.size(), 20U);
    EXPECT_TRUE(wrong->heard.empty());
    EXPECT_EQ(wrong->disturbances.size(), 15U + 20U);
}

TEST(CanErrors, ASenderAtAnotherRateReachesNobody)
{
    SimulatedCanBus bus;
    const auto one = join(bus);
    const auto other = join(bus);
    const auto wrong = join(bus, {.bitRate = 500'000, .waiting = {heartbeat}});
    bus.advance(1s);
    EXPECT_TRUE(one->heard.empty());
    EXPECT_TRUE(wrong->done.empty());
    EXPECT_EQ(wrong->states.back(), CanState::passive);
}

TEST(CanErrors, WhoOnlyListensAtAnotherRateDestroysNothing)
{
    SimulatedCanBus bus;
    const auto one = join(bus, {.waiting = {5, heartbeat}});
    const auto other = join(bus);
    const auto wrong = join(bus, {.bitRate = 250'000, .onlyListens = true});
    bus.advance(1s);
    EXPECT_EQ(other->heard.size(), 5U);
    EXPECT_TRUE(wrong->heard.empty());
    EXPECT_EQ(wrong->disturbances.size(), 5U);
}

} // namespace
} // namespace codewheel
