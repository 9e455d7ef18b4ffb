// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/esc/protocol/conversation.h"

#include <gtest/gtest.h>

namespace codewheel::esc {
namespace {

constexpr Instant writeTime = 15 * character; // ESC 03GP00005200 CR LF
const Timing noDelay{.adapterDelay = {}};

TEST(EscWrites, AreAcceptedByALineEnd)
{
    const Conversation conversation = converse(presetOf03(), answering("\r\n"), noDelay);
    EXPECT_EQ(conversation.result.answer, accepted);
    EXPECT_EQ(conversation.result.sent, 1);
    EXPECT_EQ(conversation.result.garbageBytes, 0);
    EXPECT_EQ(conversation.result.answerTime, 2 * millisecond + 2 * character);
    EXPECT_EQ(conversation.bytesOf(EscLineRow::Kind::answer), "\r\n");
}

TEST(EscWrites, AreFollowedByQuiet)
{
    const Conversation conversation = converse(presetOf03(), answering("\r\n"), noDelay);
    EXPECT_EQ(conversation.doneAt, writeTime + 2 * millisecond + 2 * character + 100 * millisecond);
    const Timing settable{.quietAfterWrite = 7 * millisecond, .adapterDelay = {}};
    EXPECT_EQ(converse(presetOf03(), answering("\r\n"), settable).doneAt,
              writeTime + 2 * millisecond + 2 * character + 7 * millisecond);
}

TEST(EscWrites, AreSentOnce)
{
    const Conversation conversation = converse(presetOf03(), silent(), noDelay);
    EXPECT_EQ(conversation.result.answer, std::nullopt);
    EXPECT_EQ(conversation.result.sent, 1);
    EXPECT_EQ(conversation.result.timeOuts, 1);
    EXPECT_EQ(conversation.doneAt, writeTime + 100 * millisecond + character + 100 * millisecond);
}

TEST(EscWrites, ALateReadAnswerBeginsWithALineEndToo)
{
    for (const QByteArray late : {"\r\n00001235\r\n", "\r\n1235\r\n", "\r\n0"}) {
        const Conversation inOnePiece = converse(presetOf03(), answering(late), noDelay);
        EXPECT_EQ(inOnePiece.result.answer, std::nullopt);
        const Conversation inPieces = converse(
            presetOf03(), [&](int, Instant end) { return byteByByte(late, end + 2 * millisecond); }, noDelay);
        EXPECT_EQ(inPieces.result.answer, std::nullopt);
        EXPECT_EQ(inPieces.result.garbageBytes, late.size());
    }
}

// An adapter delivers its input in packets: the line end in one, the digits later in the next.
TEST(EscWrites, ALateReadAnswerInTwoPacketsIsNoAcceptance)
{
    const Timing slow{.adapterDelay = 16 * millisecond};
    const Conversation conversation = converse(
        presetOf03(),
        [](int, Instant end) {
            return Arrivals{{end + 2 * millisecond, "\r\n"}, {end + 18 * millisecond, "00001235\r\n"}};
        },
        slow);
    EXPECT_EQ(conversation.result.answer, std::nullopt);
}

// When its last byte arrived, the silence had been long enough; when its first one did, it had not.
TEST(EscWrites, APacketIsAsOldAsItsFirstByte)
{
    Exchange exchange(presetOf03(), noDelay);
    EXPECT_TRUE(std::holds_alternative<Exchange::Send>(exchange.next(Instant{})));
    const Instant accepting = writeTime + 2 * millisecond;
    exchange.received("\r\n", accepting);
    exchange.received("00001235\r\n", accepting + 10 * character);
    EXPECT_TRUE(std::holds_alternative<Exchange::Wait>(exchange.next(accepting + 20 * character)));
    EXPECT_EQ(exchange.result().answer, std::nullopt);
}

TEST(EscWrites, TheLineEndCountsWhenNothingFollowsForTwoCharacters)
{
    const auto followedAfter = [](Instant gap) {
        return converse(
            presetOf03(),
            [=](int, Instant end) {
                const Instant start = end + 2 * millisecond;
                return Arrivals{whole("\r\n", start), {start + 2 * character + gap, "U"}};
            },
            noDelay);
    };
    EXPECT_EQ(followedAfter(2 * character - Instant{1}).result.answer, std::nullopt);
    EXPECT_EQ(followedAfter(2 * character + Instant{1}).result.answer, accepted);
    EXPECT_EQ(followedAfter(2 * character + Instant{1}).result.lateBytes, 1);
}

TEST(EscWrites, WhatElseCameMakesTheAcceptanceUnsure)
{
    for (const char *bytes : {"\xFF\r\n", "\r\n\r\n", "\n\r\n", "\r\n\n", "0\r\n", "\r\r\n", "\r\n03\r\n"})
        EXPECT_EQ(converse(presetOf03(), answering(bytes)).result.answer, std::nullopt)
            << QByteArray(bytes).toPercentEncoding().constData();
}

TEST(EscWrites, AreRefused)
{
    const auto refused = converse(presetOf03(), answering("05\r\n"), noDelay);
    ASSERT_TRUE(refused.result.answer);
    EXPECT_EQ(refused.result.answer->kind, Answer::Kind::outOfRange);
    EXPECT_EQ(refused.result.answer->text, "05");
    const auto unknown = converse(presetOf03(), answering("03\r\n"), noDelay);
    ASSERT_TRUE(unknown.result.answer);
    EXPECT_EQ(unknown.result.answer->kind, Answer::Kind::unknownCommand);
    EXPECT_EQ(unknown.doneAt, writeTime + 2 * millisecond + 4 * character + 100 * millisecond);
}

TEST(EscWrites, AnAcceptanceAfterTheTimeOutIsLate)
{
    const Conversation conversation = converse(
        presetOf03(), [](int, Instant end) { return Arrivals{whole("\r\n", end + 150 * millisecond)}; });
    EXPECT_EQ(conversation.result.answer, std::nullopt);
    EXPECT_EQ(conversation.result.lateBytes, 2);
    EXPECT_EQ(conversation.result.sent, 1);
}

} // namespace
} // namespace codewheel::esc
