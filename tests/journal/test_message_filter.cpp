// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/message_fields.h"
#include "journal/message_filter.h"
#include "tests/support/places.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

const QDateTime afternoon(QDate(2026, 3, 1), QTime(14, 2, 5, 7));

StoredMessage fault()
{
    return storedMessage({.place = "2.0"_ring,
                          .severity = Severity::fault,
                          .id = MessageId::deviceFault,
                          .arguments = {std::int64_t{3}, Word{0x86000000}}},
                         afternoon);
}

bool fits(const char *text)
{
    return MessageTextMatcher(QString::fromUtf8(text)).fits(fault());
}

TEST(MessageTextMatcher, FindsWhatIsShownInAnyColumn)
{
    EXPECT_TRUE(fits("error 3 (IN 8600")); // across the border between pattern and argument
    EXPECT_TRUE(fits("ENCODER reports"));
    EXPECT_TRUE(fits("fault"));
    EXPECT_TRUE(fits("2.0"));
    EXPECT_TRUE(fits("14:02:05.007"));
    EXPECT_TRUE(fits(""));
    EXPECT_FALSE(fits("deviceFault")); // the code is not shown
    EXPECT_FALSE(fits("error 4"));
    EXPECT_FALSE(fits("14:03"));
}

// Over a day and both daylight saving changes, in whatever time zone this runs.
TEST(MessageTextMatcher, SeesTheTimesThatAreShown)
{
    for (qint64 at = afternoon.toMSecsSinceEpoch(); at < afternoon.addDays(300).toMSecsSinceEpoch();
         at += qint64{47} * 61'000) {
        const QString shown = messageTime(at);
        MessageTextMatcher matcher(shown);
        StoredMessage message = fault();
        message.at = at + 86'400'000; // what it has cached is for another day
        matcher.fits(message);
        message.at = at;
        EXPECT_TRUE(matcher.fits(message)) << shown.toStdString();
    }
}

TEST(MessageTextMatcher, TellsMessagesOfTheSameCodeApart)
{
    MessageTextMatcher matcher(QStringLiteral("020000FF"));
    const auto written = [](Word word) {
        return storedMessage({.id = MessageId::wordWritten, .arguments = {word}}, afternoon);
    };
    EXPECT_TRUE(matcher.fits(written(0x020000FF)));
    EXPECT_FALSE(matcher.fits(written(0x020000FE)));
    EXPECT_TRUE(matcher.fits(written(0x020000FF)));
}

} // namespace
} // namespace codewheel
