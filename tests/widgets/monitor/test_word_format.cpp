// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/word_format.h"

#include <QLocale>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

struct NumberRow
{
    Word word;
    int bits;
    const char *decimal;
    const char *signedDecimal;
    const char *gray;
};

// Gray code: 1, 3, 2, 6 are 1, 2, 3, 4.
constexpr NumberRow numberRows[] = {
    {0x00000000, 25, "0", "0", "0"},
    {0x020000FF, 25, "255", "255", "170"},
    {0x020000FF, 32, "33554687", "33554687", "67108693"},
    {0x00000003, 25, "3", "3", "2"},
    {0x00000002, 25, "2", "2", "3"},
    {0x00000006, 25, "6", "6", "4"},
    {0x00FFFFFF, 25, "16777215", "16777215", "11184810"},
    {0x01000000, 25, "16777216", "-16777216", "33554431"},
    {0x01FFFFFF, 25, "33554431", "-1", "22369621"},
    {0xFFFFFFFF, 25, "33554431", "-1", "22369621"},
    {0x80000000, 32, "2147483648", "-2147483648", "4294967295"},
    {0xFFFFFFFF, 32, "4294967295", "-1", "2863311530"},
    {0x12348001, 16, "32769", "-32767", "65534"},
};

TEST(WordFormat, WritesNumbersOfTheLowBits)
{
    for (const NumberRow &row : numberRows) {
        SCOPED_TRACE(testing::Message() << std::hex << row.word << " of bits " << std::dec << row.bits);
        EXPECT_EQ(decimalText(row.word, row.bits).toStdString(), row.decimal);
        EXPECT_EQ(signedText(row.word, row.bits).toStdString(), row.signedDecimal);
        EXPECT_EQ(grayText(row.word, row.bits).toStdString(), row.gray);
    }
}

TEST(WordFormat, NumbersCarryNoGroupSeparators)
{
    QLocale::setDefault(QLocale(QLocale::German));
    EXPECT_EQ(decimalText(0x01FFFFFF, 25), QStringLiteral("33554431"));
    EXPECT_EQ(signedText(0x01000000, 25), QStringLiteral("-16777216"));
    QLocale::setDefault(QLocale::c());
}

TEST(WordFormat, WritesBinaryByNibbles)
{
    EXPECT_EQ(binaryText(0x020000FF, 32), QStringLiteral("0000 0010 0000 0000 0000 0000 1111 1111"));
    EXPECT_EQ(binaryText(0x1234800F, 16), QStringLiteral("1000 0000 0000 1111"));
}

TEST(WordFormat, WritesTheTwoWordsOfAPlcHighWordFirst)
{
    EXPECT_EQ(copiedText(0x020000FF, 32, WordNotation::hexadecimal), QStringLiteral("020000FF"));
    EXPECT_EQ(copiedText(0x020000FF, 32, WordNotation::plc), QStringLiteral("16#0200_00FF"));
    EXPECT_EQ(copiedText(0x020000FF, 32, WordNotation::plcWords), QStringLiteral("16#0200 16#00FF"));
    EXPECT_EQ(copiedText(0x020000FF, 32, WordNotation::decimal), QStringLiteral("33554687"));
    EXPECT_EQ(copiedText(0x02FF, 16, WordNotation::plc), QStringLiteral("16#02FF"));
    EXPECT_EQ(copiedText(0x02FF, 16, WordNotation::plcWords), QStringLiteral("16#02FF"));
    EXPECT_EQ(copiedText(0x02FF, 16, WordNotation::binary), QStringLiteral("2#0000_0010_1111_1111"));
}

TEST(WordFormat, SaysWhatIsWrongWithAHexadecimalWord)
{
    for (const char *good : {"020000FF", "0x20000ff", "20000FFh", "0200 00FF", "0"})
        EXPECT_TRUE(hexProblem(QString::fromLatin1(good)).isEmpty()) << good;
    EXPECT_TRUE(
        hexProblem(QStringLiteral("02XY")).startsWith(QLatin1String("\"02XY\" is not a hexadecimal word.")));
    EXPECT_TRUE(hexProblem(QStringLiteral("-1")).contains(QLatin1String("0 to 9 and A to F")));
    EXPECT_TRUE(hexProblem(QStringLiteral("0200000FF")).contains(QLatin1String("has 9 digits")));
    EXPECT_TRUE(hexProblem(QStringLiteral("  ")).startsWith(QLatin1String("There is no word here.")));
}

} // namespace
} // namespace codewheel
