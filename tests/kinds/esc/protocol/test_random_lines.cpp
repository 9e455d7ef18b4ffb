// SPDX-License-Identifier: GPL-3.0-or-later
// What holds whatever arrives, in whatever pieces and at whatever time. converse() itself checks that every
// exchange ends and that no byte is lost.
#include "tests/kinds/esc/protocol/conversation.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace codewheel::esc {
namespace {

class Random
{
public:
    int below(int end) { return static_cast<int>(m_random() % static_cast<unsigned>(end)); }
    bool oneIn(int n) { return below(n) == 0; }
    QByteArray bytes(const QByteArray &alphabet, int most)
    {
        QByteArray bytes;
        for (int n = below(most + 1); n > 0; --n)
            bytes += alphabet[below(static_cast<int>(alphabet.size()))];
        return bytes;
    }
    // In random pieces, one right after the other.
    Arrivals pieces(const QByteArray &bytes, Instant start)
    {
        Arrivals arrivals;
        for (qsizetype at = 0; at < bytes.size();) {
            const qsizetype size = std::min<qsizetype>(1 + below(5), bytes.size() - at);
            arrivals.push_back(whole(bytes.mid(at, size), start + character * at));
            at += size;
        }
        return arrivals;
    }

private:
    std::mt19937 m_random{5'882};
};

Request randomRequest(Random &random)
{
    const auto all = allCommands();
    const CommandShape &shape = all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
    return {EscLineAddress{static_cast<std::uint8_t>(random.below(32))}, shape.command,
            shape.writes ? shape.maximum : 0};
}

QByteArray answerFor(const Request &request, Random &random)
{
    const CommandShape &shape = shapeOf(request.command);
    if (shape.writes)
        return "\r\n";
    if (shape.digits == 0)
        return "\r\n5882 V1.04 1998\r\n";
    QByteArray digits;
    while (digits.size() < shape.digits)
        digits += "0123456789ABCDEF"[random.below(16)];
    return "\r\n" + digits + "\r\n";
}

// Only what was on the line, complete and with both its line ends, is an answer.
void expectWellFormed(const Conversation &conversation, const Request &request)
{
    if (!conversation.result.answer)
        return;
    const CommandShape &shape = shapeOf(request.command);
    const Answer &answer = *conversation.result.answer;
    const bool isValue = answer.kind == Answer::Kind::value || answer.kind == Answer::Kind::text;
    EXPECT_TRUE(!isValue || !shape.writes);
    EXPECT_TRUE(answer.kind != Answer::Kind::accepted || shape.writes);
    EXPECT_TRUE(answer.kind != Answer::Kind::value || answer.text.size() == shape.digits);
    const QByteArray onLine = isValue                                 ? "\r\n" + answer.text + "\r\n"
                              : answer.kind == Answer::Kind::accepted ? QByteArray("\r\n")
                                                                      : answer.text + "\r\n";
    EXPECT_EQ(conversation.bytesOf(EscLineRow::Kind::answer), onLine);
}

// Before each retry, and before the end of an exchange with one, the line was silent for long enough.
void expectQuiet(const Conversation &conversation, const Arrivals &arrivals, const Timing &timing)
{
    const Instant quiet = 2 * 44 * timing.character;
    std::vector<Instant> starts(conversation.sendings.begin() + 1, conversation.sendings.end());
    if (conversation.result.timeOuts > 0)
        starts.push_back(conversation.doneAt);
    for (const Instant start : starts)
        for (const Arrival &arrival : arrivals)
            EXPECT_FALSE(arrival.at > start - quiet && arrival.at < start) << start.count();
}

TEST(EscRandomLines, NothingButAWellFormedAnswerIsTaken)
{
    Random random;
    for (int round = 0; round < 20'000; ++round) {
        const Request request = randomRequest(random);
        Arrivals all;
        const auto peer = [&](int, Instant end) {
            const QByteArray junk = "\r\n\r\n035\x1B\xFFGP0";
            QByteArray bytes = random.bytes(junk, 12);
            if (random.oneIn(2))
                bytes += request.bytes() + random.bytes(junk, 3);
            if (random.oneIn(2))
                bytes += answerFor(request, random) + random.bytes(junk, 6);
            const Instant start = end - character * request.bytes().size();
            Arrivals arrivals = random.pieces(bytes, start + Instant{random.below(160'000)});
            all = all + arrivals;
            return arrivals;
        };
        const Conversation conversation = converse(request, peer);
        expectWellFormed(conversation, request);
        expectQuiet(conversation, all, {});
        EXPECT_LE(conversation.result.sent, shapeOf(request.command).writes ? 1 : 3);
        if (HasFailure())
            FAIL() << round << ": " << request.text().constData() << " -> "
                   << conversation.arrived.toPercentEncoding().constData();
    }
}

TEST(EscRandomLines, AnAnswerIsFoundAmongEchoAndGarbage)
{
    Random random;
    for (int round = 0; round < 5'000; ++round) {
        const Request request = randomRequest(random);
        const QByteArray answer = answerFor(request, random);
        const bool writes = shapeOf(request.command).writes;
        // Garbage before a write's answer makes it doubtful, unless the echo shows that it came first.
        const bool echoes = random.oneIn(2);
        const QByteArray junk = "03FG\n\xFF\x80";
        const QByteArray garbage = !writes || echoes ? random.bytes(junk, 8) : QByteArray();
        const QByteArray bytes = garbage + (echoes ? request.bytes() : QByteArray()) + answer;
        const Conversation conversation = converse(request, [&](int, Instant end) {
            const Instant answered = end + millisecond;
            return random.pieces(bytes, answered - character * (bytes.size() - answer.size()));
        });
        EXPECT_TRUE(conversation.result.answer);
        EXPECT_EQ(conversation.result.sent, 1);
        EXPECT_EQ(conversation.bytesOf(EscLineRow::Kind::garbage), garbage);
        EXPECT_EQ(conversation.bytesOf(EscLineRow::Kind::echo), echoes ? request.bytes() : QByteArray());
        EXPECT_EQ(conversation.bytesOf(EscLineRow::Kind::answer), answer);
        if (HasFailure())
            FAIL() << round << ": " << request.text().constData() << " -> "
                   << conversation.arrived.toPercentEncoding().constData();
    }
}

} // namespace
} // namespace codewheel::esc
