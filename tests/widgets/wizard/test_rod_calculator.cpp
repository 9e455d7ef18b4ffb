// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/rod_calculator.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace codewheel {
namespace {

constexpr std::int64_t most = 0xFF'FFFF;

// LA-66 manual 3.2
TEST(RodCalculator, MeasuringLengthIsLengthByResolution)
{
    EXPECT_EQ(stepsForRod(500, 0.01, most)->steps, 0xC350);
    EXPECT_EQ(stepsForRod(500, 0.1, most)->steps, 0x1388);
    EXPECT_EQ(stepsForRod(500, 0.1, most)->errorOverLength, 0);
}

TEST(RodCalculator, TellsWhatRoundingCosts)
{
    const auto result = stepsForRod(500, 0.03, most); // 16666.67
    ASSERT_TRUE(result);
    EXPECT_EQ(result->steps, 16'667);
    EXPECT_NEAR(result->mmPerStep, 500.0 / 16'667, 1e-12);
    EXPECT_NEAR(result->errorOverLength, 0.01, 1e-9); // 16667 steps of 0.03 mm are 500.01 mm
}

TEST(RodCalculator, WhatTheEncoderCannotHoldHasNoAnswer)
{
    EXPECT_TRUE(stepsForRod(16'777'215, 1, most));
    EXPECT_FALSE(stepsForRod(16'777'216, 1, most));
    EXPECT_FALSE(stepsForRod(1, 3, most)) << "not one step";
    for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_FALSE(stepsForRod(bad, 0.01, most)) << bad;
        EXPECT_FALSE(stepsForRod(500, bad, most)) << bad;
    }
}

} // namespace
} // namespace codewheel
