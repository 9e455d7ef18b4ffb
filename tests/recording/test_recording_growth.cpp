// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_growth.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

TEST(RecordingGrowth, SaysHowLongTheRoomLasts)
{
    RecordingGrowth growth;
    EXPECT_FALSE(growth.timeUntilFull(1));
    growth.add(0s, 1'000);
    EXPECT_FALSE(growth.bytesPerSecond()) << "one size is no rate";
    growth.add(10s, 2'000);
    EXPECT_DOUBLE_EQ(*growth.bytesPerSecond(), 100);
    EXPECT_EQ(growth.timeUntilFull(8'640'000), Instant(24h));
    EXPECT_EQ(growth.timeUntilFull(-5), Instant(0));
}

TEST(RecordingGrowth, OnlyWhatWasLatelyCounts)
{
    RecordingGrowth growth;
    for (int second = 0; second <= 3'600; ++second)
        growth.add(1s * second, second < 3'000 ? 1'000 * second : 3'000'000 + 10 * (second - 3'000));
    EXPECT_NEAR(*growth.bytesPerSecond(), 10, 0.1);
}

TEST(RecordingGrowth, AFileThatDoesNotGrowIsNeverFull)
{
    RecordingGrowth growth;
    growth.add(0s, 5);
    growth.add(1s, 5);
    EXPECT_FALSE(growth.timeUntilFull(100));
    growth.add(2s, 6);
    EXPECT_EQ(growth.timeUntilFull(std::numeric_limits<std::int64_t>::max()), RecordingGrowth::longest);
}

} // namespace
} // namespace codewheel
