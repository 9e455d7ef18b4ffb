// SPDX-License-Identifier: GPL-3.0-or-later
// Adapters for RS-485 that receive what they send (half duplex).
#include "tests/kinds/esc/protocol/conversation.h"

#include <gtest/gtest.h>

namespace codewheel::esc {
namespace {

using RowKind = EscLineRow::Kind;

// `echo` while the request is being sent, then `answer`.
Peer echoing(const QByteArray &echo, const QByteArray &answer)
{
    return [=](int, Instant end) {
        return byteByByte(echo, end - character * echo.size()) +
               Arrivals{whole(answer, end + 2 * millisecond)};
    };
}

Peer echoingAlone(const QByteArray &echo)
{
    return [=](int, Instant end) { return byteByByte(echo, end - character * echo.size()); };
}

TEST(EscEcho, IsDroppedBeforeTheAnswerOfEachCommand)
{
    for (const CommandShape &shape : allCommands()) {
        const Request request{EscLineAddress{0x12}, shape.command, shape.minimum};
        const QByteArray answer = shape.writes       ? QByteArray("\r\n")
                                  : shape.digits > 0 ? "\r\n" + QByteArray(shape.digits, '1') + "\r\n"
                                                     : QByteArray("\r\nV1.00\r\n");
        const Conversation conversation = converse(request, echoing(request.bytes(), answer));
        EXPECT_TRUE(conversation.result.answer) << request.text().constData();
        EXPECT_EQ(conversation.result.sent, 1);
        EXPECT_EQ(conversation.result.garbageBytes, 0);
        EXPECT_EQ(conversation.bytesOf(RowKind::echo), request.bytes());
        EXPECT_EQ(conversation.bytesOf(RowKind::answer), answer);
    }
}

TEST(EscEcho, MayBeCutAnywhereAndMergedWithTheAnswer)
{
    for (const Request &request : {positionOf05(), presetOf03()}) {
        const bool writes = shapeOf(request.command).writes;
        const QByteArray both = request.bytes() + (writes ? "\r\n" : "\r\n00001235\r\n");
        for (qsizetype cut = 0; cut < both.size(); ++cut) {
            const Conversation conversation = converse(request, [&](int, Instant end) {
                return Arrivals{{end, both.first(cut)}, {end + 10 * millisecond, both.sliced(cut)}};
            });
            EXPECT_TRUE(conversation.result.answer) << cut;
            EXPECT_EQ(conversation.bytesOf(RowKind::echo), request.bytes()) << cut;
            EXPECT_EQ(conversation.result.garbageBytes, 0);
        }
    }
}

TEST(EscEcho, AloneIsNoAcceptance)
{
    const Conversation conversation = converse(presetOf03(), echoingAlone(presetOf03().bytes()));
    EXPECT_EQ(conversation.result.answer, std::nullopt);
    EXPECT_EQ(conversation.bytesOf(RowKind::echo), presetOf03().bytes());
    EXPECT_EQ(conversation.result.garbageBytes, 0);
}

TEST(EscEcho, WithTheAcceptanceIsOne)
{
    EXPECT_EQ(converse(presetOf03(), echoing(presetOf03().bytes(), "\r\n")).result.answer, accepted);
    const auto refused = converse(presetOf03(), echoing(presetOf03().bytes(), "05\r\n")).result.answer;
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->kind, Answer::Kind::outOfRange);
}

TEST(EscEcho, AfterGarbageIsStillOne)
{
    EXPECT_EQ(converse(presetOf03(), echoing("\xFF\r\n" + presetOf03().bytes(), "\r\n")).result.answer,
              accepted);
}

// Every bit of every byte flipped, every byte lost, every byte doubled.
std::vector<QByteArray> damagedOnce(const QByteArray &bytes)
{
    std::vector<QByteArray> all;
    for (qsizetype place = 0; place < bytes.size(); ++place) {
        for (int bit = 0; bit < 8; ++bit) {
            all.push_back(bytes);
            all.back()[place] = static_cast<char>(bytes[place] ^ 1 << bit);
        }
        all.push_back(bytes);
        all.back().remove(place, 1);
        all.push_back(bytes);
        all.back().insert(place, bytes[place]);
    }
    return all;
}

TEST(EscEcho, DamagedIsNoAcceptance)
{
    for (const CommandShape &shape : allCommands()) {
        if (!shape.writes)
            continue;
        const Request request{EscLineAddress{3}, shape.command, shape.maximum};
        for (const QByteArray &echo : damagedOnce(request.bytes())) {
            const Conversation conversation = converse(request, echoingAlone(echo));
            EXPECT_EQ(conversation.result.answer, std::nullopt) << echo.toPercentEncoding().constData();
            EXPECT_EQ(conversation.result.sent, 1);
        }
    }
}

TEST(EscEcho, DamagedBeforeAReadIsGarbage)
{
    for (const QByteArray &echo : damagedOnce(positionOf05().bytes())) {
        const Conversation alone = converse(positionOf05(), echoingAlone(echo));
        EXPECT_EQ(alone.result.answer, std::nullopt) << echo.toPercentEncoding().constData();
        const Conversation answered = converse(positionOf05(), echoing(echo, "\r\n00001235\r\n"));
        ASSERT_TRUE(answered.result.answer) << echo.toPercentEncoding().constData();
        EXPECT_EQ(answered.result.answer->value, 0x1235U);
        EXPECT_EQ(answered.result.sent, 1);
    }
}

// Its line end does not belong to the answer.
TEST(EscEcho, DoesNotStandInForTheFirstLineEnd)
{
    const Conversation conversation =
        converse(positionOf05(), echoing(positionOf05().bytes(), "00001235\r\n"));
    EXPECT_EQ(conversation.result.answer, std::nullopt);
    EXPECT_EQ(conversation.result.sent, 3);
}

} // namespace
} // namespace codewheel::esc
