// SPDX-License-Identifier: GPL-3.0-or-later
#include "trend/csv_style.h"

#include "vocabulary/csv_text.h"
#include "vocabulary/local_time.h"

#include <QDateTime>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace codewheel {
namespace {

constexpr int decimalsBeyondAStep = 2;
constexpr int mostDecimals = 12;
constexpr int exactDecimals = 6; // where a step has no more, it is written as it is
constexpr std::int64_t microsecondsPerSecond = 1'000'000;

// "0042"
void appendPadded(std::string &text, std::int64_t number, std::size_t digits)
{
    std::array<char, 20> buffer{};
    const auto *const end = std::to_chars(buffer.begin(), buffer.end(), number).ptr;
    const auto length = static_cast<std::size_t>(end - buffer.data());
    text.append(digits - std::min(digits, length), '0').append(buffer.data(), length);
}

bool isWhole(double value)
{
    return std::abs(value - std::round(value)) < value * 1e-9;
}

int decimalsFor(double factor)
{
    const double step = std::abs(factor);
    if (!std::isnormal(step))
        return 0;
    for (int decimals = 0; decimals <= exactDecimals; ++decimals)
        if (isWhole(step * std::pow(10, decimals)))
            return decimals;
    return std::clamp(static_cast<int>(std::ceil(-std::log10(step))) + decimalsBeyondAStep, 0, mostDecimals);
}

} // namespace

CsvStyle::CsvStyle(const QLocale &locale, const QTimeZone &timeZone)
    : separator(locale.decimalPoint() == QStringLiteral(",") ? ';' : ',')
    , decimalSign(locale.decimalPoint().toStdString())
    , hasSeconds(false)
    , zone(timeZone)
{}

CsvStyle CsvStyle::withDates(const QTimeZone &zone)
{
    CsvStyle style;
    style.zone = zone;
    return style;
}

std::string CsvStyle::field(const QString &text) const
{
    const QString quoted = csvText(text); // which also disarms what a spreadsheet would take for a formula
    const bool isPlain = !text.contains(QLatin1Char(separator)) && quoted == u'"' + text + u'"';
    return (isPlain ? text : quoted).toStdString();
}

void CsvTimes::append(std::string &text, Instant sinceEpoch)
{
    if (m_style.hasSeconds)
        appendSeconds(text, sinceEpoch);
    if (m_style.hasSeconds && m_style.zone)
        text += m_style.separator;
    if (m_style.zone)
        appendDate(text, sinceEpoch);
}

void CsvTimes::appendSeconds(std::string &text, Instant sinceEpoch) const
{
    const std::int64_t microseconds = std::abs(sinceEpoch.count());
    if (sinceEpoch.count() < 0)
        text += '-';
    appendPadded(text, microseconds / microsecondsPerSecond, 1);
    appendFraction(text, microseconds % microsecondsPerSecond);
}

// Year, month and day in this order are understood by spreadsheets of every country. The clocks of a time
// zone are changed at the beginning of a minute.
void CsvTimes::appendDate(std::string &text, Instant sinceEpoch)
{
    const auto minute = std::chrono::floor<std::chrono::minutes>(sinceEpoch);
    if (m_minute != minute) {
        m_minute = minute;
        const auto there =
            QDateTime::fromMSecsSinceEpoch(std::chrono::milliseconds(minute).count(), *m_style.zone);
        const QString form = m_style.isForSpreadsheets() ? QStringLiteral("yyyy-MM-dd HH:mm:")
                                                         : QStringLiteral("yyyy-MM-ddTHH:mm:");
        m_beginOfMinute = there.toString(form).toStdString();
        m_offset = m_style.isForSpreadsheets() ? "" : offsetText(there).toStdString();
    }
    const std::int64_t microseconds = (sinceEpoch - minute).count();
    text += m_beginOfMinute;
    appendPadded(text, microseconds / microsecondsPerSecond, 2);
    appendFraction(text, microseconds % microsecondsPerSecond);
    text += m_offset;
}

void CsvTimes::appendFraction(std::string &text, std::int64_t microseconds) const
{
    text += m_style.decimalSign;
    appendPadded(text, microseconds, 6);
}

CsvNumbers::CsvNumbers(double factor)
    : m_factor(factor)
    , m_decimals(decimalsFor(factor))
{}

void CsvNumbers::append(std::string &text, std::int64_t sample, const std::string &decimalSign) const
{
    std::array<char, 384> buffer{}; // the largest double has 309 digits before the point
    char *const begin = buffer.data();
    if (m_factor == 1) {
        text.append(begin, std::to_chars(begin, begin + buffer.size(), sample).ptr);
        return;
    }
    const double value = static_cast<double>(sample) * m_factor;
    char *const end =
        std::to_chars(begin, begin + buffer.size(), value, std::chars_format::fixed, m_decimals).ptr;
    char *const point = std::find(begin, end, '.');
    text.append(begin, point);
    if (point != end)
        text.append(decimalSign).append(point + 1, end);
}

} // namespace codewheel
