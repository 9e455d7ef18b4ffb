// SPDX-License-Identifier: GPL-3.0-or-later
// The hour that comes twice when the clocks are put back, and the one that is left out.
#include "vocabulary/local_time.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

const QTimeZone berlin("Europe/Berlin"); // back on 25 October 2026, 3:00 to 2:00; forward on 29 March

QDateTime utc(int month, int day, int hour, int minute = 0, int second = 0)
{
    return {QDate(2026, month, day), QTime(hour, minute, second), Qt::UTC};
}

TypedTime typed(const char *text)
{
    const auto time = TypedTime::parse(QString::fromLatin1(text), berlin);
    EXPECT_TRUE(time) << text;
    return time.value_or(TypedTime());
}

TEST(TypedTime, IsOneMomentOnMostDays)
{
    const TypedTime afternoon = typed("2026-10-24T14:02");
    EXPECT_EQ(afternoon.first, utc(10, 24, 12, 2));
    EXPECT_EQ(afternoon.last, afternoon.first);
    EXPECT_EQ(typed("2026-03-01").first, utc(2, 28, 23)) << "midnight";
    EXPECT_EQ(typed("2026-03-01T14:02:05.250Z").first, utc(3, 1, 14, 2, 5).addMSecs(250));
    EXPECT_EQ(typed("2026-03-01T14:02-05:00").first, utc(3, 1, 19, 2));
}

TEST(TypedTime, MeansBothWhereAnHourComesTwice)
{
    const TypedTime night = typed("2026-10-25T02:30");
    EXPECT_EQ(night.first, utc(10, 25, 0, 30));
    EXPECT_EQ(night.last, utc(10, 25, 1, 30));
    for (const QDateTime &at : {utc(10, 25, 0, 30, 59), utc(10, 25, 1, 30, 59)})
        EXPECT_TRUE(night.covers(at)) << at.toString().toStdString();
    for (const QDateTime &at : {utc(10, 25, 0, 31), utc(10, 25, 1, 29, 59), utc(10, 25, 1)})
        EXPECT_FALSE(night.covers(at)) << at.toString().toStdString();
}

TEST(TypedTime, WithItsOffsetIsOneOfThem)
{
    EXPECT_EQ(typed("2026-10-25T02:30+01:00").first, utc(10, 25, 1, 30));
    EXPECT_TRUE(typed("2026-10-25T02:30+01:00").covers(utc(10, 25, 1, 30, 40))) << "to the minute";
    EXPECT_FALSE(typed("2026-10-25T02:30+01:00").covers(utc(10, 25, 0, 30)));
    EXPECT_FALSE(typed("2026-10-25T02:30:10+02:00").covers(utc(10, 25, 0, 30, 11)));
}

TEST(TypedTime, OfAnHourThatIsLeftOutIsWhenItWasLeftOut)
{
    for (const char *text : {"2026-03-29T02:00", "2026-03-29T02:30", "2026-03-29T02:59:59"})
        EXPECT_EQ(typed(text).first, utc(3, 29, 1)) << text;
    EXPECT_EQ(typed("2026-03-29T03:00").first, utc(3, 29, 1));
    EXPECT_EQ(typed("2026-03-29T01:59").first, utc(3, 29, 0, 59));
}

TEST(TypedTime, NothingElseIsATime)
{
    for (const char *text : {"", "noon", "14:02", "2026-02-30T14:02", "2026-03-01T25:00", "2026-03-01T14",
                             "2026-03-01T14:02.5", "2026-03-01T14:02+1", "2026-03-01 14:02"})
        EXPECT_FALSE(TypedTime::parse(QString::fromLatin1(text), berlin)) << text;
}

TEST(LocalTime, AnHourThatComesTwiceHasItsOffset)
{
    EXPECT_EQ(offsetIfTwice(utc(10, 25, 0, 30).toTimeZone(berlin)), QStringLiteral("+02:00"));
    EXPECT_EQ(offsetIfTwice(utc(10, 25, 1, 30).toTimeZone(berlin)), QStringLiteral("+01:00"));
    for (const QDateTime &once : {utc(10, 24, 23, 59), utc(10, 25, 2), utc(3, 29, 1), utc(3, 29, 0, 30)})
        EXPECT_EQ(offsetIfTwice(once.toTimeZone(berlin)), QString()) << once.toString().toStdString();
    EXPECT_EQ(offsetIfTwice(utc(10, 25, 0, 30)), QString()) << "UTC has no such hour";
}

TEST(LocalTime, AnOffsetHasSignHoursAndMinutes)
{
    EXPECT_EQ(offsetText(utc(1, 1, 0)), QStringLiteral("+00:00"));
    EXPECT_EQ(offsetText(utc(1, 1, 0).toOffsetFromUtc(-12'600)), QStringLiteral("-03:30"));
}

} // namespace
} // namespace codewheel
