// SPDX-License-Identifier: GPL-3.0-or-later
// Telling answers from noise, byte for byte (manual, "Return values from encoder").
#include "tests/kinds/esc/protocol/conversation.h"

#include <gtest/gtest.h>

namespace codewheel::esc {
namespace {

using Kind = Answer::Kind;
using MaybeAnswer = std::optional<Answer>;

const MaybeAnswer noise = std::nullopt;
const Answer unknown{Kind::unknownCommand, 0, "03"};
const Answer outOfRange{Kind::outOfRange, 0, "05"};

Answer valueOf(std::uint32_t number, const char *digits)
{
    return {Kind::value, number, digits};
}

Answer textOf(const QByteArray &text)
{
    return {Kind::text, 0, text};
}

struct AnswerRow
{
    const char *request;
    QByteArray bytes;
    MaybeAnswer answer;
};

MaybeAnswer answerTo(const AnswerRow &row)
{
    return converse(*parseRequest(row.request), answering(row.bytes)).result.answer;
}

void check(std::span<const AnswerRow> rows)
{
    for (const AnswerRow &row : rows)
        EXPECT_EQ(answerTo(row), row.answer)
            << row.request << " -> " << row.bytes.toPercentEncoding().constData();
}

TEST(EscAnswers, OfTheManual)
{
    check(std::vector<AnswerRow>{
        {"05P", QByteArray::fromHex("0D0A 3030303031323335 0D0A"), valueOf(0x1235, "00001235")},
        {"00O", QByteArray::fromHex("0D0A 37303035 0D0A"), valueOf(0x7005, "7005")},
        {"00A", "\r\n4000\r\n", valueOf(0x4000, "4000")},
        {"00A", "\r\n5000\r\n", valueOf(0x5000, "5000")},
        {"00E", "\r\n0098\r\n", valueOf(0x98, "0098")},
        {"03GP5200", QByteArray::fromHex("0D0A"), accepted},
        {"03GP5200", QByteArray::fromHex("30330D0A"), unknown},
        {"03GP5200", QByteArray::fromHex("30350D0A"), outOfRange},
        {"05P", "03\r\n", unknown},
        {"05P", "05\r\n", outOfRange},
    });
}

TEST(EscAnswers, OfSixteenBitHaveFourDigits)
{
    check(std::vector<AnswerRow>{
        {"05D", "\r\n1FFF\r\n", valueOf(0x1FFF, "1FFF")},
        {"05D", "\r\n1fff\r\n", valueOf(0x1FFF, "1fff")},
        {"05D", "\r\n0003\r\n", valueOf(3, "0003")},
        {"05D", "\r\n0005\r\n", valueOf(5, "0005")},
        {"05D", "03\r\n", unknown},
        {"05D", "05\r\n", outOfRange},
        {"05D", "04\r\n", noise},
        {"05D", "3\r\n", noise},
        {"05D", "003\r\n", noise},
        {"05D", "\r\n03\r\n", noise},
        {"05D", "\r\n05\r\n", noise},
        {"05D", "\r\n\r\n", noise},
        {"05D", "\r\n", noise},
        {"05D", "\r\n100\r\n", noise},
        {"05D", "\r\n02000\r\n", noise},
        {"05D", "\r\n00002000\r\n", noise},
    });
}

TEST(EscAnswers, NeedBothLineEnds)
{
    check(std::vector<AnswerRow>{
        {"05D", "2000\r\n", noise},
        {"05D", "\n2000\r\n", noise},
        {"05D", "\r2000\r\n", noise},
        {"05D", "\n\r2000\r\n", noise},
        {"05D", "\r\n2000", noise},
        {"05D", "\r\n2000\r", noise},
        {"05D", "\r\n2000\n", noise},
        {"05D", "\r\n2000\n\r", noise},
        {"05D", "\r\n2000\r\r\n", noise},
        {"05D", "\r\n\n2000\r\n", noise},
        {"05D", "\x8D\n2000\r\n", noise},
        {"05D", "\r\n2000\x8D\n", noise},
        {"05D", "03\r", noise},
        {"05D", "03\n", noise},
        {"03GP5200", "\r", noise},
        {"03GP5200", "\n", noise},
        {"03GP5200", "\n\r", noise},
    });
}

TEST(EscAnswers, HaveHexadecimalDigitsAndNothingElse)
{
    check(std::vector<AnswerRow>{
        {"05D", "\r\n20O0\r\n", noise},
        {"05D", "\r\nG000\r\n", noise},
        {"05D", "\r\n 200\r\n", noise},
        {"05D", "\r\n200 \r\n", noise},
        {"05D", "\r\n-200\r\n", noise},
        {"05D", "\r\n+200\r\n", noise},
        {"05D", "\r\n0x20\r\n", noise},
        {"05D",
         "\r\n2\xB0"
         "00\r\n",
         noise},
        {"05D",
         QByteArray("\r\n2\0"
                    "00\r\n",
                    8),
         noise},
    });
    // Every byte value in every place of the digits.
    for (int place = 2; place < 6; ++place) {
        for (int byte = 0; byte < 256; ++byte) {
            AnswerRow row{"05D", "\r\n2000\r\n", {}};
            row.bytes[place] = static_cast<char>(byte);
            EXPECT_EQ(answerTo(row).has_value(), byte < 128 && std::isxdigit(byte) != 0) << byte;
        }
    }
}

TEST(EscAnswers, OfTheVersionAreFourToFortyPrintableCharacters)
{
    const QByteArray manual = "5882 HW 2.1 SW 1.04 1998.";
    ASSERT_EQ(manual.size(), 25);
    check(std::vector<AnswerRow>{
        {"05V", "\r\n" + manual + "\r\n", textOf(manual)},
        {"05V", "\r\nV1.0\r\n", textOf("V1.0")},
        {"05V", "\r\n~ ~ \r\n", textOf("~ ~ ")},
        {"05V", "\r\nV10\r\n", noise},
        {"05V", "\r\n" + QByteArray(40, 'x') + "\r\n", textOf(QByteArray(40, 'x'))},
        {"05V", "\r\n" + QByteArray(41, 'x') + "\r\n", noise},
        {"05V", "\r\nV1\t0\r\n", noise},
        {"05V",
         "\r\nV1\x7F"
         "0\r\n",
         noise},
        {"05V",
         "\r\nV1\xE4"
         "0\r\n",
         noise},
        {"05V", "03\r\n", unknown},
        {"05V", "05\r\n", outOfRange},
    });
}

TEST(EscAnswers, OfAWriteHaveNoDigits)
{
    check(std::vector<AnswerRow>{
        {"03GP5200", "\r\n00005200\r\n", noise},
        {"03GP5200", "\r\n0000\r\n", noise},
        {"03GP5200", "\r\n\r\n", noise},
        {"03GP5200", "\r\n03\r\n", noise},
        {"03GP5200", "04\r\n", noise},
        {"02GD1", "\r\n1\r\n", noise},
    });
}

TEST(EscAnswers, WhatIsNoAnswerIsCountedByteByByte)
{
    const Conversation conversation = converse(*parseRequest("05D"), answering("\r\n20O0\r\n"));
    EXPECT_EQ(conversation.result.garbageBytes, 3 * 8);
    EXPECT_EQ(conversation.result.timeOuts, 3);
    EXPECT_EQ(conversation.result.answer, noise);
}

} // namespace
} // namespace codewheel::esc
