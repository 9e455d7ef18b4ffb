// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_clock.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

TEST(ClockWatch, OnlyTheFirstTimeAndAClockThatWasSetAreNews)
{
    ClockWatch watch;
    EXPECT_TRUE(watch.isNews({10s, 10s}));
    EXPECT_FALSE(watch.isNews({11s, 11s}));
    EXPECT_FALSE(watch.isNews({3611s, 3611s + 499ms})) << "a slow drift";
    EXPECT_TRUE(watch.isNews({3612s, 3612s + 500ms}));
    EXPECT_TRUE(watch.isNews({3613s, 13s})) << "set back by an hour";
    EXPECT_FALSE(watch.isNews({3614s, 14s}));
    EXPECT_TRUE(watch.isNews({3615s, 3615s}));
}

TEST(WallClock, SaysWhatTheClockOfTheComputerSaid)
{
    const WallClock clock({{7200s, 3600s}, {100s, 101s}});
    EXPECT_EQ(clock.wall(50s), Instant(51s));
    EXPECT_EQ(clock.wall(100s), Instant(101s));
    EXPECT_EQ(clock.wall(7199s), Instant(7200s));
    EXPECT_EQ(clock.wall(7200s), Instant(3600s)) << "an hour comes twice";
    EXPECT_EQ(clock.wall(7300s), Instant(3700s));
    EXPECT_EQ(WallClock().wall(5s), Instant(5s));
}

} // namespace
} // namespace codewheel
