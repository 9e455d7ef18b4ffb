// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/message_writer.h"

#include "journal/message_fields.h"
#include "journal/told_bus_names.h"
#include "vocabulary/csv_text.h"

#include <QCoreApplication>
#include <QIODevice>
#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

struct Export
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::MessageWriter)
};

// Ours are words. A file from elsewhere may have anything in their place.
QString codeCell(const StoredMessage &message)
{
    const QString code = codeOf(message);
    const bool isWord = std::ranges::all_of(code, [](QChar c) { return c.isLetterOrNumber(); });
    return isWord ? code : csvText(code);
}

QString csvLine(const StoredMessage &message)
{
    const auto local = QDateTime::fromMSecsSinceEpoch(message.at);
    const QStringList fields{local.toOffsetFromUtc(local.offsetFromUtc()).toString(Qt::ISODateWithMs),
                             severityKey(message.severity),
                             placeText(message.place),
                             codeCell(message),
                             csvText(messageText(message)),
                             message.place ? QString::number(message.place->bus.number) : QString()};
    return fields.join(u',') + QStringLiteral("\r\n");
}

QString cells(const char *tag, const QStringList &texts)
{
    QString row;
    for (const QString &text : texts)
        row += QStringLiteral("<%1>%2</%1>").arg(QLatin1String(tag), text.toHtmlEscaped());
    return row;
}

QString htmlBegin()
{
    const QString title = Export::tr("Messages of Codewheel");
    const QString made =
        Export::tr("Written on %1.")
            .arg(QLocale().toString(QDateTime::currentDateTime(), QLocale::ShortFormat).toHtmlEscaped());
    return QStringLiteral("<!DOCTYPE html>\n<html lang=\"%1\">\n<head>\n<meta charset=\"utf-8\">\n"
                          "<title>%2</title>\n<style>\n"
                          "body { font-family: sans-serif; margin: 1.5em }\n"
                          "table { border-collapse: collapse }\n"
                          "th, td { text-align: left; vertical-align: top; padding: 0.1em 0.8em 0.1em 0 }\n"
                          "td:first-child { white-space: nowrap; font-variant-numeric: tabular-nums }\n"
                          "tr.attention td:nth-child(2), tr.fault td:nth-child(2) { font-weight: bold }\n"
                          "tr.attention { background: #fdf1d8 }\ntr.fault { background: #f9ded2 }\n"
                          "thead { border-bottom: 1px solid }\n"
                          "</style>\n</head>\n<body>\n<h1>%2</h1>\n<p>%3</p>\n<table>\n<thead><tr>%4</tr>"
                          "</thead>\n<tbody>\n")
        .arg(QLocale().bcp47Name(), title.toHtmlEscaped(), made,
             cells("th", {Export::tr("Date and time"), Export::tr("Severity"), Export::tr("Place"),
                          Export::tr("Message")}));
}

QString htmlRow(const StoredMessage &message, const ToldBusNames *names)
{
    const QString place =
        names != nullptr ? names->placeName(message.place, message.at) : placeName(message.place);
    return QStringLiteral("<tr class=\"%1\">%2</tr>\n")
        .arg(severityKey(message.severity),
             cells("td",
                   {messageTime(message.at), severityName(message.severity), place, messageText(message)}));
}

} // namespace

std::optional<MessageWriter::Format> MessageWriter::formatOf(const QString &fileName)
{
    if (fileName.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive))
        return Format::csv;
    if (fileName.endsWith(QStringLiteral(".html"), Qt::CaseInsensitive) ||
        fileName.endsWith(QStringLiteral(".htm"), Qt::CaseInsensitive))
        return Format::html;
    return std::nullopt;
}

bool MessageWriter::begin()
{
    return put(m_format == Format::html ? htmlBegin()
                                        : QStringLiteral("time,severity,place,code,text,bus\r\n"));
}

bool MessageWriter::write(const std::vector<StoredMessage> &messages)
{
    QString text;
    for (const StoredMessage &message : messages)
        text += m_format == Format::html ? htmlRow(message, m_names) : csvLine(message);
    return put(text);
}

bool MessageWriter::end()
{
    return m_format == Format::csv || put(QStringLiteral("</tbody>\n</table>\n</body>\n</html>\n"));
}

bool MessageWriter::put(const QString &text)
{
    const QByteArray bytes = text.toUtf8();
    return m_device.write(bytes) == bytes.size();
}

} // namespace codewheel
