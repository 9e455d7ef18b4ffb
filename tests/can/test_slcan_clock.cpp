// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/slcan_clock.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

int stampAt(Instant adapter)
{
    return static_cast<int>(std::chrono::duration_cast<std::chrono::milliseconds>(adapter).count() % 60'000);
}

TEST(SlcanClock, AFrameIsNotBeforeItWasOnTheBus)
{
    SlcanClock clock;
    for (Instant on = 1s; on < 200s; on += 7'301us) {
        const Instant adapter = on - on / 4'000; // 250 ppm slower
        const Instant way = 200us + on % 1'700us;
        const Instant told = clock.timeOf(stampAt(adapter), on + way);
        ASSERT_GE(told, on) << on.count();
        ASSERT_LE(told, on + way);
    }
}

TEST(SlcanClock, AWayThatTakesLongDoesNotCount)
{
    SlcanClock clock;
    EXPECT_EQ(clock.timeOf(100, 1s), 1s);
    EXPECT_EQ(clock.timeOf(200, 1s + 180ms), 1s + 101ms);
    EXPECT_EQ(clock.timeOf(210, 1s + 180ms), 1s + 111ms);
}

TEST(SlcanClock, AnAdapterThatStartsAnewIsFollowed)
{
    SlcanClock clock;
    clock.timeOf(30'000, 10s);
    EXPECT_EQ(clock.timeOf(5, 10s + 500ms), 10s + 500ms);
    EXPECT_EQ(clock.timeOf(15, 10s + 512ms), 10s + 511ms);
}

// Stamps begin again after a minute, whatever time passes between frames.
TEST(SlcanClock, CountsOnOverTheMinutes)
{
    SlcanClock clock;
    EXPECT_EQ(clock.timeOf(59'900, 100s), 100s);
    EXPECT_EQ(clock.timeOf(59'990, 100'095ms), 100'091ms);
    EXPECT_EQ(clock.timeOf(10, 100'115ms), 100'111ms);
    EXPECT_EQ(clock.timeOf(10, 160'112ms), 160'112ms) << "a minute later";
    EXPECT_EQ(clock.timeOf(20, 160'130ms), 160'123ms);
    EXPECT_EQ(clock.timeOf(20, 10'121'030ms), 10'121'030ms) << "much later";
}

TEST(SlcanClock, TheShortestWayCountsAsNone)
{
    SlcanClock clock;
    EXPECT_EQ(clock.timeOf(1'000, 10'016ms), 10'016ms);
    EXPECT_EQ(clock.timeOf(1'010, 10'017ms), 10'017ms);
    EXPECT_EQ(clock.timeOf(1'020, 10'033ms), 10'028ms);
}

TEST(SlcanClock, BeginsAnewWithTheAdapter)
{
    SlcanClock clock;
    EXPECT_EQ(clock.timeOf(20'000, 30s), 30s);
    EXPECT_EQ(clock.timeOf(0, 31s), 31s);
    EXPECT_EQ(clock.timeOf(500, 31'500ms), 31'500ms);
}

} // namespace
} // namespace codewheel
