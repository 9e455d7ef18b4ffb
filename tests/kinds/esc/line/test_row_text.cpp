// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/row_text.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

const QByteArray requested = "\x1B" + QByteArray("05P\r\n");

TEST(EscLineRowText, ShowsControlCharactersAndBytesThatAreNoAscii)
{
    EXPECT_EQ(controlText(requested), QStringLiteral("\u241B05P\u240D\u240A"));
    EXPECT_EQ(controlText(QByteArray("\x00\x7F\x80\xFF~", 5)), QStringLiteral("\u2400\u2421<80><FF>~"));
    EXPECT_EQ(controlText(requested, ControlCharacters::signs), QStringLiteral("\u238B05P\u21B5\u2193"));
    EXPECT_EQ(controlText(QByteArray("\x00\x7F\xFF~", 4), ControlCharacters::signs),
              QStringLiteral("\u25AF\u25AF<FF>~"));
    EXPECT_EQ(controlText(QByteArray("\x1B\x00\x7F\xFF~", 5), ControlCharacters::numbers),
              QStringLiteral("<1B><00><7F><FF>~"));
    EXPECT_EQ(byteText(requested), QStringLiteral("1B 30 35 50 0D 0A"));
}

TEST(EscLineRowText, KnowsAnAnswerByTheWidthOfItsCommand)
{
    using enum esc::Command;
    EXPECT_EQ(answerIn("\r\n00001235\r\n", position)->value, 0x1235U);
    EXPECT_EQ(answerIn("\r\n", writePreset)->kind, esc::Answer::Kind::accepted);
    EXPECT_EQ(answerIn("03\r\n", position)->kind, esc::Answer::Kind::unknownCommand);
    EXPECT_FALSE(answerIn("\r\n1235\r\n", position));
    EXPECT_FALSE(answerIn("x\r\n00001235\r\n", position));
}

} // namespace
} // namespace codewheel
