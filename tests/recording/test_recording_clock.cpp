// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_clock.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

TEST(ClockWatch, OnlyTheFirstTimeAndAClockThatWasSetAreNews)
{
    ClockWatch watch;
    EXPECT_EQ(watch.news({10s, 10s}), (RecordedClock{10s, 10s}));
    EXPECT_EQ(watch.news({11s, 11s}), std::nullopt);
    EXPECT_EQ(watch.news({3611s, 3611s + 499ms}), std::nullopt) << "a slow drift";
    EXPECT_EQ(watch.news({3613s, 13s}), std::nullopt) << "it may be the time of the bus that is wrong";
    EXPECT_EQ(watch.news({3613s + 50ms, 13s + 50ms}), std::nullopt) << "the same moment";
    EXPECT_EQ(watch.news({3614s, 14s}), (RecordedClock{3613s, 13s})) << "set back by an hour";
    EXPECT_EQ(watch.news({3615s, 15s}), std::nullopt);
}

// After SIGSTOP, or on a starved computer, the bus tells its time later than the clock of the computer is
// read.
TEST(ClockWatch, APauseOfTheProgramIsNoClockThatWasSet)
{
    ClockWatch watch;
    EXPECT_TRUE(watch.news({10s, 10s}));
    EXPECT_EQ(watch.news({11s, 21s}), std::nullopt);
    EXPECT_EQ(watch.news({11s, 22s}), std::nullopt) << "the bus has not gone on";
    EXPECT_EQ(watch.news({23s, 23s}), std::nullopt);
    EXPECT_EQ(watch.news({24s, 24s}), std::nullopt);
    EXPECT_EQ(watch.news({24s, 34s}), std::nullopt);
    EXPECT_EQ(watch.news({35s, 35s}), std::nullopt);
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
