// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/esc/protocol/conversation.h"

#include <gtest/gtest.h>

namespace codewheel::esc {
namespace {

using RowKind = EscLineRow::Kind;

const QByteArray question = "\x1B"
                            "05P\r\n";
const QByteArray answer = "\r\n00001235\r\n";
constexpr std::uint32_t position = 0x1235;
constexpr Instant requestTime = 6 * character;
constexpr Instant answerTime = 12 * character;
// Twice the longest answer: 40 characters of text between two line ends.
constexpr Instant quiet = 2 * 44 * character;

// Answers only the n-th sending.
Peer answeringOnly(int which, const QByteArray &bytes)
{
    return [=](int n, Instant end) {
        return n == which ? Arrivals{whole(bytes, end + 2 * millisecond)} : Arrivals();
    };
}

void expectPosition(const Conversation &conversation)
{
    ASSERT_TRUE(conversation.result.answer);
    EXPECT_EQ(conversation.result.answer->kind, Answer::Kind::value);
    EXPECT_EQ(conversation.result.answer->value, position);
    EXPECT_EQ(conversation.result.answer->text, "00001235");
}

TEST(EscReads, PositionOf05AsInTheManual)
{
    const Conversation conversation = converse(positionOf05(), answering(answer));
    expectPosition(conversation);
    EXPECT_EQ(conversation.sent, std::vector{question});
    EXPECT_EQ(conversation.result.sent, 1);
    EXPECT_EQ(conversation.result.timeOuts, 0);
    EXPECT_EQ(conversation.result.garbageBytes, 0);
    EXPECT_EQ(conversation.result.lateBytes, 0);
    EXPECT_EQ(conversation.result.answerTime, 2 * millisecond + answerTime);
    EXPECT_EQ(conversation.rows, (std::vector<EscLineRow>{{Instant{}, RowKind::sent, question},
                                                          {conversation.doneAt, RowKind::answer, answer}}));
}

TEST(EscReads, AreDoneWithTheLastByteOfTheAnswer)
{
    const Conversation conversation =
        converse(positionOf05(), [](int, Instant end) { return byteByByte(answer, end + 2 * millisecond); });
    expectPosition(conversation);
    EXPECT_EQ(conversation.doneAt, requestTime + 2 * millisecond + answerTime);
}

TEST(EscReads, TheAnswerMayComeInAnyTwoPieces)
{
    for (qsizetype cut = 1; cut < answer.size(); ++cut) {
        const Conversation conversation = converse(positionOf05(), [&](int, Instant end) {
            const Instant start = end + 2 * millisecond;
            return Arrivals{whole(answer.first(cut), start),
                            whole(answer.sliced(cut), start + character * cut + 10 * millisecond)};
        });
        expectPosition(conversation);
        EXPECT_EQ(conversation.result.sent, 1) << cut;
    }
}

TEST(EscReads, GarbageBeforeAndAfterTheAnswerIsCountedAndDropped)
{
    for (const char *garbage : {"\xFF", "U", "\r\n", "\n", "\r", "12\r\n", "\xF0\x0F\r\n\r\n", "00001235",
                                "00001235\r\n", "\r\n1234", "\r\n0000123\r\n", "\r\n000012355"}) {
        SCOPED_TRACE(QByteArray(garbage).toPercentEncoding().constData());
        const Conversation before = converse(positionOf05(), answering(garbage + answer));
        expectPosition(before);
        EXPECT_EQ(before.bytesOf(RowKind::garbage), garbage);
        EXPECT_EQ(before.result.sent, 1);
        const Conversation after = converse(positionOf05(), answering(answer + garbage));
        expectPosition(after);
        EXPECT_EQ(after.bytesOf(RowKind::garbage), garbage);
        // More of it may follow.
        EXPECT_GE(after.doneAt, requestTime + 2 * millisecond + answerTime + quiet);
    }
}

TEST(EscReads, GarbageWithinTheAnswerSpoilsIt)
{
    for (qsizetype place = 1; place < answer.size(); ++place) {
        for (const char *garbage : {"\xFF", "0", "\r\n", "\x1B"}) {
            if (place == 2 && garbage == QByteArrayView("\r\n")) // in effect before the answer
                continue;
            if (place == answer.size() - 2 && garbage == QByteArrayView("\r\n")) // in effect after the answer
                continue;
            QByteArray spoiled = answer;
            spoiled.insert(place, garbage);
            const Conversation conversation = converse(positionOf05(), answeringOnly(0, spoiled));
            EXPECT_EQ(conversation.result.answer, std::nullopt) << spoiled.toPercentEncoding().constData();
            EXPECT_EQ(conversation.result.garbageBytes, spoiled.size());
        }
    }
}

TEST(EscReads, AMissingByteMakesItAskAgain)
{
    for (qsizetype place = 0; place < answer.size(); ++place) {
        const Conversation conversation = converse(positionOf05(), [&](int n, Instant end) {
            QByteArray bytes = answer;
            if (n == 0)
                bytes.remove(place, 1);
            return Arrivals{whole(bytes, end + 2 * millisecond)};
        });
        expectPosition(conversation);
        EXPECT_EQ(conversation.result.sent, 2) << place;
        EXPECT_EQ(conversation.result.timeOuts, 1) << place;
        EXPECT_EQ(conversation.result.garbageBytes, answer.size() - 1);
    }
}

TEST(EscReads, ASilentEncoderIsAskedThreeTimes)
{
    const Conversation conversation = converse(positionOf05(), silent());
    EXPECT_EQ(conversation.result.answer, std::nullopt);
    EXPECT_EQ(conversation.result.sent, 3);
    EXPECT_EQ(conversation.result.timeOuts, 3);
    EXPECT_EQ(conversation.sent, (std::vector{question, question, question}));
    // Time-out, the adapter's delay, and the silence.
    const Instant timeOut = requestTime + 102 * millisecond + character;
    EXPECT_EQ(conversation.sendings, (std::vector{Instant{}, timeOut + quiet, 2 * (timeOut + quiet)}));
    EXPECT_EQ(conversation.doneAt, 3 * (timeOut + quiet));
}

TEST(EscReads, RetriesAndTimeOutAreSettable)
{
    const Timing timing{.answerTimeOut = 20 * millisecond, .retries = 0, .adapterDelay = {}};
    const Conversation conversation = converse(positionOf05(), silent(), timing);
    EXPECT_EQ(conversation.result.sent, 1);
    EXPECT_EQ(conversation.doneAt, requestTime + 20 * millisecond + character + quiet);
}

TEST(EscReads, TheLastRetryIsAsGoodAsTheFirst)
{
    const Conversation conversation = converse(positionOf05(), answeringOnly(2, answer));
    expectPosition(conversation);
    EXPECT_EQ(conversation.result.sent, 3);
    EXPECT_EQ(conversation.result.timeOuts, 2);
    EXPECT_EQ(conversation.result.answerTime, 2 * millisecond + answerTime);
}

TEST(EscReads, AnAnswerThatBeginsInTimeMayEndAfterIt)
{
    const Conversation conversation = converse(
        positionOf05(), [](int, Instant end) { return byteByByte(answer, end + 100 * millisecond); });
    expectPosition(conversation);
    EXPECT_EQ(conversation.result.sent, 1);
}

TEST(EscReads, AnErrorCountsWhenNothingFollowsForTwoCharacters)
{
    const Timing timing{.adapterDelay = {}};
    const Conversation alone = converse(positionOf05(), answering("05\r\n"), timing);
    ASSERT_TRUE(alone.result.answer);
    EXPECT_EQ(alone.result.answer->kind, Answer::Kind::outOfRange);
    EXPECT_EQ(alone.doneAt, requestTime + 2 * millisecond + (4 + 2) * character);

    const Conversation followed = converse(positionOf05(), [](int, Instant end) {
        return byteByByte("05\r\n" + answer, end + 2 * millisecond);
    });
    expectPosition(followed);
    EXPECT_EQ(followed.result.garbageBytes, 4);
}

TEST(EscReads, TheEndOfADamagedValueIsNoError)
{
    for (const char *bytes : {"\r\n0000\x92"
                              "203\r\n",
                              "\r\n0\xFF"
                              "03\r\n",
                              "\xFF"
                              "03\r\n",
                              "2\r\n05\r\n"}) {
        const Conversation conversation = converse(positionOf05(), answering(bytes));
        EXPECT_EQ(conversation.result.answer, std::nullopt);
    }
}

TEST(EscReads, GarbageWithoutEndIsGivenUp)
{
    const Conversation conversation = converse(positionOf05(), [](int n, Instant end) {
        Arrivals arrivals;
        for (int i = 0; n == 0 && i < 2'000; ++i)
            arrivals.push_back(whole("\x55\xAA", end + 2 * character * i));
        return arrivals;
    });
    EXPECT_EQ(conversation.result.answer, std::nullopt);
    EXPECT_EQ(conversation.result.sent, 1); // nothing is sent until the line is silent
    EXPECT_EQ(conversation.result.timeOuts, 1);
}

TEST(EscReads, AFloodIsGivenUpBeforeTheTimeOut)
{
    const Conversation conversation = converse(positionOf05(), [](int n, Instant end) {
        return n == 0 ? Arrivals{{end + millisecond, QByteArray(100'000, 'U')}} : Arrivals();
    });
    EXPECT_EQ(conversation.result.answer, std::nullopt);
    EXPECT_EQ(conversation.result.garbageBytes, 100'000);
    EXPECT_LT(conversation.sendings.at(1), 60 * millisecond);
}

} // namespace
} // namespace codewheel::esc
