// SPDX-License-Identifier: GPL-3.0-or-later
// An answer is never taken for the answer to another request.
#include "tests/kinds/esc/protocol/conversation.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel::esc {
namespace {

using RowKind = EscLineRow::Kind;

const QByteArray oldAnswer = "\r\n00001200\r\n";
const QByteArray newAnswer = "\r\n00001235\r\n";
constexpr Instant readTime = 6 * character;
constexpr Instant quietTwice = 2 * 44 * character;

void expectNew(const Conversation &conversation)
{
    ASSERT_TRUE(conversation.result.answer);
    EXPECT_EQ(conversation.result.answer->text, "00001235");
    EXPECT_EQ(conversation.bytesOf(RowKind::answer), newAnswer);
}

TEST(EscLateAnswers, ComeAfterTheTimeOutAndAreDrained)
{
    const Conversation conversation = converse(positionOf05(), [](int n, Instant end) {
        return n == 0 ? Arrivals{whole(oldAnswer, end + 120 * millisecond)}
                      : Arrivals{whole(newAnswer, end + 2 * millisecond)};
    });
    expectNew(conversation);
    EXPECT_EQ(conversation.bytesOf(RowKind::late), oldAnswer);
    EXPECT_EQ(conversation.result.lateBytes, 12);
    EXPECT_EQ(conversation.result.garbageBytes, 0);
    EXPECT_EQ(conversation.result.timeOuts, 1);
    const Instant lastByte = readTime + 120 * millisecond + 12 * character;
    EXPECT_EQ(conversation.sendings.at(1), lastByte + quietTwice);
}

TEST(EscLateAnswers, OfASlowDeviceMakeTheQuietLonger)
{
    const Timing timing{.retries = 1, .longestAnswer = 90 * millisecond, .adapterDelay = {}};
    const Conversation conversation = converse(positionOf05(), silent(), timing);
    const Instant timeOut = readTime + 100 * millisecond + character;
    EXPECT_EQ(conversation.sendings.at(1), timeOut + 180 * millisecond);
}

// The first answer is so late that it comes with the second sending, whose own answer follows.
TEST(EscLateAnswers, AfterARetryTheNextRequestWaitsUntilTheLineIsQuiet)
{
    const Conversation conversation = converse(positionOf05(), [](int n, Instant end) {
        return n == 0
                   ? Arrivals()
                   : Arrivals{whole(newAnswer, end + millisecond), whole(oldAnswer, end + 20 * millisecond)};
    });
    expectNew(conversation);
    EXPECT_EQ(conversation.bytesOf(RowKind::late), oldAnswer);
    EXPECT_GE(conversation.doneAt, conversation.sendings.at(1) + readTime + 20 * millisecond + quietTwice);
}

TEST(EscLateAnswers, ThatEndBeforeTheDeviceCanHaveAnsweredAreNotTaken)
{
    // They end while the request is being sent, or so soon afterwards that they began before its end.
    for (const Instant before : {-12 * character, -6 * character, -3 * character}) {
        const Conversation conversation = converse(positionOf05(), [&](int, Instant end) {
            const Instant oldEnd = end + before + 12 * character;
            return Arrivals{whole(oldAnswer, end + before)} +
                   byteByByte(newAnswer, std::max(oldEnd, end) + 2 * millisecond);
        });
        expectNew(conversation);
        EXPECT_EQ(conversation.bytesOf(RowKind::late), oldAnswer);
        EXPECT_EQ(conversation.result.sent, 1);
        EXPECT_GE(conversation.doneAt, readTime + quietTwice); // more of it may follow
    }
}

TEST(EscLateAnswers, BeforeTheEchoAreNotTaken)
{
    const Conversation conversation = converse(positionOf05(), [](int, Instant end) {
        return Arrivals{whole(oldAnswer, end - 13 * character), whole(positionOf05().bytes(), end - readTime),
                        whole(newAnswer, end + 2 * millisecond)};
    });
    expectNew(conversation);
    EXPECT_EQ(conversation.bytesOf(RowKind::echo), positionOf05().bytes());
}

// It is held back while something follows, but not for ever.
TEST(EscLateAnswers, ThatComeTooEarlyAndAreFollowedByGarbageWithoutEndAreNotTaken)
{
    const Conversation conversation = converse(positionOf05(), [](int n, Instant end) {
        Arrivals arrivals{whole(oldAnswer, end - 12 * character)};
        for (int i = 0; n == 0 && i < 130; ++i)
            arrivals.push_back(whole("U", end + millisecond * i));
        return arrivals;
    });
    ASSERT_TRUE(conversation.result.answer);
    EXPECT_EQ(conversation.result.timeOuts, 1);
    EXPECT_EQ(conversation.result.sent, 2);
}

// A peer on a pseudo terminal answers at once.
TEST(EscLateAnswers, APeerThatDoesNotKeepTheLinesTimeIsHeardAllTheSame)
{
    const Conversation conversation = converse(positionOf05(), [](int, Instant end) {
        return Arrivals{{end - readTime + Instant{50}, newAnswer}};
    });
    expectNew(conversation);
    EXPECT_EQ(conversation.result.sent, 1);
    EXPECT_EQ(conversation.result.lateBytes, 0);
    EXPECT_EQ(conversation.result.answerTime, Instant{});
    EXPECT_LT(conversation.doneAt, 15 * millisecond);
}

TEST(EscLateAnswers, OfTwoThatContradictEachOtherNeitherIsTaken)
{
    const Conversation contradiction = converse(positionOf05(), [](int n, Instant end) {
        return Arrivals{whole(n == 0 ? oldAnswer + newAnswer : newAnswer, end + 10 * millisecond)};
    });
    expectNew(contradiction);
    EXPECT_EQ(contradiction.result.sent, 2);
    EXPECT_EQ(contradiction.result.garbageBytes, 24);

    const Conversation sameTwice = converse(positionOf05(), answering(newAnswer + newAnswer));
    expectNew(sameTwice);
    EXPECT_EQ(sameTwice.result.sent, 1);
    EXPECT_EQ(sameTwice.bytesOf(RowKind::garbage), newAnswer);

    const Conversation sharedLineEnd = converse(positionOf05(), [](int n, Instant end) {
        return Arrivals{
            whole(n == 0 ? QByteArray("\r\n00001200\r\n00001235\r\n") : newAnswer, end + 10 * millisecond)};
    });
    expectNew(sharedLineEnd);
    EXPECT_EQ(sharedLineEnd.result.sent, 2);
}

TEST(EscLateAnswers, ThatLieThereBeforeTheRequestAreDrained)
{
    const Conversation conversation =
        converse(positionOf05(), answering(newAnswer), {}, {{10 * millisecond, oldAnswer}});
    expectNew(conversation);
    EXPECT_EQ(conversation.bytesOf(RowKind::late), oldAnswer);
    EXPECT_EQ(conversation.sendings.at(0), 10 * millisecond + quietTwice);
    EXPECT_EQ(conversation.rows.front().kind, RowKind::late);
}

TEST(EscLateAnswers, TheFirstHalfMayLieThereAndTheSecondComeLater)
{
    Exchange exchange(positionOf05(), {});
    exchange.received("\r\n0000", Instant{});
    const auto wait = exchange.next(Instant{});
    ASSERT_TRUE(std::holds_alternative<Exchange::Wait>(wait));
    exchange.received("1200\r\n", 20 * millisecond);
    EXPECT_EQ(std::get<Exchange::Wait>(exchange.next(20 * millisecond)).until, 20 * millisecond + quietTwice);
    EXPECT_TRUE(std::holds_alternative<Exchange::Send>(exchange.next(20 * millisecond + quietTwice)));
    EXPECT_EQ(exchange.result().lateBytes, 12);
}

TEST(EscLateAnswers, NothingIsSentIntoALineThatIsNeverQuiet)
{
    Exchange exchange(positionOf05(), {});
    Instant now{};
    int steps = 0;
    for (;; now += 10 * millisecond, ++steps) {
        exchange.received("U", now);
        const auto action = exchange.next(now);
        ASSERT_FALSE(std::holds_alternative<Exchange::Send>(action));
        if (std::holds_alternative<Exchange::Done>(action))
            break;
        ASSERT_LT(steps, 1'000);
    }
    EXPECT_EQ(exchange.result().sent, 0);
    EXPECT_EQ(exchange.result().answer, std::nullopt);
    EXPECT_EQ(exchange.result().lateBytes, steps + 1);
}

TEST(EscLateAnswers, OfAnotherWidthAreNoise)
{
    const Conversation conversation = converse(*parseRequest("05D"), [](int, Instant end) {
        return Arrivals{whole(oldAnswer, end), whole("\r\n2000\r\n", end + 20 * millisecond)};
    });
    ASSERT_TRUE(conversation.result.answer);
    EXPECT_EQ(conversation.result.answer->value, 0x2000U);
    EXPECT_EQ(conversation.result.garbageBytes, 12);
}

TEST(EscLateAnswers, BytesAfterTheEndAreCountedToo)
{
    Exchange exchange(positionOf05(), {});
    EXPECT_TRUE(std::holds_alternative<Exchange::Send>(exchange.next(Instant{})));
    exchange.received(newAnswer, 20 * millisecond);
    EXPECT_TRUE(std::holds_alternative<Exchange::Done>(exchange.next(20 * millisecond)));
    exchange.received("\xFF", 21 * millisecond);
    EXPECT_EQ(exchange.result().lateBytes, 1);
    EXPECT_EQ(exchange.takeRows().back(), (EscLineRow{21 * millisecond, RowKind::late, "\xFF"}));
    EXPECT_TRUE(exchange.takeRows().empty());
}

} // namespace
} // namespace codewheel::esc
