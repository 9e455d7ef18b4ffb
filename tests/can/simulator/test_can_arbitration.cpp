// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/can/simulator/scripted_participant.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using namespace test;

TEST(SimulatedCanBus, AFrameTakesTheTimeOfItsBits)
{
    struct Row
    {
        int rate;
        Instant end; // of 81 bits
    };
    for (const Row row : {Row{1'000'000, 81us}, Row{800'000, 101us}, Row{500'000, 162us}, Row{125'000, 648us},
                          Row{10'000, 8'100us}}) {
        SimulatedCanBus bus;
        const auto sender = join(bus, {.bitRate = row.rate});
        const auto other = join(bus, {.bitRate = row.rate});
        sender->waiting = {{.id = 0x185, .length = 4, .bytes = {0x88, 0x13}}};
        bus.advance(1s);
        ASSERT_EQ(other->heard.size(), 1U);
        EXPECT_EQ(other->heard[0].at, row.end) << row.rate;
        EXPECT_EQ(other->heard[0].frame.time, row.end);
        EXPECT_EQ(sender->done.size(), 1U);
        EXPECT_TRUE(sender->heard.empty()) << "its own";
        EXPECT_EQ(bus.now(), 1s);
    }
}

TEST(SimulatedCanBus, ThreeBitsLieBetweenFrames)
{
    SimulatedCanBus bus;
    const auto sender = join(bus, {.bitRate = 1'000'000});
    const auto other = join(bus, {.bitRate = 1'000'000});
    sender->waiting = {3, {.id = 0x080}}; // 48 bits
    bus.advance(1s);
    ASSERT_EQ(other->heard.size(), 3U);
    EXPECT_EQ(other->heard[0].at, 48us);
    EXPECT_EQ(other->heard[1].at, 99us);
    EXPECT_EQ(other->heard[2].at, 150us);
}

TEST(SimulatedCanBus, TheLowestIdentifierGoesFirst)
{
    SimulatedCanBus bus;
    const auto listener = join(bus);
    for (const CanFrame &frame : {CanFrame{.id = 0x705, .length = 1}, CanFrame{.id = 0x185, .isRemote = true},
                                  CanFrame{.id = 0x0614'0000, .isExtended = true}, CanFrame{.id = 0x080},
                                  CanFrame{.id = 0x185}, CanFrame{.id = 0x184}})
        join(bus)->waiting = {frame};
    bus.advance(1s);
    EXPECT_EQ(idsOf(listener->heard),
              (std::vector<std::uint32_t>{0x080, 0x184, 0x185, 0x185, 0x0614'0000, 0x705}));
    EXPECT_FALSE(listener->heard[2].frame.isRemote);
    EXPECT_TRUE(listener->heard[3].frame.isRemote);
}

TEST(SimulatedCanBus, AFrameThatHasBegunIsNotInterrupted)
{
    SimulatedCanBus bus;
    const auto listener = join(bus);
    const auto first = join(bus);
    const auto second = join(bus, {.waiting = {{.id = 0x001}}, .later = 100us});
    first->waiting = {2, {.id = 0x7FF, .length = 8}};
    bus.advance(1s);
    EXPECT_EQ(idsOf(listener->heard), (std::vector<std::uint32_t>{0x7FF, 0x001, 0x7FF}));
}

TEST(SimulatedCanBus, TwoWithTheSameIdentifierAndOtherDataBothGoBusOff)
{
    SimulatedCanBus bus;
    const auto listener = join(bus);
    const auto one = join(bus, {.returns = false, .waiting = {{.id = 0x705, .length = 1, .bytes = {0x05}}}});
    const auto other =
        join(bus, {.returns = false, .waiting = {{.id = 0x705, .length = 1, .bytes = {0x7F}}}});
    bus.advance(1s);
    EXPECT_TRUE(listener->heard.empty());
    EXPECT_EQ(one->states.back(), CanState::busOff);
    EXPECT_EQ(other->states.back(), CanState::busOff);
}

TEST(SimulatedCanBus, TwoVerySameFramesAreOne)
{
    SimulatedCanBus bus;
    const auto listener = join(bus);
    const auto one = join(bus, {.waiting = {{.id = 0x705, .length = 1, .bytes = {0x05}}}});
    const auto other = join(bus, {.waiting = {{.id = 0x705, .length = 1, .bytes = {0x05}}}});
    bus.advance(1s);
    EXPECT_EQ(listener->heard.size(), 1U);
    EXPECT_EQ(one->done.size(), 1U);
    EXPECT_EQ(other->done.size(), 1U);
}

TEST(SimulatedCanBus, StopsAtTheFirstEventThatIsEnough)
{
    SimulatedCanBus bus;
    const auto listener = join(bus, {.bitRate = 1'000'000});
    join(bus, {.bitRate = 1'000'000})->waiting = {2, {.id = 0x080}};
    bus.advance(1h, [&] { return !listener->heard.empty(); });
    EXPECT_EQ(bus.now(), 48us);
    EXPECT_EQ(bus.nextEvent(), 51us);
    bus.advance(1h, [&] { return listener->heard.size() == 2; });
    EXPECT_EQ(bus.now(), 99us);
    EXPECT_EQ(bus.nextEvent(), std::nullopt);
}

} // namespace
} // namespace codewheel
