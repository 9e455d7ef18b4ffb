// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <QLocale>
#include <QTimeZone>

#include <optional>
#include <string>

namespace codewheel {

// How numbers and times stand in a table of comma-separated values (docs/trend-files.md).
struct CsvStyle
{
    // For programs, the same everywhere: comma and point, times in seconds since 1970, UTC.
    CsvStyle() = default;
    // The same with a second column for people: date and time of day there, with its offset from UTC.
    static CsvStyle withDates(const QTimeZone &zone);
    // As the spreadsheets of a country want it: its decimal sign, a semicolon where that is a comma, dates
    // and times of day in this time zone, and a byte order mark, without which some take UTF-8 for something
    // else.
    CsvStyle(const QLocale &locale, const QTimeZone &zone);

    bool isForSpreadsheets() const { return !hasSeconds; }
    std::string begin() const { return isForSpreadsheets() ? "\xEF\xBB\xBF" : ""; } // of the file
    std::string timeTitle() const { return isForSpreadsheets() ? "time" : "time [s]"; }
    // Of the second column; empty: there is none.
    std::string dateTitle() const { return hasSeconds && zone ? "date and time" : ""; }
    // A title or another text, in quotation marks if need be.
    std::string field(const QString &text) const;

    char separator = ',';
    std::string decimalSign{"."};
    bool hasSeconds = true;
    std::optional<QTimeZone> zone{}; // of the dates; nothing: there are none
};

// Appends times to a text, fast where they follow one another.
class CsvTimes
{
public:
    explicit CsvTimes(const CsvStyle &style)
        : m_style(style)
    {}

    void append(std::string &text, Instant sinceEpoch);

private:
    void appendSeconds(std::string &text, Instant sinceEpoch) const;
    void appendDate(std::string &text, Instant sinceEpoch);
    void appendFraction(std::string &text, std::int64_t microseconds) const;

    const CsvStyle m_style;
    std::optional<std::chrono::minutes> m_minute; // that m_beginOfMinute is of
    std::string m_beginOfMinute;                  // "2026-03-01 14:02:"
    std::string m_offset;                         // "+01:00"
};

// Appends the values of a column to a text: as many decimals as it takes to tell one step from the next, and
// two more.
class CsvNumbers
{
public:
    // From a sample to its value.
    explicit CsvNumbers(double factor);

    void append(std::string &text, std::int64_t sample, const std::string &decimalSign) const;

private:
    double m_factor;
    int m_decimals;
};

} // namespace codewheel
