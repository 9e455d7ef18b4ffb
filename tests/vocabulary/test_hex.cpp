// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/hex.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(Hex, WordsAreWrittenWithEightUpperCaseDigits)
{
    EXPECT_EQ(hexWord(0), QStringLiteral("00000000"));
    EXPECT_EQ(hexWord(0x0200'00FF), QStringLiteral("020000FF"));
    EXPECT_EQ(hexWord(0xFFFF'FFFF), QStringLiteral("FFFFFFFF"));
}

TEST(Hex, WordsAreReadInEverySpellingOfTheTrade)
{
    for (const QStringView text :
         {u"020000FF", u"20000ff", u"0x20000ff", u"0X020000FF", u"20000FFh", u"20000FFH", u" 0200 00FF ",
          u"02 00 00 FF", u"0200 00FF h", u"0x 0200 00FF"})
        EXPECT_EQ(parseHexWord(text), 0x0200'00FFu) << text.toString().toStdString();
    for (const auto text : {u"16#020000FF", u"16#0200_00FF", u"16#0200 16#00ff", u"16#200 16#FF"})
        EXPECT_EQ(parseHexWord(text), 0x0200'00FFu);
    for (const auto text : {u"0200_00FF", u"16#", u"16#20000 16#FF", u"0200 16#00FF", u"16#0200 16#"})
        EXPECT_FALSE(parseHexWord(text));
    EXPECT_EQ(parseHexWord(u"0"), 0u);
    EXPECT_EQ(parseHexWord(u"FFFFFFFF"), 0xFFFF'FFFFu);
}

TEST(Hex, AnythingElseIsNoWord)
{
    for (const QStringView text :
         {u"",   u"  ", u"h",    u"0x",  u"0x h", u"xyz",   u"12G4",   u"0200000FF", u"0x000000000", u"0x20h",
          u"+1", u"-1", u"0x-1", u"1.0", u"1,0",  u"0 x20", u"\u0661", u"0x0x1",     u"1hh",         u"#FF"})
        EXPECT_FALSE(parseHexWord(text)) << text.toString().toStdString();
}

TEST(Hex, NumbersAreDecimalUnlessMarkedAsHex)
{
    EXPECT_EQ(parseNumber(u"255"), 255);
    EXPECT_EQ(parseNumber(u" 0010 "), 10);
    EXPECT_EQ(parseNumber(u"0xff"), 255);
    EXPECT_EQ(parseNumber(u"FFh"), 255);
    EXPECT_EQ(parseNumber(u"10h"), 16);
    EXPECT_EQ(parseNumber(u"999999999999999999"), 999'999'999'999'999'999);
    EXPECT_EQ(parseNumber(u"0xFFFFFFFFFFFFFFF"), 0xFFF'FFFF'FFFF'FFFF);
}

TEST(Hex, AnythingElseIsNoNumber)
{
    for (const QStringView text : {u"", u" ", u"FF", u"h", u"0x", u"0x10h", u"+5", u"-5", u"1 000", u"1.5",
                                   u"1e3", u"1000000000000000000", u"0x1000000000000000", u"\u0661"})
        EXPECT_FALSE(parseNumber(text)) << text.toString().toStdString();
}

} // namespace
} // namespace codewheel
