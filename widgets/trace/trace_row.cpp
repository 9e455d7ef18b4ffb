// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trace/trace_row.h"

#include "catalog/explain_word.h"
#include "encoder/csv_text.h"
#include "encoder/hex.h"

#include <QCoreApplication>
#include <QLocale>

namespace codewheel {

namespace {

Explanation explained(const DeviceDescription &device, const TraceRow &row, WordDirection direction)
{
    const bool out = direction == WordDirection::out;
    const Exchange &exchange = row.exchange;
    k3::ExplainContext context;
    context.direction = direction;
    context.mode = exchange.mode;
    context.coding = exchange.coding;
    context.counterpart = out ? std::optional(exchange.in) : row.asked;
    return explainWord(device, out ? exchange.out : exchange.in, context);
}

bool isOnly(const Explanation &explanation, MeaningId id)
{
    return explanation.isUnique() && explanation.first().id == id;
}

double inMilliseconds(Instant duration)
{
    return std::chrono::duration<double, std::milli>(duration).count();
}

} // namespace

// As the manuals tell a handshake: what the master asks for, and how far the encoder is.
QString exchangeText(const DeviceDescription &device, const TraceRow &row)
{
    const Explanation out = explained(device, row, WordDirection::out);
    const Explanation in = explained(device, row, WordDirection::in);
    QString said = explanationText(device, in);
    if (isOnly(out, MeaningId::normalRunning))
        return said;
    const QString asked = explanationText(device, out);
    if (out.isUnique() && asksForParameter(out.first().id)) {
        if (isOnly(in, MeaningId::confirmed) && in.first().number == out.first().number)
            return QCoreApplication::translate("Trace", "%1: confirmed", "parameter = value").arg(asked);
        if (isOnly(in, MeaningId::oldConfirmation) || k3::isOperation(row.exchange.in))
            return QCoreApplication::translate("Trace", "%1: not taken yet", "parameter = value").arg(asked);
    }
    return QCoreApplication::translate("Trace", "%1 – %2", "meaning of OUT, meaning of IN").arg(asked, said);
}

QString clockText(const TraceRow &row)
{
    return row.at.time().toString(QStringLiteral("HH:mm:ss.zzz"));
}

QString traceTimeText(const TraceRow &row)
{
    return QLocale().toString(row.at.date(), QLocale::ShortFormat) + QLatin1Char(' ') + clockText(row);
}

QString sinceLastText(const TraceRow &row)
{
    return row.sinceLast ? QLocale().toString(inMilliseconds(*row.sinceLast), 'f', 1) : QString();
}

QByteArray traceCsv(Place place, const DeviceDescription &device, const std::vector<TraceRow> &rows)
{
    QString csv = QStringLiteral("time,since_last_ms,cycle,out,in,meaning,remark,bus,place\r\n");
    for (const TraceRow &row : rows)
        csv +=
            QStringList{row.at.toString(Qt::ISODateWithMs),
                        row.sinceLast ? QString::number(inMilliseconds(*row.sinceLast), 'f', 1) : QString(),
                        QString::number(row.exchange.cycle),
                        hexWord(row.exchange.out),
                        hexWord(row.exchange.in),
                        csvText(exchangeText(device, row)),
                        csvText(row.remark),
                        QString::number(place.bus.number),
                        place.toString()}
                .join(QLatin1Char(',')) +
            QLatin1String("\r\n");
    return csv.toUtf8();
}

QString traceText(const DeviceDescription &device, const std::vector<TraceRow> &rows)
{
    QString text;
    for (const TraceRow &row : rows)
        text += QStringList{traceTimeText(row),
                            sinceLastText(row),
                            QLocale().toString(static_cast<qulonglong>(row.exchange.cycle)),
                            hexWord(row.exchange.out),
                            hexWord(row.exchange.in),
                            exchangeText(device, row),
                            row.remark}
                    .join(QLatin1Char('\t')) +
                QLatin1Char('\n');
    return text;
}

} // namespace codewheel
