// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_figures.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

esc::ExchangeResult answeredAfter(int microseconds)
{
    esc::ExchangeResult result;
    result.answer = esc::Answer{};
    result.sent = 1;
    result.answerTime = Instant{microseconds};
    return result;
}

TEST(LineCounter, KnowsNoAnswerTimeBeforeTheFirstAnswer)
{
    LineCounter counter;
    counter.note({.answer = {}, .sent = 3, .timeOuts = 3, .garbageBytes = 2, .lateBytes = 5});
    const EscLineFigures figures = counter.figures();
    EXPECT_EQ(figures.requests, 3U);
    EXPECT_EQ(figures.retries, 2U);
    EXPECT_EQ(figures.timeOuts, 3U);
    EXPECT_EQ(figures.unanswered, 1U);
    EXPECT_EQ(figures.answers, 0U);
    EXPECT_EQ(figures.garbageBytes, 2U);
    EXPECT_EQ(figures.lateBytes, 5U);
    EXPECT_EQ(figures.answerTime, std::nullopt);
    EXPECT_EQ(counter.longestAnswer(), Instant{});
}

TEST(LineCounter, TellsShortestMedianAndLongestAnswerTime)
{
    LineCounter counter;
    for (const int time : {9'000, 4'000, 7'000})
        counter.note(answeredAfter(time));
    EXPECT_EQ(counter.figures().answerTime, (AnswerTime{Instant{4'000}, Instant{7'000}, Instant{9'000}}));
    EXPECT_EQ(counter.longestAnswer(), Instant{9'000});
}

TEST(LineCounter, MedianIsOfTheNewestAnswers)
{
    LineCounter counter;
    for (std::size_t i = 0; i < AnswerTimes::samples; ++i)
        counter.note(answeredAfter(1'000));
    for (std::size_t i = 0; i < AnswerTimes::samples; ++i)
        counter.note(answeredAfter(2'000));
    EXPECT_EQ(counter.figures().answerTime, (AnswerTime{Instant{1'000}, Instant{2'000}, Instant{2'000}}));
    EXPECT_EQ(counter.figures().answers, 2 * AnswerTimes::samples);
}

TEST(LineCounter, CountsWhatNobodyAskedForAsGarbage)
{
    LineCounter counter;
    counter.noteGarbage(4);
    EXPECT_EQ(counter.figures().garbageBytes, 4U);
    EXPECT_EQ(counter.figures().requests, 0U);
}

} // namespace
} // namespace codewheel
