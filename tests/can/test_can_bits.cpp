// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_bits.h"

#include <gtest/gtest.h>
#include <random>

namespace codewheel {
namespace {

struct BitsRow
{
    CanFrame frame;
    std::uint16_t crc;
    int bits;
};

// The remainders are those of a long division by 1100010110011001 of the bits, written out.
const BitsRow bitsRows[] = {
    {{.id = 0x000}, 0x0000, 50},
    {{.id = 0x080}, 0x1C05, 48},
    {{.id = 0x014, .length = 1, .bytes = {0x01}}, 0x7753, 55},
    {{.id = 0x705, .length = 1, .bytes = {0x05}}, 0x68BF, 56},
    {{.id = 0x705, .isRemote = true, .length = 1}, 0x3435, 46},
    {{.id = 0x123, .length = 4, .bytes = {0xDE, 0xAD, 0xBE, 0xEF}}, 0x4E6B, 78},
    {{.id = 0x185, .length = 4, .bytes = {0x88, 0x13}}, 0x65F9, 81},
    {{.id = 0x605, .length = 8, .bytes = {0x40, 0x18, 0x10, 0x01}}, 0x3798, 119},
    {{.id = 0x000, .length = 8}, 0x145B, 124},
    {{.id = 0x7FF, .length = 8, .bytes = {0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}}, 0x4C89, 123},
    {{.id = 0x555, .length = 8, .bytes = {0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55}}, 0x1B04, 109},
    {{.id = 0x15555555, .isExtended = true}, 0x3196, 65},
    {{.id = 0x15555555, .isExtended = true, .isRemote = true, .length = 8}, 0x3654, 64},
    {{.id = 0x0CFFE0E0, .isExtended = true, .length = 8, .bytes = {1, 2, 3, 4, 5, 6, 7, 8}}, 0x221B, 140},
    {{.id = 0x00000000, .isExtended = true, .length = 8}, 0x3DAF, 147},
};

TEST(CanBits, CrcAndBitsAreThoseOfTheWire)
{
    for (const BitsRow &row : bitsRows) {
        SCOPED_TRACE(testing::Message() << std::hex << row.frame.id << " [" << int(row.frame.length) << ']');
        EXPECT_EQ(canCrc(row.frame), row.crc);
        EXPECT_EQ(canBits(row.frame), row.bits);
    }
}

// Davis, Burns, Bril, Lukkien 2007: at most 55 + 10 s and 80 + 10 s bits, with the 3 that follow.
TEST(CanBits, NoFrameIsLongerThanTheBoundOfTheLiterature)
{
    std::mt19937 random(7);
    const std::uint8_t patterns[] = {0x00, 0xFF, 0x0F, 0xF0, 0x3C, 0xC3, 0x1E, 0xE1, 0x78, 0x87};
    for (int i = 0; i < 20'000; ++i) {
        CanFrame frame{.isExtended = i % 2 == 1, .length = static_cast<std::uint8_t>(random() % 9)};
        frame.id =
            static_cast<std::uint32_t>(random()) & (frame.isExtended ? largestExtendedId : largestStandardId);
        for (std::uint8_t &byte : frame.bytes)
            byte = patterns[random() % std::size(patterns)];
        EXPECT_LE(canBits(frame) + canIntermission, (frame.isExtended ? 80 : 55) + 10 * frame.length);
    }
}

TEST(CanBits, PrecedenceIsThatOfArbitration)
{
    const CanFrame inOrder[] = {
        {.id = 0x000},
        {.id = 0x000, .isRemote = true},
        {.id = 0x0000'0000, .isExtended = true},
        {.id = 0x0000'0000, .isExtended = true, .isRemote = true},
        {.id = 0x0000'0001, .isExtended = true},
        {.id = 0x0003'FFFF, .isExtended = true},
        {.id = 0x001},
        {.id = 0x0004'0000, .isExtended = true}, // base 001h
        {.id = 0x185},
        {.id = 0x185, .isRemote = true},
        {.id = 0x0614'0000, .isExtended = true}, // base 185h
        {.id = 0x186},
        {.id = 0x7FF},
        {.id = 0x1FFF'FFFF, .isExtended = true},
    };
    for (std::size_t i = 1; i < std::size(inOrder); ++i)
        EXPECT_LT(canPrecedence(inOrder[i - 1]), canPrecedence(inOrder[i])) << i;
}

} // namespace
} // namespace codewheel
