// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_log_date.h"

#include "can/can_log_words.h"
#include "vocabulary/local_time.h"

#include <array>

namespace codewheel {
namespace {

struct MonthName
{
    std::string_view name;
    int month;
};

// English and German; what is behind the third letter does not matter.
constexpr std::array monthNames{
    MonthName{"jan", 1},    MonthName{"feb", 2},  MonthName{"mar", 3},  MonthName{"m\xC3\xA4r", 3},
    MonthName{"m\xE4r", 3}, MonthName{"apr", 4},  MonthName{"may", 5},  MonthName{"mai", 5},
    MonthName{"jun", 6},    MonthName{"jul", 7},  MonthName{"aug", 8},  MonthName{"sep", 9},
    MonthName{"oct", 10},   MonthName{"okt", 10}, MonthName{"nov", 11}, MonthName{"dec", 12},
    MonthName{"dez", 12},
};

int monthNamed(std::string_view word)
{
    for (const MonthName &each : monthNames)
        if (beginsWith(word, each.name))
            return each.month;
    return 0;
}

int smallNumber(std::string_view digits)
{
    constexpr std::size_t longest = 4;
    const auto number = digits.size() <= longest ? numberIn(digits, 10) : std::nullopt;
    return number ? static_cast<int>(*number) : -1;
}

// "14:31:19.123", "02:31:19"
QTime timeOfDay(std::string_view text)
{
    const auto hourEnd = text.find(':');
    const auto minuteEnd = hourEnd == std::string_view::npos ? hourEnd : text.find(':', hourEnd + 1);
    if (minuteEnd == std::string_view::npos)
        return {};
    const auto seconds = secondsIn(text.substr(minuteEnd + 1));
    const auto milliseconds = seconds ? std::chrono::floor<std::chrono::milliseconds>(*seconds).count() : -1;
    if (milliseconds < 0 || milliseconds >= 60'000)
        return {};
    return {smallNumber(text.substr(0, hourEnd)),
            smallNumber(text.substr(hourEnd + 1, minuteEnd - hourEnd - 1)),
            static_cast<int>(milliseconds / 1000), static_cast<int>(milliseconds % 1000)};
}

// 12 am is midnight, 12 pm is noon.
QTime onTwelveHourClock(QTime time, bool isAfternoon)
{
    constexpr int halfDay = 12;
    if (time.hour() < 1 || time.hour() > halfDay)
        return {};
    return {time.hour() % halfDay + (isAfternoon ? halfDay : 0), time.minute(), time.second(), time.msec()};
}

Instant instantOf(const QDateTime &local)
{
    return std::chrono::milliseconds(local.toMSecsSinceEpoch());
}

// In an hour that is left out the clock goes on as if it was not put forward.
Instant asBeforeTheChange(const QString &text, const QDateTime &change)
{
    QDateTime clock = QDateTime::fromString(text, QStringLiteral("yyyy-MM-ddTHH:mm"));
    clock.setTimeSpec(Qt::UTC);
    return instantOf(clock.addSecs(-change.addSecs(-1).offsetFromUtc()));
}

} // namespace

void CanLogDates::look(std::string_view digits)
{
    m_minute = digits;
    QString text = QString::fromLatin1(digits.data(), static_cast<qsizetype>(digits.size()));
    text.replace(u' ', u'T');
    const auto typed = TypedTime::parse(text, QTimeZone::systemTimeZone());
    m_first = typed ? std::optional(instantOf(typed->first)) : std::nullopt;
    m_last = typed ? instantOf(typed->last) : Instant();
    if (typed && typed->first.toString(QStringLiteral("yyyy-MM-ddTHH:mm")) != text)
        m_first = m_last = asBeforeTheChange(text, typed->first);
}

std::optional<Instant> CanLogDates::at(std::string_view text)
{
    constexpr std::size_t minuteLength = std::string_view("2018-12-06 14:31").size();
    if (text.size() < minuteLength + 2 || text[minuteLength] != ':')
        return std::nullopt;
    if (const std::string_view digits = text.substr(0, minuteLength); digits != m_minute)
        look(digits);
    const auto seconds = secondsIn(text.substr(minuteLength + 1));
    if (!m_first || !seconds || *seconds < Instant() || *seconds >= std::chrono::minutes(1))
        return std::nullopt;
    const Instant first = *m_first + *seconds;
    m_before = first < m_before && m_last + *seconds >= m_before ? m_last + *seconds : first;
    return m_before;
}

std::optional<Instant> ascDate(std::string_view text)
{
    constexpr int firstYear = 1970;
    CanLogWords words(text);
    words.next(); // the day of the week
    const int month = monthNamed(words.next());
    const int day = smallNumber(words.next());
    QTime time = timeOfDay(words.next());
    std::string_view word = words.next();
    const bool isAfternoon = beginsWith(word, "pm") || beginsWith(word, "nachm");
    if (isAfternoon || beginsWith(word, "am") || beginsWith(word, "vorm")) {
        time = onTwelveHourClock(time, isAfternoon);
        word = words.next();
    }
    const QDate date(smallNumber(word), month, day);
    if (!date.isValid() || date.year() < firstYear || !time.isValid() || !words.isAtEnd())
        return std::nullopt;
    return instantOf(QDateTime(date, time));
}

Instant midnightBefore(Instant at)
{
    const auto milliseconds = std::chrono::floor<std::chrono::milliseconds>(at);
    return instantOf(QDateTime::fromMSecsSinceEpoch(milliseconds.count()).date().startOfDay());
}

} // namespace codewheel
