// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/file_value.h"

#include <gtest/gtest.h>

namespace codewheel::canopen {
namespace {

struct NumberRow
{
    const char *written;
    DataType type;
    std::int64_t number;
    std::optional<EdsFault> fault{};
};

class FileNumbers : public testing::TestWithParam<NumberRow>
{};

TEST_P(FileNumbers, AreReadByTheirType)
{
    const NumberRow &row = GetParam();
    const ReadValue read = readFileValue(row.written, row.type);
    ASSERT_TRUE(read.value) << row.written;
    EXPECT_EQ(*read.value, FileValue{row.number}) << row.written;
    EXPECT_EQ(read.fault, row.fault) << row.written;
}

INSTANTIATE_TEST_SUITE_P(
    Eds, FileNumbers,
    testing::Values(NumberRow{"0x10", DataType::u8, 16}, NumberRow{"16", DataType::u8, 16},
                    NumberRow{"0XfF", DataType::u8, 255}, NumberRow{"  7\t", DataType::u16, 7},
                    NumberRow{"-5", DataType::i8, -5}, NumberRow{"-0x8000", DataType::i16, -32768},
                    NumberRow{"0xFF", DataType::i8, -1}, NumberRow{"0x80", DataType::i8, -128},
                    NumberRow{"0x7F", DataType::i8, 127}, NumberRow{"0xFF", DataType::i16, 255},
                    NumberRow{"0xFFFFFF", DataType::i24, -1}, NumberRow{"0xFFFFFFFFFF", DataType::i40, -1},
                    NumberRow{"0xFFFFFFFFFFFFFFF6", DataType::i64, -10},
                    NumberRow{"0xFFFFFFFFFFFFFFFF", DataType::u64, -1}, // the bits
                    NumberRow{"4294967295", DataType::u32, 4'294'967'295},
                    NumberRow{"1", DataType::boolean, 1}, NumberRow{"001", DataType::u8, 1},
                    NumberRow{"09", DataType::u8, 9},
                    NumberRow{"010", DataType::u8, 10, EdsFault::leadingZero},
                    NumberRow{"0x00000010", DataType::u32, 16},
                    NumberRow{"0.0", DataType::i32, 0, EdsFault::fraction},
                    NumberRow{"12.00", DataType::u8, 12, EdsFault::fraction},
                    NumberRow{"0x1234LL", DataType::u64, 0x1234, EdsFault::suffix},
                    NumberRow{"5UL", DataType::u32, 5, EdsFault::suffix}));

struct RefusedRow
{
    const char *written;
    DataType type;
    EdsFault fault;
};

class FileNumbersRefused : public testing::TestWithParam<RefusedRow>
{};

TEST_P(FileNumbersRefused, CountAsNotStated)
{
    const RefusedRow &row = GetParam();
    const ReadValue read = readFileValue(row.written, row.type);
    EXPECT_FALSE(read.value) << row.written;
    EXPECT_EQ(read.fault, row.fault) << row.written;
}

INSTANTIATE_TEST_SUITE_P(Eds, FileNumbersRefused,
                         testing::Values(RefusedRow{"256", DataType::u8, EdsFault::doesNotFit},
                                         RefusedRow{"-1", DataType::u32, EdsFault::doesNotFit},
                                         RefusedRow{"0x100", DataType::i8, EdsFault::doesNotFit},
                                         RefusedRow{"128", DataType::i8, EdsFault::doesNotFit},
                                         RefusedRow{"-129", DataType::i8, EdsFault::doesNotFit},
                                         RefusedRow{"2", DataType::boolean, EdsFault::doesNotFit},
                                         RefusedRow{"0x10000000000000000", DataType::u64,
                                                    EdsFault::doesNotFit},
                                         RefusedRow{"none", DataType::u8, EdsFault::notANumber},
                                         RefusedRow{"0x", DataType::u8, EdsFault::notANumber},
                                         RefusedRow{"0xG", DataType::u8, EdsFault::notANumber},
                                         RefusedRow{"1.5", DataType::u8, EdsFault::notANumber},
                                         RefusedRow{"-", DataType::u8, EdsFault::notANumber},
                                         RefusedRow{"LL", DataType::u8, EdsFault::notANumber},
                                         RefusedRow{"nan", DataType::real32, EdsFault::notANumber},
                                         RefusedRow{"0x180-$NODEID", DataType::u32, EdsFault::notANumber},
                                         RefusedRow{"$NODEID+", DataType::u32, EdsFault::notANumber}));

class NodesAdded : public testing::TestWithParam<NumberRow>
{};

TEST_P(NodesAdded, InAnyFormAndOrder)
{
    const ReadValue read = readFileValue(GetParam().written, DataType::u32);
    ASSERT_TRUE(read.value) << GetParam().written;
    EXPECT_EQ(*read.value, (FileValue{GetParam().number, true})) << GetParam().written;
    EXPECT_FALSE(read.fault);
}

INSTANTIATE_TEST_SUITE_P(
    Eds, NodesAdded,
    testing::Values(NumberRow{"$NODEID+0x180", {}, 384}, NumberRow{"$NODEID + 384", {}, 384},
                    NumberRow{"$NodeID +384", {}, 384}, NumberRow{"0x180+$NODEID", {}, 384},
                    NumberRow{"1280 + $nodeid", {}, 1280}, NumberRow{"$NODEID+0x40000180", {}, 0x4000'0180},
                    NumberRow{"$NODEID+0xC0000080", {}, 0xC000'0080}, NumberRow{"$NODEID", {}, 0}));

TEST(FileValues, OfTheNodeAreWrittenAlikeAndResolved)
{
    const FileValue value = *readFileValue("0x180 + $NODEID", DataType::u32).value;
    EXPECT_EQ(value.text(DataType::u32).toStdString(), "$NODEID+384");
    EXPECT_EQ(value.at(5), FileValue{std::int64_t{389}});
    EXPECT_FALSE(value.at({}));
    EXPECT_EQ(FileValue{std::int64_t{7}}.at({}), FileValue{std::int64_t{7}});
}

TEST(FileValues, OfTextsLoseTheirQuotesAndAreNoNumbers)
{
    const auto text = [](const char *written, DataType type) {
        return readFileValue(written, type).value->text(type).toStdString();
    };
    EXPECT_EQ(text("\"Encoder 1\"", DataType::text), "Encoder 1");
    EXPECT_EQ(text("1.0", DataType::text), "1.0");
    EXPECT_EQ(text("0000000000000000", DataType::octets), "0000000000000000");
    EXPECT_EQ(text("$NODEID+1", DataType::text), "$NODEID+1");
    EXPECT_EQ(text("\"", DataType::text), "\"");
}

TEST(FileValues, OfRealTypesMayHaveFractions)
{
    EXPECT_EQ(readFileValue("1.5", DataType::real32).value, FileValue{1.5});
    EXPECT_EQ(readFileValue("-2e3", DataType::real64).value, FileValue{-2000.0});
    EXPECT_EQ(FileValue{0.25}.text(DataType::real32).toStdString(), "0.25");
}

TEST(FileValues, BlankOnesAreNotStated)
{
    const ReadValue read = readFileValue(" \t ", DataType::u8);
    EXPECT_FALSE(read.value);
    EXPECT_FALSE(read.fault);
}

TEST(FileValues, OfAnUnknownTypeAreNumbersOrTexts)
{
    EXPECT_EQ(readFileValue("0x10", {}).value, FileValue{std::int64_t{16}});
    EXPECT_EQ(readFileValue("-3", {}).value, FileValue{std::int64_t{-3}});
    EXPECT_EQ(readFileValue("save", {}).value, FileValue{QStringLiteral("save")});
    EXPECT_EQ(readFileValue("0xFFFFFFFFFFFFFFFF", {}).fault, EdsFault::doesNotFit);
}

TEST(FileValues, OfSixtyFourBitsAreWrittenWhole)
{
    const FileValue value = *readFileValue("0xFFFFFFFFFFFFFFFF", DataType::u64).value;
    EXPECT_EQ(value.text(DataType::u64).toStdString(), "18446744073709551615");
}

} // namespace
} // namespace codewheel::canopen
