// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/ticks.h"

#include <QDateTime>
#include <QLocale>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using testing::Each;
using testing::ElementsAre;
using testing::SizeIs;

const QLocale english(QLocale::English, QLocale::UnitedKingdom);
const QLocale german(QLocale::German, QLocale::Germany);

std::vector<std::string> textsOf(const std::vector<Tick> &ticks)
{
    std::vector<std::string> texts;
    for (const Tick &tick : ticks)
        texts.push_back(tick.text.toStdString());
    return texts;
}

// 1 March 2026, 14:02 local time.
Instant moment()
{
    return std::chrono::milliseconds(QDateTime(QDate(2026, 3, 1), QTime(14, 2)).toMSecsSinceEpoch());
}

TEST(TicksTest, ValuesAreRound)
{
    const auto ticks = valueTicks(-3, 97, 5, english);
    EXPECT_THAT(textsOf(ticks), ElementsAre("0", "20", "40", "60", "80"));
    EXPECT_DOUBLE_EQ(ticks.front().at, 0.03);
    EXPECT_THAT(textsOf(valueTicks(0.0499, 0.1001, 6, german)),
                ElementsAre("0,05", "0,06", "0,07", "0,08", "0,09", "0,10"));
    EXPECT_THAT(textsOf(valueTicks(-0.2, 0.2, 4, english)), ElementsAre("-0.2", "-0.1", "0.0", "0.1", "0.2"));
}

TEST(TicksTest, WordsAreHex)
{
    EXPECT_THAT(textsOf(hexTicks(0, 4294967295.0, 4)),
                ElementsAre("00000000", "40000000", "80000000", "C0000000"));
    EXPECT_THAT(textsOf(hexTicks(0xC2000000, 0xC20000FF, 2)), ElementsAre("C2000000", "C2000080"));
}

TEST(TicksTest, TimesAreRoundTimesOfTheDay)
{
    const Instant at = moment() + 3s;
    EXPECT_THAT(textsOf(timeTicks({at, at + 60s}, 5, english)),
                ElementsAre("14:02:15", "14:02:30", "14:02:45", "14:03:00"));
    EXPECT_THAT(textsOf(timeTicks({at, at + 2h}, 4, english)),
                ElementsAre("14:30", "15:00", "15:30", "16:00"));
    EXPECT_THAT(textsOf(timeTicks({moment(), moment() + 3ms}, 3, german)),
                ElementsAre("14:02:00,000", "14:02:00,001", "14:02:00,002"));
    EXPECT_THAT(textsOf(timeTicks({moment(), moment() + 30us}, 3, english)),
                ElementsAre("14:02:00.000000", "14:02:00.000010", "14:02:00.000020"));
}

TEST(TicksTest, WhereADayBeginsItStandsThere)
{
    const Instant evening = moment() + 9h;
    EXPECT_THAT(textsOf(timeTicks({evening, evening + 3h}, 3, english)),
                ElementsAre("02/03/2026", "01:00", "02:00"));
    EXPECT_EQ(spanDayText({evening, evening + 3h}, german), QStringLiteral("01.03.26 – 02.03.26"));
    EXPECT_EQ(spanDayText({evening, evening + 1s}, german), QStringLiteral("01.03.26"));
}

TEST(TicksTest, ThereAreNeverMoreThanFit)
{
    for (Instant length = 100us; length < 24h * 400; length = length * 7 / 3)
        for (const int most : {2, 5, 12})
            EXPECT_LE(timeTicks({moment(), moment() + length}, most, english).size(),
                      static_cast<std::size_t>(most) + 1)
                << length.count();
}

TEST(TicksTest, DurationsHaveTheUnitThatSuitsThem)
{
    EXPECT_EQ(durationText(1'250us, english), QStringLiteral("1.250 ms"));
    EXPECT_EQ(durationText(-2s, german), QStringLiteral("-2,000000 s"));
    EXPECT_EQ(durationText(45s, english), QStringLiteral("45.000 s"));
    EXPECT_EQ(durationText(30min, english), QStringLiteral("30.00 min"));
    EXPECT_EQ(roughDurationText(40s, english), QStringLiteral("40 s"));
    EXPECT_EQ(roughDurationText(108min, english), QStringLiteral("1 h 48 min"));
    EXPECT_EQ(roughDurationText(76h, english), QStringLiteral("3 d 4 h"));
}

TEST(TicksTest, ValuesHaveTheDigitsThatCount)
{
    EXPECT_EQ(valueText(12'345, 1, english), QStringLiteral("12,345"));
    EXPECT_EQ(valueText(1.23456, 360.0 / 8'192, german), QStringLiteral("1,23"));
    EXPECT_EQ(valueText(-1e-9, 0.01, english), QStringLiteral("0.00"));
}

} // namespace
} // namespace codewheel
