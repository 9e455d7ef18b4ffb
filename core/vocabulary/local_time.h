// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <QTimeZone>

#include <optional>

namespace codewheel {

// What somebody means who writes a time of day. Where the clocks are put back an hour comes twice.
struct TypedTime
{
    QDateTime first;
    QDateTime last;            // another moment only in an hour that comes twice
    qint64 exactToMs = 60'000; // as written: to the minute, the second or the millisecond

    // ISO 8601: "2026-03-01T14:02:05.250", without seconds, with an offset ("+02:00", "Z"), without which it
    // is a time in `zone`; a date alone is its midnight. An hour that is left out means the moment at which
    // it was.
    static std::optional<TypedTime> parse(const QString &text, const QTimeZone &zone);

    bool covers(const QDateTime &at) const; // as exactly as it was written
};

QString offsetText(const QDateTime &at); // from UTC: "+02:00"
// The offset of a time in an hour that comes twice there, to tell one from the other; otherwise empty.
QString offsetIfTwice(const QDateTime &at);

} // namespace codewheel
