// SPDX-License-Identifier: GPL-3.0-or-later
#include "handshake_rows.h"
#include "simulator/turning_shaft.h"

#include <gtest/gtest.h>
#include <limits>

namespace codewheel {
namespace {

void advance(TurningShaft &shaft, int cycles)
{
    for (int i = 0; i < cycles; ++i)
        shaft.advance();
}

TEST(TurningShaft, TurnsExactlyWithoutDrift)
{
    TurningShaft shaft(thirteenPlusTwelve);
    shaft.setSpeed(10); // 1.3653 steps per cycle
    advance(shaft, 1);
    EXPECT_EQ(shaft.raw(), 1);
    advance(shaft, 60'000 - 1); // a minute: ten turns
    EXPECT_EQ(shaft.raw(), 10 * 8192);
    advance(shaft, 20 * 60'000);
    EXPECT_EQ(shaft.raw(), 210 * 8192);
}

TEST(TurningShaft, TurnsBackToWhereItCameFrom)
{
    TurningShaft shaft(thirteenPlusTwelve, 12'345);
    shaft.setSpeed(33.333);
    advance(shaft, 10'001);
    shaft.setSpeed(-33.333);
    advance(shaft, 10'001);
    EXPECT_EQ(shaft.raw(), 12'345);
    EXPECT_DOUBLE_EQ(shaft.speed(), -33.333);
}

TEST(TurningShaft, WrapsAtThePhysicalRangeInBothDirections)
{
    TurningShaft shaft({4096, 1}, 4095);
    shaft.setSpeed(60'000.0 / 4096); // almost one step per cycle
    advance(shaft, 2);
    EXPECT_LE(shaft.raw(), 1);
    shaft.turnTo(0);
    shaft.setSpeed(-20);
    advance(shaft, 1);
    EXPECT_EQ(shaft.raw(), 4094);
    shaft.setSpeed(0);
    shaft.turnBy(-4095);
    EXPECT_EQ(shaft.raw(), 4095);
    shaft.turnBy(1);
    EXPECT_EQ(shaft.raw(), 0);
    shaft.turnTo(-1);
    EXPECT_EQ(shaft.raw(), 4095);
    shaft.turnTo(std::numeric_limits<std::int64_t>::max());
    EXPECT_EQ(shaft.raw(), 4095);
}

TEST(TurningShaft, LimitsTheSpeedAndIgnoresWhatIsNoNumber)
{
    TurningShaft shaft(thirteenPlusTwelve);
    shaft.setSpeed(1e30);
    EXPECT_EQ(shaft.speed(), TurningShaft::fastest);
    shaft.setSpeed(-std::numeric_limits<double>::infinity());
    EXPECT_EQ(shaft.speed(), -TurningShaft::fastest);
    shaft.setSpeed(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(shaft.speed(), -TurningShaft::fastest);
}

// 800 kHz are 5859 rpm at 13 bits
TEST(TurningShaft, KnowsTheRateOfItsCode)
{
    TurningShaft shaft(thirteenPlusTwelve);
    for (const auto &[rpm, tooFast] :
         {std::pair{5859.0, false}, {5860.0, true}, {-5859.0, false}, {-5860.0, true}}) {
        shaft.setSpeed(rpm);
        EXPECT_EQ(shaft.isFasterThan(800), tooFast) << rpm;
    }
}

} // namespace
} // namespace codewheel
