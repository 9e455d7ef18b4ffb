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
        const Instant adapter = on - on / 5'000; // 200 ppm slower
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

} // namespace
} // namespace codewheel
