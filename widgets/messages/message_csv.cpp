// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/message_csv.h"

#include "encoder/refusal_text.h"

namespace codewheel {
namespace {

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

// The code of what was refused says more than "refused".
QString codeOf(const Message &message)
{
    return message.refusal ? refusalKey(message.refusal->id) : messageKey(message.id);
}

QString quoted(QString field)
{
    field.replace(QLatin1Char('"'), QStringLiteral("\"\""));
    return QLatin1Char('"') + field + QLatin1Char('"');
}

} // namespace

QByteArray messagesAsCsv(const std::vector<MessageRow> &rows)
{
    QString csv = QStringLiteral("time,severity,place,code,text\r\n");
    for (const MessageRow &row : rows) {
        const QDateTime at = row.at.toOffsetFromUtc(row.at.offsetFromUtc());
        const QString place = row.message.place ? row.message.place->toString() : QString();
        csv += at.toString(Qt::ISODateWithMs) + QLatin1Char(',') + severityKey(row.message.severity) +
               QLatin1Char(',') + place + QLatin1Char(',') + codeOf(row.message) + QLatin1Char(',') +
               quoted(messageText(row.message)) + QStringLiteral("\r\n");
    }
    return csv.toUtf8();
}

} // namespace codewheel
