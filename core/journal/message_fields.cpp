// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/message_fields.h"

#include "vocabulary/local_time.h"

#include <QCoreApplication>
#include <QLocale>

namespace codewheel {
namespace {

struct Fields
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::MessageModel)
};

constexpr Severity severities[] = {Severity::information, Severity::attention, Severity::fault};

} // namespace

QString severityName(Severity severity)
{
    switch (severity) {
    case Severity::fault:
        return Fields::tr("Fault");
    case Severity::attention:
        return Fields::tr("Attention");
    case Severity::information:
        break;
    }
    return Fields::tr("Information");
}

QString placeName(const std::optional<Place> &place)
{
    if (!place)
        return {};
    const QString shown = place->shown();
    return shown.isEmpty() ? nameOfNamelessBus() : shown;
}

QString nameOfNamelessBus()
{
    return Fields::tr("Bus");
}

QString placeText(const std::optional<Place> &place)
{
    return place ? place->toString() : QString();
}

QString messageTime(const QDateTime &at)
{
    const QLocale locale;
    return QStringLiteral("%1 %2%3").arg(locale.toString(at.date(), QLocale::ShortFormat),
                                         at.time().toString(QStringLiteral("HH:mm:ss.zzz")),
                                         offsetIfTwice(at));
}

QString messageTime(qint64 at)
{
    return messageTime(QDateTime::fromMSecsSinceEpoch(at));
}

QString severityKey(Severity severity)
{
    switch (severity) {
    case Severity::fault:
        return QStringLiteral("fault");
    case Severity::attention:
        return QStringLiteral("attention");
    case Severity::information:
        break;
    }
    return QStringLiteral("information");
}

std::optional<Severity> severityFromKey(QStringView key)
{
    for (const Severity severity : severities)
        if (key == severityKey(severity))
            return severity;
    return std::nullopt;
}

} // namespace codewheel
