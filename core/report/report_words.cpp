// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report_words.h"

#include "catalog/value_text.h"
#include "report/texts.h"
#include "vocabulary/freshness_text.h"
#include "vocabulary/known_words.h"
#include "vocabulary/sentence.h"
#include "vocabulary/serial_number_text.h"

#include <QLocale>
#include <QTimeZone>

namespace codewheel::report_words {

QString time(const QDateTime &at, const QDateTime &now)
{
    const QLocale locale;
    QString dateFormat = locale.dateFormat(QLocale::ShortFormat);
    if (!dateFormat.contains(QStringLiteral("yyyy")))
        dateFormat.replace(QStringLiteral("yy"), QStringLiteral("yyyy"));
    const QDateTime there = at.toTimeZone(now.timeZone());
    return QStringLiteral("%1 %2").arg(locale.toString(there.date(), dateFormat),
                                       locale.toString(there.time(), QLocale::ShortFormat));
}

QString device(const ReportedDevice &device)
{
    const Participant &participant = device.planned->participant;
    const bool isNamed = device.description && device.description->key == participant.deviceKey;
    if (!participant.deviceKey.isEmpty() && !isNamed)
        return sentence(ReportTexts::tr("%1 (no description of it is known)"), {participant.deviceKey});
    return participantName(device.description);
}

QString value(const ReportedDevice &device, Parameter parameter, const Value &value)
{
    const ParameterDescription *described =
        device.description ? device.description->find(parameter) : nullptr;
    return described ? valueText(*described, value) : plainText(value);
}

QString unit(const ReportedDevice &device, Parameter parameter)
{
    const ParameterDescription *described =
        device.description ? device.description->find(parameter) : nullptr;
    return described ? unitText(described->unit) : QString();
}

QString serialNumber(const QString &decimal)
{
    bool isNumber = false;
    const qint64 number = decimal.toLongLong(&isNumber);
    return isNumber ? serialNumberText(number) : decimal;
}

QString serialNumberOfLabel(const QString &typed, std::optional<std::int64_t> read)
{
    bool isDecimal = false;
    bool isHex = false;
    const qint64 decimal = typed.toLongLong(&isDecimal);
    const qint64 hex = typed.toLongLong(&isHex, 16);
    if (isDecimal && read == decimal)
        return serialNumber(typed);
    return isHex && (!isDecimal || read == hex) ? serialNumber(QString::number(hex)) : typed;
}

QString unknown()
{
    return known_words::word(std::nullopt);
}

QString lastSeen(const NotLive &old, const QDateTime &now)
{
    return old.seen.isValid() ? lastSeenText(old.reason, time(old.seen, now)) : freshnessText(old.reason);
}

} // namespace codewheel::report_words
