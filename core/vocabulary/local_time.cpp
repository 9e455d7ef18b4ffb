// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/local_time.h"

#include <QRegularExpression>

#include <cstdlib>

namespace codewheel {
namespace {

constexpr qint64 secondsPerDay = qint64{24} * 60 * 60;

QDateTime inZone(const QDateTime &utc, const QTimeZone &zone)
{
    return utc.toTimeZone(zone);
}

// When the clocks there said this. `clock` has date and time of day, in UTC for want of a better zone.
TypedTime timesOf(const QDateTime &clock, const QTimeZone &zone)
{
    const QDateTime earlier = clock.addSecs(-zone.offsetFromUtc(clock.addSecs(-secondsPerDay)));
    const QDateTime later = clock.addSecs(-zone.offsetFromUtc(clock.addSecs(secondsPerDay)));
    const auto isMeant = [&](const QDateTime &utc) { return utc.addSecs(zone.offsetFromUtc(utc)) == clock; };
    if (isMeant(earlier) || isMeant(later))
        return {inZone(isMeant(earlier) ? earlier : later, zone),
                inZone(isMeant(later) ? later : earlier, zone)};
    const QTimeZone::OffsetData leftOut = zone.previousTransition(earlier.addSecs(1));
    const QDateTime then = inZone(leftOut.atUtc.isValid() ? leftOut.atUtc : earlier, zone);
    return {then, then};
}

} // namespace

std::optional<TypedTime> TypedTime::parse(const QString &text, const QTimeZone &zone)
{
    static const QRegularExpression form(QStringLiteral(
        "^(\\d{4}-\\d\\d-\\d\\d)(?:T(\\d\\d:\\d\\d)(:\\d\\d)?(\\.\\d{1,3})?(Z|[+-]\\d\\d:?\\d\\d)?)?$"));
    const auto match = form.match(text);
    if (!match.hasMatch() || (match.hasCaptured(4) && !match.hasCaptured(3)))
        return std::nullopt;
    const auto part = [&](int which) { return match.captured(which); };
    const QString time = part(2).isEmpty() ? QStringLiteral("00:00") : part(2);
    const QString seconds = part(3).isEmpty() ? QStringLiteral(":00") : part(3);
    const auto read = [&](const QString &offset) {
        return QDateTime::fromString(part(1) + u'T' + time + seconds + part(4) + offset, Qt::ISODateWithMs);
    };
    const QDateTime clock = read(part(5).isEmpty() ? QStringLiteral("Z") : part(5));
    if (!clock.isValid())
        return std::nullopt;
    TypedTime typed =
        part(5).isEmpty() ? timesOf(clock, zone) : TypedTime{inZone(clock, zone), inZone(clock, zone)};
    typed.exactToMs = !part(4).isEmpty() ? 1 : !part(3).isEmpty() ? 1'000 : 60'000;
    return typed;
}

bool TypedTime::covers(const QDateTime &at) const
{
    const auto covered = [&](const QDateTime &from) { return at >= from && at < from.addMSecs(exactToMs); };
    return covered(first) || covered(last);
}

QString offsetText(const QDateTime &at)
{
    const int minutes = at.offsetFromUtc() / 60;
    const auto padded = [](int number) { return QStringLiteral("%1").arg(number, 2, 10, QLatin1Char('0')); };
    return QLatin1Char(minutes < 0 ? '-' : '+') + padded(std::abs(minutes) / 60) + u':' +
           padded(std::abs(minutes) % 60);
}

QString offsetIfTwice(const QDateTime &at)
{
    if (at.timeSpec() != Qt::LocalTime && at.timeSpec() != Qt::TimeZone)
        return {};
    const TypedTime times = timesOf(QDateTime(at.date(), at.time(), Qt::UTC), at.timeZone());
    return times.first == times.last ? QString() : offsetText(at);
}

} // namespace codewheel
