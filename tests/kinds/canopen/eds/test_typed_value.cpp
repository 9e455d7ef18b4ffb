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

// Each of these may stand for two values, or for half of one.
TEST(TypedValues, ThatAreWrittenAnotherWayAreNone)
{
    for (const char *text : {"1.000", "1,5", "0x", "h", "-", "--1", "1 000", "1e3", "12 34h", "+", "5-"})
        EXPECT_EQ(typed(text, DataType::u32), std::nullopt) << text;
    for (const char *text : {"1,5", "1.2.3", "inf", "nan", "1e39", "-"})
        EXPECT_EQ(typed(text, DataType::real32), std::nullopt) << text;
}

TEST(TypedValues, WithASignAreForSignedTypesOnly)
{
    EXPECT_EQ(typed("-1", DataType::u16), std::nullopt);
    EXPECT_EQ(typed("-1", DataType::i16), (TypedBytes({0xFF, 0xFF})));
    EXPECT_EQ(typed("-1", std::nullopt, 2), (TypedBytes({0xFF, 0xFF}))) << "its type is not known";
}

TEST(LimitsOfAFile, AreComparedByTheTypeOfTheObject)
{
    const auto number = [](std::int64_t value) { return FileValue{value}; };
    FileObject object{.type = DataType::u64, .minimum = number(1), .maximum = number(-1)};
    EXPECT_EQ(limitBroken(object, number(5), {}), std::nullopt) << "up to FFFFFFFFFFFFFFFFh";
    EXPECT_EQ(limitBroken(object, number(0), {}), number(1));
    object = {.type = DataType::i16, .minimum = number(-5), .maximum = number(5)};
    EXPECT_EQ(limitBroken(object, number(-6), {}), number(-5));
    EXPECT_EQ(limitBroken(object, number(6), {}), number(5));
    object = {.type = DataType::real32, .maximum = FileValue{1.5}};
    EXPECT_EQ(limitBroken(object, FileValue{1.6}, {}), FileValue{1.5});
    EXPECT_EQ(limitBroken(object, FileValue{1.0}, {}), std::nullopt);
    object = {.type = DataType::u16, .maximum = FileValue{std::int64_t{0x180}, true}};
    EXPECT_EQ(limitBroken(object, number(0x186), 6), std::nullopt) << "$NODEID+0x180";
    EXPECT_EQ(limitBroken(object, number(0x187), 6), number(0x186));
    EXPECT_EQ(limitBroken(object, number(0x187), {}), std::nullopt) << "the number of the node is not known";
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
