// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/gear_calculator.h"

#include <cmath>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

struct Row
{
    const char *what;
    Gear gear;
    std::int64_t steps;
    std::int64_t revolutions;
    double error; // mm over 4096 turns
};

class GearTable : public testing::TestWithParam<Row>
{};

TEST_P(GearTable, ComesClosestWithTheFewestRevolutions)
{
    const Row &row = GetParam();
    const auto result = stepsForGear(row.gear, {.physicalStepsPerTurn = 8192, .turns = 4096});
    ASSERT_TRUE(result) << row.what;
    EXPECT_EQ(result->steps, row.steps) << row.what;
    EXPECT_EQ(result->revolutions, row.revolutions) << row.what;
    EXPECT_NEAR(result->errorOverTravel, row.error, 1e-6) << row.what;
}

INSTANTIATE_TEST_SUITE_P(
    Machines, GearTable,
    testing::Values(Row{"spindle 10 mm, 0.01 mm", {10, 1, 1, 0.01}, 1000, 1, 0},
                    Row{"1000 steps in 3 revolutions", {10, 3, 1, 0.01}, 1000, 3, 0},
                    Row{"gear 7 : 2", {5, 7, 2, 0.001}, 10'000, 7, 0},
                    Row{"coarser than a turn: 1 step in 4 revolutions", {1, 4, 1, 1}, 1, 4, 0},
                    Row{"as fine as the disc", {8192, 1, 1, 1}, 8192, 1, 0}));

TEST(GearCalculator, ErrorOverTheRangeIsTheDifferenceAtItsFarEnd)
{
    const double pi = std::acos(-1.0);
    const auto result = stepsForGear({pi * 100, 1, 1, 0.1}, {.physicalStepsPerTurn = 8192, .turns = 4096});
    ASSERT_TRUE(result);
    const double perTurn = static_cast<double>(result->steps) / static_cast<double>(result->revolutions);
    EXPECT_NEAR(result->errorOverTravel, (perTurn - 1000 * pi) * 4096 * 0.1, 1e-6);
    EXPECT_LT(std::abs(result->errorOverTravel), 0.1); // better than a step
    EXPECT_NEAR(result->travel, pi * 100 * 4096, 1e-6);
}

TEST(GearCalculator, FinerThanTheEncoderCanIsRefused)
{
    EXPECT_FALSE(
        stepsForGear({10, 1, 1, 0.001}, {.physicalStepsPerTurn = 8192, .turns = 4096})); // 10 000 a turn
    EXPECT_FALSE(stepsForGear({10, 1, 1, 0.001}, {.turns = 4096})); // total range above 25 bit
    EXPECT_TRUE(stepsForGear({10, 1, 1, 0.001}, {.turns = 1024}));
}

TEST(GearCalculator, InputWithoutSenseGivesNothing)
{
    const Gear bad[] = {{0, 1, 1, 1},  {10, 0, 1, 1},  {10, 1, -1, 1},
                        {10, 1, 1, 0}, {NAN, 1, 1, 1}, {10, 1, 1, INFINITY}};
    for (const Gear &gear : bad)
        EXPECT_FALSE(stepsForGear(gear, {}));
}

} // namespace
} // namespace codewheel
