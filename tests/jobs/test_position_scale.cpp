// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/total_range.h"
#include "jobs/position_scale.h"
#include "tests/kinds/interbus/words/driver_table.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

PositionScale scaled(std::int64_t steps, std::int64_t revolutions, std::int64_t turns = 4096)
{
    return {.steps = steps,
            .revolutions = revolutions,
            .turns = turns,
            .zeroOffset = 0,
            .preset = {},
            .physicalStepsPerTurn = 8192,
            .physicalTurns = 4096};
}

// Baumer manual 5: 200 steps, 5 turns: 0..999 unsigned, -500..499 signed.
TEST(PositionScaleTest, TotalRangeOfTheBaumerManual)
{
    PositionScale scale = scaled(200, 1, 5);
    EXPECT_EQ(scale.total(), 1000);
    EXPECT_EQ(scale.shown(1000), 0);
    EXPECT_EQ(scale.shown(-1), 999);
    scale.isSigned = true;
    EXPECT_EQ(scale.shown(499), 499);
    EXPECT_EQ(scale.shown(500), -500);
    EXPECT_NEAR(scaled(1000, 3).resolution(), 333.333, 0.001);
}

TEST(PositionScaleTest, TellsWhereThePositionWillJump)
{
    EXPECT_EQ(wrapJump(scaled(255, 1)), WrapJump::none);
    EXPECT_EQ(wrapJump(scaled(200, 1, 5)), WrapJump::rangeDoesNotDivideTurns);
    EXPECT_EQ(jumpAtWrap(scaled(200, 1, 5)), 4096 * 200 % 1000) << "819 200 would be 200, and is 0";
    EXPECT_EQ(jumpAtWrap(scaled(200, 1, 3)), 200) << "600 - 4096 * 200 % 600";
    EXPECT_EQ(jumpAtWrap(scaled(200, 1, 8)), 0);
    EXPECT_EQ(jumpAtWrap(scaled(1000, 3)), 0) << "a third of a step";
    EXPECT_EQ(jumpAtWrap(scaled(1000, 3, 8)), 341) << "512 times two thirds of a step";
    EXPECT_EQ(wrapJump(scaled(200, 1, 8)), WrapJump::none);
    EXPECT_EQ(wrapJump(scaled(1000, 3)), WrapJump::totalIsNotWhole);
    EXPECT_EQ(wrapJump(scaled(1000, 4)), WrapJump::none);
}

// The training bus: raw 12345 reads 12345 at 8192 steps, and 384 at 255 steps (12345 x 255 / 8192).
TEST(PositionScaleTest, ForetellsThePositionInAnotherScale)
{
    EXPECT_EQ(foretellPosition(scaled(8192, 1), 12'345, scaled(255, 1)), (ForetoldPosition{384, true}));
    PositionScale reversed = scaled(255, 1);
    reversed.clockwise = false;
    EXPECT_EQ(foretellPosition(scaled(8192, 1), 12'345, reversed),
              (ForetoldPosition{255 * 4096 - 1 - 384, true}));
    const auto finer = foretellPosition(scaled(255, 1), 384, scaled(8192, 1));
    ASSERT_TRUE(finer);
    EXPECT_FALSE(finer->exact);
    EXPECT_NEAR(static_cast<double>(finer->position), 12'345, 33);
}

TEST(PositionScaleTest, ForetellsNothingItCannotKnow)
{
    PositionScale unknown = scaled(8192, 1);
    unknown.zeroOffset.reset();
    EXPECT_FALSE(foretellPosition(unknown, 1, scaled(255, 1)));
    EXPECT_FALSE(foretellPosition(scaled(200, 1, 5), 1, scaled(255, 1))); // in which of the many 5 turns?
}

TEST(PositionScaleTest, AnotherOffsetShiftsThePositionWhateverTheRange)
{
    PositionScale now = scaled(200, 1, 5); // 0..999
    PositionScale then = now;
    now.zeroOffset = 990;
    then.zeroOffset = 30;
    EXPECT_EQ(foretellPosition(now, 5, then), (ForetoldPosition{45, true}));
    EXPECT_EQ(foretellPosition(then, 5, now), (ForetoldPosition{965, true}));
    now.zeroOffset.reset();
    EXPECT_FALSE(foretellPosition(now, 5, then)) << "by how much is not known";
    then.zeroOffset.reset(); // it stays
    then.offset = 7;
    EXPECT_EQ(foretellPosition(now, 5, then), (ForetoldPosition{12, true}));
}

TEST(PositionScaleTest, TurnsInThought)
{
    EXPECT_EQ(positionAfterTurns(scaled(255, 1), 0, 1), 255);
    EXPECT_EQ(positionAfterTurns(scaled(255, 1), 0, -1), 4095 * 255);
    EXPECT_EQ(positionAfterTurns(scaled(200, 1, 5), 900, 0.5), 0);
}

// Of 500 steps per turn that it keeps, a serial encoder counts none while its scaling is off.
TEST(PositionScaleTest, ASerialEncoderCountsItsOwnStepsWhileScalingIsOff)
{
    const DeviceDescription &device = describe(u"kuebler-esc-rs485");
    ParameterValues known{{Parameter::steps, 500},
                          {Parameter::revolutions, 4096},
                          {Parameter::measuringRange, 2'048'000},
                          {Parameter::direction, 0}};
    const auto its = [&](Parameter parameter) { return valueOf(known, parameter); };
    EXPECT_FALSE(scaleOf(device, its)) << "not known whether it is off";
    EXPECT_FALSE(speedScaleOf(device, its));
    EXPECT_FALSE(totalRange(device, known));

    known.push_back({Parameter::scaling, 0});
    ASSERT_TRUE(scaleOf(device, its));
    EXPECT_EQ(scaleOf(device, its)->resolution(), 8192);
    EXPECT_EQ(scaleOf(device, its)->total(), 33'554'432);
    EXPECT_EQ(speedScaleOf(device, its)->stepsPerTurn, 8192);
    EXPECT_EQ(totalRange(device, known), 33'554'432);
    EXPECT_EQ(scaleAfter(device, {{Parameter::scaling, 1}}, known)->resolution(), 500);

    known.back().value = 1;
    EXPECT_EQ(scaleOf(device, its)->resolution(), 500);
    EXPECT_EQ(totalRange(device, known), 2'048'000);
}

// Its steps are per turn, whatever its revolutions.
TEST(PositionScaleTest, TheSpeedOfASerialEncoderNeedsNoDirection)
{
    const ParameterValues known{
        {Parameter::steps, 500}, {Parameter::revolutions, 16}, {Parameter::scaling, 1}};
    const auto scale = speedScaleOf(describe(u"kuebler-esc-rs485"),
                                    [&](Parameter parameter) { return valueOf(known, parameter); });
    ASSERT_TRUE(scale);
    EXPECT_EQ(scale->stepsPerTurn, 500);
}

} // namespace
} // namespace codewheel
