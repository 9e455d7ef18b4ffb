// SPDX-License-Identifier: GPL-3.0-or-later
#include "handshake_rows.h"
#include "kinds/interbus/simulator/encoder_arithmetic.h"
#include "kinds/interbus/words/k3_word.h"
#include "kinds/interbus/words/position_code.h"

#include <gtest/gtest.h>
#include <random>

namespace codewheel {
namespace {

// Baumer 5, preset: total 1000, API 300, preset 100 give NPV 800 and PI 100.
TEST(EncoderArithmetic, PresetInitialisationFindsTheZeroOffset)
{
    ParameterSet set{.steps = 200, .revolutions = 1, .preset = 100, .measuringRange = 5};
    const std::int64_t raw = 300 * 8192 / 200; // API 300
    const EncoderArithmetic before(set, thirteenPlusTwelve);
    EXPECT_EQ(before.total(), 1000);
    EXPECT_EQ(before.absoluteValue(raw), 300);
    EXPECT_EQ(before.zeroOffsetForPreset(raw), 800);

    set.zeroOffset = 800;
    EXPECT_EQ(EncoderArithmetic(set, thirteenPlusTwelve).processValue(raw), 100);
    set.offset = 950;
    EXPECT_EQ(EncoderArithmetic(set, thirteenPlusTwelve).processValue(raw), 50); // PW + O, mod total
}

struct CodedRow
{
    std::int64_t coding;
    std::int64_t raw;
    Word coded;
};

// Baumer 5, measuring range: 200 steps, 5 turns: 0..999 unsigned, -500..499 signed
TEST(EncoderArithmetic, CodesAsTheManualTells)
{
    constexpr std::int64_t last = 5 * 8192 - 1; // x = 999
    constexpr std::int64_t half = 5 * 8192 / 2; // x = 500
    const CodedRow rows[] = {
        {3, 0, 0},
        {3, last, 999},
        {3, last + 1, 0}, // unsigned CW
        {4, 0, 999},
        {4, last, 0}, // unsigned CCW
        {1, 0, 0},
        {1, half - 1, 499},
        {1, half, 0x01FF'FE0C}, // signed CW: -500
        {1, last, 0x01FF'FFFF}, // -1
        {2, 0, 0x01FF'FFFF},
        {2, half, 499},
        {2, half - 1, 0x01FF'FE0C},
        {2, last, 0},
        {5, 0, 0},
        {5, half, 0x10E},
        {5, last, 0x214}, // 500, 999 in Gray
        {6, last, 0},
        {6, 0, 0x214},
    };
    for (const CodedRow &row : rows) {
        const ParameterSet set{.steps = 200, .revolutions = 1, .coding = row.coding, .measuringRange = 5};
        EXPECT_EQ(EncoderArithmetic(set, thirteenPlusTwelve).codedValue(row.raw), row.coded)
            << "coding " << row.coding << ", raw " << row.raw;
    }
}

TEST(EncoderArithmetic, SplitsAnOddTotalRangeInTheMiddle)
{
    const ParameterSet set{.steps = 5, .revolutions = 1, .coding = 1, .measuringRange = 1}; // -2..2
    const EncoderArithmetic arithmetic(set, {5, 1});
    const Word expected[] = {0, 1, 2, 0x01FF'FFFE, 0x01FF'FFFF};
    for (int raw = 0; raw < 5; ++raw)
        EXPECT_EQ(arithmetic.codedValue(raw), expected[raw]) << raw;
}

// 1000 steps and 3 revolutions give 333.33 steps per turn.
TEST(EncoderArithmetic, ScalesByAFraction)
{
    const ParameterSet set{.steps = 1000, .revolutions = 3};
    const EncoderArithmetic arithmetic(set, thirteenPlusTwelve);
    EXPECT_EQ(arithmetic.total(), 1'365'333);
    EXPECT_EQ(arithmetic.absoluteValue(8192), 333);
    EXPECT_EQ(arithmetic.absoluteValue(16'384), 666);
    EXPECT_EQ(arithmetic.absoluteValue(24'575), 999);
    EXPECT_EQ(arithmetic.absoluteValue(24'576), 1000);
}

TEST(EncoderArithmetic, IsTheFloorOfTheExactQuotient)
{
    std::mt19937_64 random(71);
    for (int i = 0; i < 300'000; ++i) {
        ParameterSet set;
        set.revolutions = 1 + static_cast<std::int64_t>(random() % 4096);
        set.steps = 1 + static_cast<std::int64_t>(random() % (1U << (1 + random() % 25)));
        if (!isAdmissible(set, thirteenPlusTwelve))
            continue;
        // Rounding would show at multiples of the divisor.
        const std::int64_t edge = static_cast<std::int64_t>(random() % 4096) * 8192;
        for (const std::int64_t raw : {edge, edge + 8191, static_cast<std::int64_t>(random() % (1U << 25))}) {
            const std::int64_t exact = raw * set.steps / (set.revolutions * 8192) % totalRange(set);
            ASSERT_EQ(EncoderArithmetic(set, thirteenPlusTwelve).absoluteValue(raw), exact)
                << set.steps << " / " << set.revolutions << " at " << raw;
        }
    }
}

// The driver decodes what the encoder codes: the process value in each coding, over all admissible totals.
TEST(EncoderArithmetic, ACodedPositionDecodesToTheProcessValue)
{
    std::mt19937_64 random(71);
    const auto below = [&random](std::int64_t limit) {
        return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(limit));
    };
    for (int i = 0; i < 300'000; ++i) {
        ParameterSet set{.coding = 1 + below(6), .measuringRange = 1 + below(4096)};
        set.steps = 1 + below(std::int64_t{1} << (1 + below(14)));
        if (!isAdmissible(set, thirteenPlusTwelve))
            continue;
        set.zeroOffset = below(totalRange(set));
        const EncoderArithmetic arithmetic(set, thirteenPlusTwelve);
        for (const std::int64_t raw : {std::int64_t{0}, below(1 << 25), std::int64_t{(1 << 25) - 1}}) {
            const std::int64_t value = arithmetic.processValue(raw);
            const PositionCoding coding = set.coding <= 2   ? PositionCoding::signedBinary
                                          : set.coding <= 4 ? PositionCoding::binary
                                                            : PositionCoding::gray;
            const std::int64_t decoded = k3::decodePosition(arithmetic.codedValue(raw), coding);
            ASSERT_EQ(decoded < 0 ? decoded + arithmetic.total() : decoded, value);
            ASSERT_GE(decoded, -arithmetic.total() / 2);
            if (coding == PositionCoding::signedBinary) {
                ASSERT_LT(decoded, (arithmetic.total() + 1) / 2);
            }
        }
    }
}

struct AdmissibleRow
{
    ParameterSet set;
    bool admissible;
};

TEST(ParameterSet, IsAdmissibleWithinTheLimitsOfTheEncoder)
{
    const AdmissibleRow rows[] = {
        {{}, true},
        {{.steps = 8193}, false}, // more than the disc has
        {{.steps = 8193, .revolutions = 2}, true},
        {{.steps = 0}, false},
        {{.revolutions = 0}, false},
        {{.revolutions = 4097}, false},
        {{.steps = 16'384, .revolutions = 2}, true}, // 33554432 in all
        {{.coding = 0}, false},
        {{.coding = 7}, false},
        {{.measuringRange = 0}, false},
        {{.measuringRange = 4097}, false},
        {{.steps = 1, .revolutions = 2, .measuringRange = 1}, false}, // leaves nothing
        {{.steps = 200, .preset = 999, .measuringRange = 5}, true},
        {{.steps = 200, .preset = 1000, .measuringRange = 5}, false},
        {{.steps = 200, .offset = 1000, .measuringRange = 5}, false},
    };
    for (std::size_t i = 0; i < std::size(rows); ++i)
        EXPECT_EQ(isAdmissible(rows[i].set, thirteenPlusTwelve), rows[i].admissible) << "row " << i;
    EXPECT_FALSE(isAdmissible({.steps = 16'384, .revolutions = 1}, {65'536, 4096})); // above 25 bits
}

} // namespace
} // namespace codewheel
