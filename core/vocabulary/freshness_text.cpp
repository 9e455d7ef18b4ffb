// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/freshness_text.h"

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/local_time.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QTimeZone>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

struct FreshnessRow
{
    Freshness::Reason reason;
    const char *text;
    const char *brief; // empty also where it has a comment for translators
};

struct FreshnessText
{
    Q_DECLARE_TR_FUNCTIONS(Freshness)

public:
    static constexpr auto rows = std::to_array<FreshnessRow>({
        {Freshness::Reason::none, "", ""},
        {Freshness::Reason::notSeen, QT_TR_NOOP("Nothing has come from the encoder yet."),
         QT_TR_NOOP("Nothing yet")},
        {Freshness::Reason::disconnected, QT_TR_NOOP("Not connected."), QT_TR_NOOP("Not connected")},
        {Freshness::Reason::linkLost, QT_TR_NOOP("The link is lost."), QT_TR_NOOP("Link lost")},
        {Freshness::Reason::stopped, QT_TR_NOOP("The bus does not run."), QT_TR_NOOP("Bus stopped")},
        {Freshness::Reason::notOnBus, QT_TR_NOOP("The device is not on the bus."),
         QT_TR_NOOP("Not on the bus")},
        {Freshness::Reason::unsettled, QT_TR_NOOP("No two reads of its word agree."), ""},
        {Freshness::Reason::silent, QT_TR_NOOP("The encoder does not answer."), QT_TR_NOOP("No answer")},
        {Freshness::Reason::notAsked,
         QT_TR_NOOP("The encoder is not being asked: something else keeps the line busy."),
         QT_TR_NOOP("Not asked")},
        {Freshness::Reason::watched,
         QT_TR_NOOP("In Watch the encoder is not asked, and it sends no position by itself."),
         QT_TR_NOOP("Not asked")},
        {Freshness::Reason::heldBack,
         QT_TR_NOOP(
             "The encoder is not being asked, as others are at work on the bus: another master, or J1939."),
         QT_TR_NOOP("Not asked")},
        {Freshness::Reason::nodeStopped, QT_TR_NOOP("The node is stopped, so it sends and answers nothing."),
         QT_TR_NOOP("Stopped")},
        {Freshness::Reason::slept, QT_TR_NOOP("The computer has slept since."), QT_TR_NOOP("Computer slept")},
        {Freshness::Reason::recorded, QT_TR_NOOP("This is a recording."), QT_TR_NOOP("Recording")},
        {Freshness::Reason::notRecorded, QT_TR_NOOP("Of this time nothing is recorded."),
         QT_TR_NOOP("Not recorded")},
    });
};
static_assert(areInOrder(FreshnessText::rows, &FreshnessRow::reason, Freshness::Reason::notRecorded));

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
    const char *text = rowOf(FreshnessText::rows, reason).text;
    return *text == '\0' ? QString() : FreshnessText::tr(text);
}

QString freshnessBrief(Freshness::Reason reason)
{
    if (reason == Freshness::Reason::unsettled)
        return FreshnessText::tr("Unsettled", "its word");
    const char *text = rowOf(FreshnessText::rows, reason).brief;
    return *text == '\0' ? QString() : FreshnessText::tr(text);
}

QString lastSeenText(Freshness::Reason reason, const QString &when)
{
    return FreshnessText::tr("%1 Last seen: %2.", "a sentence, date and time")
        .arg(freshnessText(reason), when);
}

} // namespace codewheel
