// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_load.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

// 81 bits with 5 stuff bits, and 3 that follow.
CanFrame positionAt(Instant time)
{
    return {.id = 0x185, .length = 4, .bytes = {0x88, 0x13}, .time = time};
}

TEST(CanLoad, IsTheShareOfBitTimesOfTheLastSecond)
{
    CanLoad load(125'000);
    EXPECT_EQ(load.share(0s), 0.0);
    for (Instant time = 10ms; time <= 1s; time += 10ms)
        load.add(positionAt(time));
    EXPECT_DOUBLE_EQ(load.share(1s), 100 * 84 / 125'000.0);
    EXPECT_DOUBLE_EQ(load.share(1'500ms), 50 * 84 / 125'000.0);
    EXPECT_EQ(load.share(2s), 0.0);
}

TEST(CanLoad, StuffBitsOfTheDataCount)
{
    CanLoad zeros(10'000);
    zeros.add({.id = 0x000, .length = 8, .time = 0s});
    EXPECT_DOUBLE_EQ(zeros.share(1ms), 127 / 10'000.0);
    CanLoad alternating(10'000);
    alternating.add(
        {.id = 0x555, .length = 8, .bytes = {0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55}, .time = 0s});
    EXPECT_DOUBLE_EQ(alternating.share(1ms), 112 / 10'000.0);
}

TEST(CanLoad, ErrorFramesTakeTimeToo)
{
    CanLoad load(10'000);
    load.add({.id = 0x88, .isError = true, .length = 8, .time = 0s});
    EXPECT_DOUBLE_EQ(load.share(1ms), 23 / 10'000.0);
}

TEST(CanLoad, ABusIsNeverMoreThanFull)
{
    CanLoad load(10'000);
    for (Instant time = 0s; time < 1s; time += 5ms) // 84 bits each take 8.4 ms
        load.add(positionAt(time));
    EXPECT_EQ(load.share(999ms), 1.0);
}

} // namespace
} // namespace codewheel
