// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/message_fields.h"

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/local_time.h"

#include <QCoreApplication>
#include <QLocale>

#include <array>

namespace codewheel {
namespace {

struct Fields
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::MessageModel)
    using enum Severity;

public:
    static constexpr auto severities = std::to_array<KeyedText<Severity>>({
        {information, "information", QT_TR_NOOP("Information")},
        {attention, "attention", QT_TR_NOOP("Attention")},
        {fault, "fault", QT_TR_NOOP("Fault")},
    });
};
static_assert(areInOrder(Fields::severities, &KeyedText<Severity>::id, Severity::fault));

} // namespace

QString severityName(Severity severity)
{
    return Fields::tr(rowOf(Fields::severities, severity).text);
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
    return QLatin1String(rowOf(Fields::severities, severity).key);
}

std::optional<Severity> severityFromKey(QStringView key)
{
    const auto *row = rowByKey(Fields::severities, key);
    return row != nullptr ? std::optional(row->id) : std::nullopt;
}

} // namespace codewheel
