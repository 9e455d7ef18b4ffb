// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain_table.h"
#include "kinds/interbus/words/position_word.h"

#include <random>

namespace codewheel::position_word {
namespace {

constexpr PositionWord k1{.positionBits = 12}; // FRABA manual 2.1.1: 12-bit single-turn encoder
constexpr PositionWord k2{.positionBits = 24}; // FRABA manual 2.1.2: 24-bit multi-turn encoder
constexpr PositionWord k4{.hasStatusBits = true, .hasOut = true};

struct Row
{
    Word in;
    PositionWord format;
    Meaning means;
};

TEST(PositionWord, IsRightJustifiedAndBinary)
{
    const Row rows[] = {
        {0x0000'0000, k1, {MeaningId::position, {0}}},
        {0x0000'0FFF, k1, {MeaningId::position, {4095}}},
        {0x0000'1000, k1, {MeaningId::unusedBitsSet, {0x1000, 12}}},
        {0x0000'F123, k1, {MeaningId::unusedBitsSet, {0xF000, 12}}},
        {0x00FF'FFFF, k2, {MeaningId::position, {16'777'215}}},
        {0x0001'2A4F, k2, {MeaningId::position, {76'367}}},
        {0x8100'0001, k2, {MeaningId::unusedBitsSet, {0x8100'0000, 24}}},
        {0xFFFF'FFFF, k4, {MeaningId::undescribedPosition, {4'294'967'295}}},
        {0x0001'2A4F, k4, {MeaningId::undescribedPosition, {76'367}}},
    };
    for (const Row &row : rows) {
        EXPECT_EQ(explain(row.in, WordDirection::in, row.format), row.means) << std::hex << row.in;
        const bool none = row.means.id == MeaningId::unusedBitsSet;
        EXPECT_EQ(position(row.in, row.format), none ? std::nullopt : std::optional(row.means.number[0]));
    }
}

TEST(PositionWord, IsDecodedAsDescribed)
{
    const auto coded = [](PositionCoding coding, int bits) {
        return PositionWord{.positionBits = bits, .coding = coding};
    };
    const Row rows[] = {
        {0x0000'0214, coded(PositionCoding::gray, 12), {MeaningId::grayPosition, {999, 0x214}}},
        {0x0000'0800, coded(PositionCoding::gray, 12), {MeaningId::grayPosition, {4095, 0x800}}},
        {0x0080'0000, coded(PositionCoding::gray, 24), {MeaningId::grayPosition, {16'777'215, 0x80'0000}}},
        {0x8000'0000,
         coded(PositionCoding::gray, 32),
         {MeaningId::grayPosition, {4'294'967'295, 0x8000'0000}}},
        {0x0000'07FF, coded(PositionCoding::signedBinary, 12), {MeaningId::signedPosition, {2047}}},
        {0x0000'0800, coded(PositionCoding::signedBinary, 12), {MeaningId::signedPosition, {-2048}}},
        {0x0000'FFFF, coded(PositionCoding::signedBinary, 16), {MeaningId::signedPosition, {-1}}},
        {0x8000'0000, coded(PositionCoding::signedBinary, 32), {MeaningId::signedPosition, {-2'147'483'648}}},
        {0xFFFF'F800, coded(PositionCoding::signedBinary, 12), {MeaningId::unusedBitsSet, {0xFFFF'F000, 12}}},
    };
    for (const Row &row : rows)
        EXPECT_EQ(explain(row.in, WordDirection::in, row.format), row.means) << std::hex << row.in;
}

TEST(PositionWord, OutIsSaidToBeMissingOrUndescribed)
{
    EXPECT_EQ(explain(0x0200'00FF, WordDirection::out, k1), (Meaning{MeaningId::noOutWord, {0x0200'00FF}}));
    EXPECT_EQ(explain(0x0000'0000, WordDirection::out, k2), (Meaning{MeaningId::noOutWord, {0}}));
    EXPECT_EQ(explain(0x4000'0000, WordDirection::out, k4),
              (Meaning{MeaningId::undescribedOut, {0x4000'0000}}));
}

// Whatever the word: the position is within the range of its bits, or there is none.
TEST(PositionWord, StaysInItsRange)
{
    std::mt19937 random(71); // seeded: the same words in each run
    for (int i = 0; i < 200'000; ++i) {
        const int bits = 1 + static_cast<int>(random() % 32);
        const auto coding = static_cast<PositionCoding>(random() % 3);
        const Word in = static_cast<Word>(random()) >> random() % 32;
        const auto steps = position(in, {.positionBits = bits, .coding = coding});
        const std::int64_t range = std::int64_t{1} << bits;
        EXPECT_EQ(steps.has_value(), in < range) << std::hex << in;
        if (!steps)
            continue;
        const std::int64_t lowest = coding == PositionCoding::signedBinary ? -range / 2 : 0;
        EXPECT_GE(*steps, lowest) << std::hex << in;
        EXPECT_LT(*steps, lowest + range) << std::hex << in;
    }
}

} // namespace
} // namespace codewheel::position_word
