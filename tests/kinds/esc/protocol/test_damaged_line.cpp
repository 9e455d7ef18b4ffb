// SPDX-License-Identifier: GPL-3.0-or-later
// 10 000 polls of a position in virtual time over a line that damages one byte in a hundred, both ways. The
// peer here is written from the manual alone.
#include "tests/kinds/esc/protocol/conversation.h"

#include <algorithm>
#include <cctype>
#include <gtest/gtest.h>
#include <iostream>
#include <random>

namespace codewheel::esc {
namespace {

constexpr int polls = 10'000;

class DamagedLine
{
public:
    explicit DamagedLine(bool echoes)
        : m_echoes(echoes)
    {}

    Arrivals answer(Instant end)
    {
        ++requests;
        const QByteArray request = "\x1B"
                                   "05P\r\n";
        Arrivals arrivals;
        if (m_echoes)
            arrivals = arrivals + cut(damaged(request), end - character * request.size());
        const QByteArray heard = damaged(request);
        const Instant start = end + Instant{500 + random(3'000)};
        if (heard == request) {
            const QByteArray right = "\r\n" + position + "\r\n";
            const QByteArray told = damaged(right);
            looksRightAndIsNot += looksRight(told) && told != right ? 1 : 0;
            arrivals = arrivals + cut(told, start);
        } else if (heard.startsWith("\x1B"
                                    "05") &&
                   heard.endsWith("\r\n")) {
            arrivals = arrivals + cut(damaged("03\r\n"), start); // a changed letter
        }
        return arrivals;
    }

    int random(int below) { return static_cast<int>(m_random() % static_cast<unsigned>(below)); }

    QByteArray position = "00000000";
    int requests = 0;
    int looksRightAndIsNot = 0;
    int damagedBytes = 0;

private:
    QByteArray damaged(QByteArray bytes)
    {
        for (char &byte : bytes) {
            if (random(100) != 0)
                continue;
            byte = static_cast<char>(byte ^ (1 + random(255)));
            ++damagedBytes;
        }
        return bytes;
    }

    static bool looksRight(const QByteArray &told)
    {
        const auto isDigit = [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; };
        return told.startsWith("\r\n") && told.endsWith("\r\n") &&
               std::ranges::all_of(told.mid(2, 8), isDigit);
    }

    Arrivals cut(const QByteArray &bytes, Instant start)
    {
        const qsizetype first = random(static_cast<int>(bytes.size()));
        Arrivals arrivals;
        if (first > 0)
            arrivals.push_back(whole(bytes.first(first), start));
        arrivals.push_back(whole(bytes.sliced(first), start + character * first));
        return arrivals;
    }

    std::mt19937 m_random{20'260};
    bool m_echoes;
};

struct Outcome
{
    int right = 0;
    int wrong = 0;
    int errors = 0;
    int none = 0;
    int sent = 0;
    int timeOuts = 0;
};

void countPoll(DamagedLine &line, Outcome &outcome)
{
    line.position = QByteArray::number(line.random(33'554'432), 16).toUpper().rightJustified(8, '0');
    const Conversation poll = converse(positionOf05(), [&](int, Instant end) { return line.answer(end); });
    outcome.sent += poll.result.sent;
    outcome.timeOuts += poll.result.timeOuts;
    if (!poll.result.answer) {
        ++outcome.none;
        EXPECT_EQ(poll.result.timeOuts, 3); // only after all tries have failed
        return;
    }
    const Answer &answer = *poll.result.answer;
    EXPECT_EQ(poll.result.timeOuts, poll.result.sent - 1);
    if (answer.kind != Answer::Kind::value) {
        ++outcome.errors;
        return;
    }
    EXPECT_TRUE(poll.arrived.contains("\r\n" + answer.text + "\r\n"));
    EXPECT_EQ(answer.text.size(), 8);
    EXPECT_EQ(answer.value, answer.text.toUInt(nullptr, 16));
    ++(answer.text == line.position ? outcome.right : outcome.wrong);
}

class EscDamagedLine : public testing::TestWithParam<bool>
{};

TEST_P(EscDamagedLine, NothingMalformedIsTakenAndEveryRetryIsCounted)
{
    DamagedLine line(GetParam());
    Outcome outcome;
    for (int poll = 0; poll < polls; ++poll)
        countPoll(line, outcome);

    EXPECT_EQ(outcome.right + outcome.wrong + outcome.errors + outcome.none, polls);
    EXPECT_EQ(outcome.sent, line.requests);
    EXPECT_EQ(outcome.timeOuts, outcome.sent - polls + outcome.none);
    // A digit changed into another one looks right; nothing else gets through.
    EXPECT_EQ(outcome.wrong, line.looksRightAndIsNot);
    EXPECT_GT(outcome.wrong, 0);
    EXPECT_GT(outcome.right, polls * 9 / 10);
    EXPECT_GT(outcome.sent, polls * 11 / 10);
    std::cout << polls << " polls, " << line.damagedBytes << " bytes damaged, " << outcome.sent - polls
              << " retries, " << outcome.timeOuts << " time-outs, " << outcome.errors << " errors, "
              << outcome.none << " without an answer, " << outcome.wrong << " damaged values look right\n";
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutEcho, EscDamagedLine, testing::Bool());

} // namespace
} // namespace codewheel::esc
