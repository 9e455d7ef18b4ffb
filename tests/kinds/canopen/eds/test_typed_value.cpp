// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/typed_value.h"

#include <gtest/gtest.h>

namespace codewheel::canopen {
namespace {

using TypedBytes = std::optional<std::vector<std::uint8_t>>;

TypedBytes typed(const char *text, std::optional<DataType> type, std::size_t width = 0)
{
    return octetsTyped(QString::fromUtf8(text), type, width);
}

TEST(TypedValues, AreNumbersOfTheWidthOfTheirType)
{
    EXPECT_EQ(typed("5000", DataType::u32), (TypedBytes({0x88, 0x13, 0, 0})));
    EXPECT_EQ(typed("1388h", DataType::u16), (TypedBytes({0x88, 0x13})));
    EXPECT_EQ(typed("-2", DataType::i16), (TypedBytes({0xFE, 0xFF})));
    EXPECT_EQ(typed("5", DataType::u24), (TypedBytes({5, 0, 0})));
}

TEST(TypedValues, AreAsWideAsTheNodeAnswers)
{
    EXPECT_EQ(typed("5", DataType::u32, 2), (TypedBytes({5, 0})));
    EXPECT_EQ(typed("5", std::nullopt, 1), (TypedBytes(std::vector<std::uint8_t>{5})));
    EXPECT_EQ(typed("5", std::nullopt), std::nullopt);
}

TEST(TypedValues, ThatDoNotFitAreNone)
{
    EXPECT_EQ(typed("256", DataType::u8), std::nullopt);
    EXPECT_EQ(typed("128", DataType::i8), std::nullopt);
    EXPECT_EQ(typed("-129", DataType::i8), std::nullopt);
    EXPECT_EQ(typed("five", DataType::u8), std::nullopt);
    EXPECT_EQ(typed("", DataType::u8), std::nullopt);
}

TEST(TypedValues, AreRealNumbersTextsOrOctets)
{
    EXPECT_EQ(typed("1.5", DataType::real32), (TypedBytes({0, 0, 0xC0, 0x3F})));
    EXPECT_EQ(typed("hoist", DataType::text), (TypedBytes({'h', 'o', 'i', 's', 't'})));
    EXPECT_EQ(typed("01 AB", DataType::octets), (TypedBytes({0x01, 0xAB})));
    EXPECT_EQ(typed("01 A", DataType::octets), std::nullopt);
}

} // namespace
} // namespace codewheel::canopen
