// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/freshness_text.h"

#include "vocabulary/local_time.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QTimeZone>

#include <algorithm>

namespace codewheel {
namespace {

// The translation context of these texts.
struct FreshnessText
{
    Q_DECLARE_TR_FUNCTIONS(Freshness)
};

constexpr qint64 minute = 60;
constexpr qint64 hour = 60 * minute;
constexpr qint64 day = 24 * hour;

} // namespace

QString agoText(const QDateTime &then, const QDateTime &now)
{
    const qint64 seconds = std::max<qint64>(0, then.secsTo(now));
    if (seconds < minute)
        return FreshnessText::tr("%1 s ago").arg(seconds);
    if (seconds < hour)
        return FreshnessText::tr("%1 min ago").arg(seconds / minute);
    if (seconds < day)
        return FreshnessText::tr("%1 h %2 min ago").arg(seconds / hour).arg(seconds % hour / minute);
    return QLocale().toString(then.toLocalTime(), QLocale::ShortFormat);
}

QString recordedText(const QDateTime &then)
{
    const QDateTime there = then.toLocalTime();
    return QStringLiteral("%1 %2%3").arg(QLocale().toString(there.date(), QLocale::ShortFormat),
                                         there.time().toString(QStringLiteral("HH:mm:ss")),
                                         offsetIfTwice(there));
}

QString momentText(const QDateTime &at, const QDateTime &now)
{
    const QDateTime there = at.toTimeZone(now.timeZone());
    return there.date() == now.date() ? QLocale().toString(there.time(), QLocale::ShortFormat)
                                      : QLocale().toString(there, QLocale::ShortFormat);
}

QString unchangedText(const QDateTime &since, const QDateTime &now)
{
    constexpr qint64 notable = 10;
    return since.secsTo(now) < notable ? QString() : momentText(since, now);
}

QString freshnessText(Freshness::Reason reason)
{
    switch (reason) {
    case Freshness::Reason::none:
        break;
    case Freshness::Reason::notSeen:
        return FreshnessText::tr("Nothing has come from the encoder yet.");
    case Freshness::Reason::disconnected:
        return FreshnessText::tr("Not connected.");
    case Freshness::Reason::linkLost:
        return FreshnessText::tr("The link is lost.");
    case Freshness::Reason::stopped:
        return FreshnessText::tr("The bus does not run.");
    case Freshness::Reason::notOnBus:
        return FreshnessText::tr("The device is not on the bus.");
    case Freshness::Reason::unsettled:
        return FreshnessText::tr("No two reads of its word agree.");
    case Freshness::Reason::silent:
        return FreshnessText::tr("The encoder does not answer.");
    case Freshness::Reason::notAsked:
        return FreshnessText::tr("The encoder is not being asked: something else keeps the line busy.");
    case Freshness::Reason::slept:
        return FreshnessText::tr("The computer has slept since.");
    case Freshness::Reason::recorded:
        return FreshnessText::tr("This is a recording.");
    case Freshness::Reason::notRecorded:
        return FreshnessText::tr("Of this time nothing is recorded.");
    }
    return {};
}

QString freshnessBrief(Freshness::Reason reason)
{
    switch (reason) {
    case Freshness::Reason::none:
        break;
    case Freshness::Reason::notSeen:
        return FreshnessText::tr("Nothing yet");
    case Freshness::Reason::disconnected:
        return FreshnessText::tr("Not connected");
    case Freshness::Reason::linkLost:
        return FreshnessText::tr("Link lost");
    case Freshness::Reason::stopped:
        return FreshnessText::tr("Bus stopped");
    case Freshness::Reason::notOnBus:
        return FreshnessText::tr("Not on the bus");
    case Freshness::Reason::unsettled:
        return FreshnessText::tr("Unsettled", "its word");
    case Freshness::Reason::silent:
        return FreshnessText::tr("No answer");
    case Freshness::Reason::notAsked:
        return FreshnessText::tr("Not asked");
    case Freshness::Reason::slept:
        return FreshnessText::tr("Computer slept");
    case Freshness::Reason::recorded:
        return FreshnessText::tr("Recording");
    case Freshness::Reason::notRecorded:
        return FreshnessText::tr("Not recorded");
    }
    return {};
}

QString lastSeenText(Freshness::Reason reason, const QString &when)
{
    return FreshnessText::tr("%1 Last seen: %2.", "a sentence, date and time")
        .arg(freshnessText(reason), when);
}

} // namespace codewheel
