// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/trend/trend_csv_test.h"

#include <QDateTime>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

const QLocale german(QStringLiteral("de_DE"));
const QLocale american(QStringLiteral("en_US"));

std::string numberText(double factor, std::int64_t sample, const std::string &decimalSign = ".")
{
    std::string text;
    CsvNumbers(factor).append(text, sample, decimalSign);
    return text;
}

std::string timeText(const CsvStyle &style, const QDateTime &time, int microseconds = 0)
{
    std::string text;
    CsvTimes(style).append(text, std::chrono::milliseconds(time.toMSecsSinceEpoch()) + Instant(microseconds));
    return text;
}

TEST(CsvNumbers, HaveTheDecimalsThatTellOneStepFromTheNextAndTwoMore)
{
    EXPECT_EQ(numberText(1, 4'294'967'295), "4294967295");
    EXPECT_EQ(numberText(1, -5), "-5");
    EXPECT_EQ(numberText(0.001, 1), "0.001");
    EXPECT_EQ(numberText(0.005, 33'554'431), "167772.155");
    EXPECT_EQ(numberText(360. / 4'096, 1), "0.0879");
    EXPECT_EQ(numberText(360. / 4'096, -2'048), "-180.0000");
    EXPECT_EQ(numberText(1. / 4'096, 1), "0.000244");
    EXPECT_EQ(numberText(360. / 4'096, 0), "0.0000");
    EXPECT_EQ(numberText(20, 3), "60");
    EXPECT_EQ(numberText(0, 3), "0");
}

TEST(CsvNumbers, LeadBackToTheirStep)
{
    for (const double factor : {360. / 4'096, 1. / 8'192, 100. / 7, 1. / 16'777'216, 0.1 / 3})
        for (const std::int64_t step : {1, 2, 4'095, 33'554'431})
            EXPECT_EQ(std::llround(std::stod(numberText(factor, step)) / factor), step) << factor;
}

TEST(CsvStyle, IsThatOfTheCountry)
{
    const CsvStyle inGermany(german, QTimeZone(3'600));
    EXPECT_EQ(inGermany.begin(), "\xEF\xBB\xBF");
    EXPECT_EQ(inGermany.separator, ';');
    EXPECT_EQ(numberText(0.005, 3, inGermany.decimalSign), "0,015");
    const CsvStyle inAmerica(american, QTimeZone(-18'000));
    EXPECT_EQ(inAmerica.begin(), "\xEF\xBB\xBF");
    EXPECT_EQ(inAmerica.separator, ',');
    EXPECT_EQ(numberText(0.005, 3, inAmerica.decimalSign), "0.015");
    EXPECT_EQ(CsvStyle().begin(), "") << "programs take a byte order mark for a part of the first title";
}

TEST(CsvStyle, QuotesAFieldOnlyWhereItMust)
{
    const CsvStyle plain;
    const CsvStyle inGermany(german, QTimeZone(3'600));
    EXPECT_EQ(plain.field(QStringLiteral("1.0 a;b")), "1.0 a;b");
    EXPECT_EQ(inGermany.field(QStringLiteral("1.0 a;b")), "\"1.0 a;b\"");
    EXPECT_EQ(plain.field(QStringLiteral("1.0 a,b")), "\"1.0 a,b\"");
    EXPECT_EQ(inGermany.field(QStringLiteral("1.0 a,b")), "1.0 a,b");
    EXPECT_EQ(plain.field(QStringLiteral("1.0 \"a\"")), "\"1.0 \"\"a\"\"\"");
    EXPECT_EQ(plain.field(QStringLiteral("=1+1")), "\"'=1+1\"");
    EXPECT_EQ(plain.field(QStringLiteral("@x")), "\"'@x\"");
}

TEST(CsvTimes, AreSecondsForProgramsAndTimesOfDayForSpreadsheets)
{
    const QDateTime time(QDate(2026, 3, 1), QTime(13, 2, 3, 45), Qt::UTC);
    EXPECT_EQ(timeText({}, time, 6), "1772370123.045006");
    EXPECT_EQ(timeText({german, QTimeZone(3'600)}, time, 6), "2026-03-01 14:02:03,045006");
    EXPECT_EQ(timeText({american, QTimeZone(-18'000)}, time, 6), "2026-03-01 08:02:03.045006");
    EXPECT_EQ(timeText({}, QDateTime(QDate(1969, 12, 31), QTime(23, 59, 58), Qt::UTC), 250'000), "-1.750000");
}

TEST(CsvTimes, FollowTheClocksOfTheTimeZone)
{
    const QTimeZone berlin("Europe/Berlin");
    ASSERT_TRUE(berlin.isValid());
    CsvTimes times({german, berlin});
    std::string text;
    const QDateTime change(QDate(2026, 3, 29), QTime(1, 0), Qt::UTC);
    for (const Instant beside : {Instant(-1), Instant(0)})
        times.append(text, std::chrono::milliseconds(change.toMSecsSinceEpoch()) + beside);
    EXPECT_EQ(text, "2026-03-29 01:59:59,9999992026-03-29 03:00:00,000000");
}

TEST(CsvTimes, HaveADateBesideTheSeconds)
{
    const QTimeZone berlin("Europe/Berlin");
    CsvTimes times(CsvStyle::withDates(berlin));
    std::string text;
    const QDateTime change(QDate(2026, 10, 25), QTime(1, 0), Qt::UTC); // 3:00 is 2:00 once more
    for (const Instant beside : {Instant(-1), Instant(0)})
        times.append(text, std::chrono::milliseconds(change.toMSecsSinceEpoch()) + beside);
    EXPECT_EQ(text, "1792889999.999999,2026-10-25T02:59:59.999999+02:00"
                    "1792890000.000000,2026-10-25T02:00:00.000000+01:00");
}

TEST(CsvStyle, IsUsedForAWholeTable)
{
    test::SampledTracks tracks;
    tracks[test::ringPosition].append({test::at(0), 1'024});
    tracks[test::ringPosition].interrupt(test::at(1));
    const TrendExtract extract{
        .columns = {{test::ringPosition, QStringLiteral("Kran;1"), {TrackUnit::degrees, 360. / 4'096}}},
        .span = {test::at(0), test::at(10)}};
    EXPECT_EQ(tracks.written(extract, {german, QTimeZone(3'600)}),
              "\xEF\xBB\xBFtime;\"1.0 Kran;1: position [deg]\"\r\n"
              "2026-03-01 14:02:00,000000;90,0000\r\n"
              "2026-03-01 14:02:00,001000;\r\n");
    EXPECT_EQ(tracks.written(extract, CsvStyle::withDates(QTimeZone(3'600))),
              "time [s],date and time,1.0 Kran;1: position [deg]\r\n"
              "1772370120.000000,2026-03-01T14:02:00.000000+01:00,90.0000\r\n"
              "1772370120.001000,2026-03-01T14:02:00.001000+01:00,\r\n");
}

} // namespace
} // namespace codewheel
