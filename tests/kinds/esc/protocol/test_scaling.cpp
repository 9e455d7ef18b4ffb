// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_scaling.h"

#include <gtest/gtest.h>

namespace codewheel::esc {
namespace {

TEST(EscScaling, FactorOfTheManual)
{
    EXPECT_EQ(rawScalingFactor(8'000, 8'192, 29), 0x1F400000U);
    EXPECT_EQ(factorForSteps(8'000, 29), 0x1F400000U);
    EXPECT_DOUBLE_EQ(scalingFactor(0x1F400000, 29), 0.9765625);
    EXPECT_EQ(rawScalingFactor(1, 1, 29), 0x20000000U);
    EXPECT_DOUBLE_EQ(scalingFactor(0x20000000, 29), 1.0);
}

TEST(EscScaling, ForStepsAndRange)
{
    struct Row
    {
        std::uint32_t steps;
        std::uint32_t factor;
    };
    // steps * 2^29 / 8192
    for (const Row row : {Row{1, 0x10000}, {360, 0x1680000}, {4'096, 0x10000000}, {8'192, 0x20000000}})
        EXPECT_EQ(factorForSteps(row.steps, 29), row.factor);
    EXPECT_EQ(factorForRange(33'554'432, 4'096, 29), 0x20000000U);
    EXPECT_EQ(factorForRange(33'554'431, 4'096, 29), 0x1FFFFFF0U);
    EXPECT_EQ(factorForRange(1'000'000, 4'096, 29), 16'000'000U);
    EXPECT_EQ(factorForRange(8'192, 1, 29), 0x20000000U);
    EXPECT_EQ(factorForRange(1'000, 3, 29), 21'845'333U); // 2^29 * 1000 / 24576 = 21845333.3
    EXPECT_EQ(factorForRange(2'000, 3, 29), 43'690'667U); // .67
}

TEST(EscScaling, NumberOfFractionBitsIsSettable)
{
    EXPECT_EQ(factorForSteps(8'000, 30), 0x3E800000U);
    EXPECT_EQ(factorForSteps(8'192, 30), 0x40000000U);
    EXPECT_EQ(factorForSteps(8'000, 17), 0x1F400U);
    for (const int bits : {-1, 0, 16, 31, 32, 64})
        EXPECT_EQ(factorForSteps(8'000, bits), std::nullopt) << bits;
}

TEST(EscScaling, FactorsLieBetweenAHundredThousandthAndOne)
{
    EXPECT_EQ(rawScalingFactor(1, 100'000, 29), 5'369U); // 5368.7
    EXPECT_EQ(rawScalingFactor(1, 100'001, 29), std::nullopt);
    EXPECT_EQ(rawScalingFactor(0, 1, 29), std::nullopt);
    EXPECT_EQ(rawScalingFactor(1, 0, 29), std::nullopt);
    EXPECT_EQ(rawScalingFactor(8'193, 8'192, 29), std::nullopt);
    EXPECT_EQ(rawScalingFactor(~0ULL, ~0ULL, 29), std::nullopt);
    EXPECT_EQ(rawScalingFactor(1ULL << 32, 1ULL << 32, 30), 0x40000000U);
    EXPECT_EQ(factorForSteps(0, 29), std::nullopt);
    EXPECT_EQ(factorForSteps(8'193, 29), std::nullopt);
    EXPECT_EQ(factorForRange(335, 4'096, 29), std::nullopt); // 335.5 would be one hundred-thousandth
    EXPECT_EQ(factorForRange(336, 4'096, 29), 5'376U);
    EXPECT_EQ(factorForRange(1'000, 0, 29), std::nullopt);
    EXPECT_EQ(factorForRange(1'000, 4'097, 29), std::nullopt);
}

TEST(EscScaling, WhatIsAFactor)
{
    EXPECT_TRUE(isScalingFactor(0x20000000, 29));
    EXPECT_FALSE(isScalingFactor(0x20000001, 29));
    EXPECT_TRUE(isScalingFactor(0x20000001, 30));
    EXPECT_TRUE(isScalingFactor(5'369, 29));
    EXPECT_FALSE(isScalingFactor(5'368, 29));
    EXPECT_FALSE(isScalingFactor(0, 29));
    EXPECT_FALSE(isScalingFactor(0xE0000000, 29)); // -1
    EXPECT_DOUBLE_EQ(scalingFactor(0xE0000000, 29), -1.0);
    EXPECT_FALSE(isScalingFactor(1, 31));
}

TEST(EscScaling, FractionBitsAreDeterminedFromTheDevice)
{
    EXPECT_EQ(fractionBitsFrom(0x1F400000, 8'000, 32'768'000), 29);
    EXPECT_EQ(fractionBitsFrom(0x3E800000, 8'000, 32'768'000), 30);
    EXPECT_EQ(fractionBitsFrom(0x20000000, 8'192, 33'554'432), 29);
    EXPECT_EQ(fractionBitsFrom(0x20000000, 8'191, 33'554'432), 29); // the table's 1..8191
    // With few revolutions, the steps per revolution decide, whatever the range.
    EXPECT_EQ(fractionBitsFrom(0x20000000, 8'192, 16'777'216), 29);
    // One step per revolution decides nothing; the range does.
    EXPECT_EQ(fractionBitsFrom(0x10000, 1, 4'096), 29);
    EXPECT_EQ(fractionBitsFrom(0x10000, 1, 8'192), 28);
}

TEST(EscScaling, FractionBitsThatFitNothingAreNotGuessed)
{
    EXPECT_EQ(fractionBitsFrom(0x1F400000, 5'000, 20'480'000), std::nullopt);
    EXPECT_EQ(fractionBitsFrom(0, 8'192, 33'554'432), std::nullopt);
    EXPECT_EQ(fractionBitsFrom(0x80000000, 8'192, 33'554'432), std::nullopt);
    EXPECT_EQ(fractionBitsFrom(0xFFFFFFFF, 0, 0), std::nullopt);
    EXPECT_EQ(fractionBitsFrom(0x10000, 1, 1'000'000), std::nullopt);
}

TEST(EscScaling, EachStepsPerTurnIsDeterminedWithEachFormat)
{
    for (int bits = fewestFractionBits; bits <= mostFractionBits; ++bits)
        for (std::uint32_t steps = 1; steps <= discSteps; ++steps)
            ASSERT_EQ(fractionBitsFrom(*factorForSteps(steps, bits), steps, steps * discTurns), bits)
                << steps;
}

} // namespace
} // namespace codewheel::esc
