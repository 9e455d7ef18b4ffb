// SPDX-License-Identifier: GPL-3.0-or-later
// What the times of a log are, which its lines do not say.
#include "tests/can/read_log.h"

#include <QScopeGuard>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

std::string candumpAt(const std::string &seconds)
{
    return '(' + seconds + ") can0 185#00\n";
}

std::string ascAt(const std::string &seconds)
{
    return seconds + " 1 185 Rx d 1 00\n";
}

const QDate sixthOfDecember(2018, 12, 6);

TEST(CanLogTimes, SecondsOfCandumpFromTenToTheEightOnAreSince1970)
{
    const ReadLog log = readLog(candumpAt("1544106679.432583") + candumpAt("100000000.000001"));
    EXPECT_EQ(log.times, CanLogTimes::absolute);
    EXPECT_TRUE(log.isSince1970);
    EXPECT_THAT(log.microseconds(), ElementsAre(1'544'106'679'432'583, 100'000'000'000'001));
    EXPECT_TRUE(readLog(candumpAt("100000000.000000")).isSince1970);
}

TEST(CanLogTimes, BelowTheyCountFromTheBeginning)
{
    const ReadLog log = readLog(candumpAt("99999999.000000") + candumpAt("99999999.000010"));
    EXPECT_EQ(log.times, CanLogTimes::relative);
    EXPECT_FALSE(log.isSince1970);
    EXPECT_THAT(log.microseconds(), ElementsAre(0, 10));
}

TEST(CanLogTimes, TheFirstFrameIsTheBeginning)
{
    EXPECT_THAT(readLog(candumpAt("000.010000") + candumpAt("000.030000")).microseconds(),
                ElementsAre(0, 20'000));
}

// `smaller` of `lines` are smaller than the one before.
std::string withSmaller(int lines, int smaller)
{
    std::string text;
    for (int i = 0; i < lines; ++i)
        text += candumpAt(i % 2 == 1 && i / 2 < smaller ? "0.001" : std::to_string(i + 1) + ".0");
    return text;
}

TEST(CanLogTimes, SingleLinesAreOnlyOutOfOrder)
{
    EXPECT_EQ(readLog(withSmaller(40, 4)).times, CanLogTimes::relative);
}

TEST(CanLogTimes, WhereMoreThanOneLineInTenIsSmallerThanTheOneBeforeAllAreDifferences)
{
    EXPECT_EQ(readLog(withSmaller(40, 5)).times, CanLogTimes::differences);
    const ReadLog log = readLog(candumpAt("000.000000") + candumpAt("000.010000") + candumpAt("000.000500") +
                                candumpAt("000.009000"));
    EXPECT_EQ(log.times, CanLogTimes::differences);
    EXPECT_THAT(log.microseconds(), ElementsAre(0, 10'000, 10'500, 19'500));
}

TEST(CanLogTimes, DifferencesCountOverLinesThatAreNotRead)
{
    const ReadLog log = readLog("(0.0) can0 185#00\n(0.5) can0 185##0\n(0.25) can0 185#0\n(0.1) can0 080#\n");
    EXPECT_EQ(log.times, CanLogTimes::differences);
    EXPECT_THAT(log.microseconds(), ElementsAre(0, 850'000));
}

TEST(CanLogTimes, ItIsDecidedWithoutReadingAllOfALongLog)
{
    std::size_t read = 0;
    CanLogReader reader([&](const CanFrame &) { ++read; }, [](std::int64_t, CanLogFault) {});
    for (int i = 0; i < 9'999; ++i)
        reader.read(candumpAt(std::to_string(i) + ".0"));
    EXPECT_EQ(read, 0);
    reader.read(candumpAt("9999.0"));
    EXPECT_EQ(read, 10'000);
    reader.read(candumpAt("10000.0"));
    EXPECT_EQ(read, 10'001);
}

TEST(CanLogTimes, AnAbsoluteLogWaitsForNothing)
{
    std::size_t read = 0;
    CanLogReader reader([&](const CanFrame &) { ++read; }, [](std::int64_t, CanLogFault) {});
    reader.read(candumpAt("1544106679.4"));
    EXPECT_EQ(read, 1);
}

TEST(CanLogTimes, DatesAreInLocalTime)
{
    const ReadLog log = readLog(" (2018-12-06 14:31:19.432583)  can0  057   [0]\n"
                                " (2018-12-06 14:32:00.000001)  can0  057   [0]\n");
    EXPECT_EQ(log.times, CanLogTimes::absolute);
    EXPECT_TRUE(log.isSince1970);
    const std::int64_t minute = localMicroseconds(sixthOfDecember, QTime(14, 31));
    EXPECT_THAT(log.microseconds(), ElementsAre(minute + 19'432'583, minute + 60'000'001));
}

TEST(CanLogTimes, AScreenWithoutThemHasNone)
{
    const ReadLog log = readLog("  can0  057   [0]\n");
    EXPECT_FALSE(log.times);
    EXPECT_FALSE(log.frames.front().time);
}

TEST(CanLogTimes, WhatIsMeantGoesBeforeWhatItIsTakenFor)
{
    const std::string text = candumpAt("1.0") + candumpAt("2.0") + candumpAt("4.0");
    const ReadLog differences = readLog(text, CanLogTimes::differences);
    EXPECT_EQ(differences.times, CanLogTimes::differences);
    EXPECT_THAT(differences.microseconds(), ElementsAre(0, 2'000'000, 6'000'000));
    const ReadLog absolute = readLog(text, CanLogTimes::absolute);
    EXPECT_TRUE(absolute.isSince1970);
    EXPECT_THAT(absolute.microseconds(), ElementsAre(1'000'000, 2'000'000, 4'000'000));
    const ReadLog relative =
        readLog(candumpAt("1544106679.5") + candumpAt("1544106680.0"), CanLogTimes::relative);
    EXPECT_FALSE(relative.isSince1970);
    EXPECT_THAT(relative.microseconds(), ElementsAre(0, 500'000));
}

struct AscDate
{
    const char *text;
    QTime time;
};

const AscDate ascDates[] = {
    {"Thu Dec 06 02:31:19.123 pm 2018", {14, 31, 19, 123}},
    {"Thu Dec 6 14:31:19 2018", {14, 31, 19}},
    {"Thu Dec  6 02:31:19 PM 2018", {14, 31, 19}},
    {"Don Dez 6 14:31:19 2018", {14, 31, 19}},
    {"Do. Dez. 6 02:31:19 nachm. 2018", {14, 31, 19}},
    {"Do. Dez. 6 12:00:01 vorm. 2018", {0, 0, 1}},
    {"Thu Dec 6 12:00:01 am 2018", {0, 0, 1}},
    {"Thu Dec 6 12:00:01 pm 2018", {12, 0, 1}},
    {"Thu Dec 6 14:31:19.456 2018", {14, 31, 19, 456}},
};

TEST(CanLogTimes, AbsoluteOnesOfAscCountFromItsDate)
{
    for (const AscDate &date : ascDates) {
        const ReadLog log = readLog("date " + std::string(date.text) + "\nbase hex  timestamps absolute\n" +
                                    ascAt("0.5") + ascAt("1.5"));
        EXPECT_EQ(log.times, CanLogTimes::absolute) << date.text;
        EXPECT_TRUE(log.isSince1970) << date.text;
        const std::int64_t begin = localMicroseconds(sixthOfDecember, date.time);
        EXPECT_THAT(log.microseconds(), ElementsAre(begin + 500'000, begin + 1'500'000)) << date.text;
    }
}

TEST(CanLogTimes, MonthsAreEnglishOrGerman)
{
    for (const char *march : {"Mar", "M\xC3\xA4r", "M\xE4r", "mar"}) {
        const ReadLog log = readLog("date Sat " + std::string(march) +
                                    " 3 14:31:19 2018\nbase hex  timestamps absolute\n" + ascAt("0.0"));
        EXPECT_THAT(log.microseconds(), ElementsAre(localMicroseconds({2018, 3, 3}, {14, 31, 19}))) << march;
    }
}

TEST(CanLogTimes, WithoutADateThatOfTheTriggerBlockCounts)
{
    const ReadLog log = readLog("base hex  timestamps absolute\n"
                                "Begin Triggerblock Thu Dec 06 02:31:19.123 pm 2018\n" +
                                ascAt("0.5"));
    EXPECT_THAT(log.microseconds(),
                ElementsAre(localMicroseconds(sixthOfDecember, {14, 31, 19, 123}) + 500'000));
}

TEST(CanLogTimes, ADateThatCannotBeReadIsNoneAndTheLogStaysRelative)
{
    for (const char *date :
         {"today", "Thu Foo 6 14:31:19 2018", "Thu Dec 32 14:31:19 2018", "Thu Dec 6 25:31:19 2018",
          "Thu Dec 6 13:31:19 pm 2018", "Thu Dec 6 14:31:19 CET 2018", "Thu Dec 6 14:31:19 18",
          "Thu Dec 6 14:31:19 1969", "Thu Dec 6 14:31:19 2018 CET", "Thu Dec 6 14:31:19 p 2018",
          "Thu Dec 6 14:31:19"}) {
        const ReadLog log = readLog("date " + std::string(date) + "\nbase hex  timestamps absolute\n" +
                                    ascAt("0.5") + ascAt("1.5"));
        EXPECT_EQ(log.times, CanLogTimes::relative) << date;
        EXPECT_FALSE(log.isSince1970) << date;
        EXPECT_THAT(log.microseconds(), ElementsAre(0, 1'000'000)) << date;
        EXPECT_THAT(log.faults, ElementsAre(Pair(1, CanLogFault::badDate))) << date;
    }
}

TEST(CanLogTimes, WithoutADateBehindItsWordTheLogStaysRelative)
{
    EXPECT_EQ(readLog("date \nbase hex  timestamps absolute\n" + ascAt("0.5")).times, CanLogTimes::relative);
}

TEST(CanLogTimes, ADateThatCannotBeReadIsToldOnce)
{
    const ReadLog log = readLog("date today\nbase hex  timestamps absolute\nBegin Triggerblock now\n" +
                                ascAt("0.5") + "End Triggerblock\nBegin Triggerblock\n");
    EXPECT_THAT(log.faults, ElementsAre(Pair(1, CanLogFault::badDate)));
    EXPECT_THAT(readLog("base hex  timestamps absolute\nBegin Triggerblock\n" + ascAt("0.5")).faults,
                IsEmpty());
}

// An absent one.
std::int64_t timeOf(const CanFrame &frame)
{
    return frame.time.value_or(Instant(-1)).count();
}

TEST(CanLogTimes, ALineOfAnotherKindKeepsItsFrameWithoutItsTime)
{
    const std::string absolute = candumpAt("1544106679.0");
    const std::string later = candumpAt("1544106680.0");
    const ReadLog log = readLog(absolute + candumpAt("0.5") + ascAt("0.25") + later);
    EXPECT_THAT(log.microseconds(), ElementsAre(1'544'106'679'000'000, -1, -1, 1'544'106'680'000'000));
    EXPECT_TRUE(log.isSince1970);
    EXPECT_THAT(log.faults, ElementsAre(Pair(2, CanLogFault::otherTime), Pair(3, CanLogFault::otherTime)));

    const ReadLog begunSmall = readLog(candumpAt("0.5") + absolute + later);
    EXPECT_EQ(begunSmall.times, CanLogTimes::absolute);
    EXPECT_THAT(begunSmall.microseconds(), ElementsAre(-1, 1'544'106'679'000'000, 1'544'106'680'000'000));
    EXPECT_THAT(begunSmall.faults, ElementsAre(Pair(1, CanLogFault::otherTime)));

    const ReadLog small = readLog(candumpAt("0.5") + candumpAt("0.75") + absolute + candumpAt("1.0"));
    EXPECT_FALSE(small.isSince1970);
    EXPECT_THAT(small.microseconds(), ElementsAre(0, 250'000, -1, 500'000));
    EXPECT_THAT(small.faults, ElementsAre(Pair(3, CanLogFault::otherTime)));
}

TEST(CanLogTimes, ADateBehindTheFirstFramesIsOfAnotherKind)
{
    const ReadLog log = readLog("base hex  timestamps absolute\n" + ascAt("0.5") +
                                "date Thu Dec 6 14:31:19 2018\n" + ascAt("0.75"));
    EXPECT_EQ(log.times, CanLogTimes::relative);
    EXPECT_FALSE(log.isSince1970);
    EXPECT_EQ(timeOf(log.frames[0]), 0);
    EXPECT_FALSE(log.frames[1].time);
    EXPECT_THAT(log.faults, ElementsAre(Pair(4, CanLogFault::otherTime)));
}

TEST(CanLogTimes, AnAscFileWithoutADateIsNotAbsolute)
{
    const ReadLog log = readLog("base hex  timestamps absolute\n" + ascAt("0.5"), CanLogTimes::absolute);
    EXPECT_EQ(log.times, CanLogTimes::relative);
    EXPECT_FALSE(log.isSince1970);
}

// Each from the first one, in seconds.
std::vector<std::int64_t> secondsInBerlin(const std::string &text)
{
    const QByteArray zone = qgetenv("TZ");
    qputenv("TZ", "Europe/Berlin");
    const auto restore = qScopeGuard([&] { zone.isNull() ? qunsetenv("TZ") : qputenv("TZ", zone); });
    std::vector<std::int64_t> seconds;
    const ReadLog log = readLog(text);
    for (const CanFrame &frame : log.frames)
        seconds.push_back((timeOf(frame) - timeOf(log.frames.front())) / 1'000'000);
    return seconds;
}

std::string on(const std::string &time)
{
    return '(' + time + ") can0 185#00\n";
}

TEST(CanLogTimes, InAnHourThatIsLeftOutTheClockGoesOn)
{
    EXPECT_THAT(secondsInBerlin(on("2018-03-25 01:59:00.0") + on("2018-03-25 02:10:00.0") +
                                on("2018-03-25 02:30:00.0") + on("2018-03-25 02:50:01.0") +
                                on("2018-03-25 03:00:00.0")),
                ElementsAre(0, 11 * 60, 31 * 60, 51 * 60 + 1, 60));
}

TEST(CanLogTimes, RelativeOnesOfAscCountFromTheLineBeforeAlsoIfThatIsAnEvent)
{
    const std::string lines = ascAt("0.5") + "0.25 1 Statistic: D 0\n" + ascAt("0.125");
    const ReadLog log = readLog("base hex  timestamps relative\n" + lines);
    EXPECT_EQ(log.times, CanLogTimes::differences);
    EXPECT_FALSE(log.isSince1970);
    EXPECT_THAT(log.microseconds(), ElementsAre(0, 375'000));
    const ReadLog dated = readLog("date Thu Dec 6 14:31:19 2018\nbase hex  timestamps relative\n" + lines);
    EXPECT_TRUE(dated.isSince1970);
    const std::int64_t begin = localMicroseconds(sixthOfDecember, {14, 31, 19});
    EXPECT_THAT(dated.microseconds(), ElementsAre(begin + 500'000, begin + 875'000));
}

TEST(CanLogTimes, BusmasterWritesTheTimeOfDay)
{
    const ReadLog log = readLog("date Thu Dec 6 02:31:19 pm 2018\nbase hex\n" + ascAt("52279.5") +
                                ascAt("86399.0") + ascAt("1.0"));
    EXPECT_EQ(log.times, CanLogTimes::absolute);
    EXPECT_THAT(log.microseconds(),
                ElementsAre(localMicroseconds(sixthOfDecember, {14, 31, 19, 500}),
                            localMicroseconds(sixthOfDecember, {23, 59, 59}),
                            localMicroseconds(sixthOfDecember, {23, 59, 59}) + 2'000'000));
    EXPECT_EQ(readLog("base hex\n" + ascAt("52279.5")).times, CanLogTimes::relative);
}

TEST(CanLogTimes, ADateCanBeLeftOutOfAccount)
{
    const ReadLog log =
        readLog("date Thu Dec 6 14:31:19 2018\nbase hex  timestamps absolute\n" + ascAt("0.5") + ascAt("1.5"),
                CanLogTimes::relative);
    EXPECT_FALSE(log.isSince1970);
    EXPECT_THAT(log.microseconds(), ElementsAre(0, 1'000'000));
}

} // namespace
} // namespace codewheel
