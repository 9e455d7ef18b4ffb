// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/wizard_report.h"

#include "catalog/explain_word.h"
#include "encoder/hex.h"
#include "encoder/refusal_text.h"
#include "encoder/shown_text.h"
#include "widgets/job/known_text.h"
#include "widgets/job/step_text.h"
#include "widgets/models/device_traits.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

// The context of these texts.
struct WizardReport
{
    Q_DECLARE_TR_FUNCTIONS(WizardReport)
};

struct Table
{
    QString title;
    QStringList header;
    QList<QStringList> rows;
};

// The report before it is text or HTML: lines "name: what", then tables.
struct Report
{
    QString title;
    QList<QPair<QString, QString>> facts;
    QList<Table> tables;
};

std::optional<Known> knownIn(const std::vector<Known> &all, Parameter parameter)
{
    const auto found = std::ranges::find(all, parameter, &Known::parameter);
    return found == all.end() ? std::nullopt : std::optional(*found);
}

QString positionText(const std::optional<std::int64_t> &position)
{
    return position ? QLocale().toString(qlonglong{*position}) : WizardReport::tr("not known");
}

QString resultText(const HandshakeRecord &record)
{
    if (!record.outcome)
        return WizardReport::tr("not finished");
    return record.outcome->result ? WizardReport::tr("done") : refusalText(record.outcome->result.error());
}

EncoderState leftIn(const HandshakeRecord &record)
{
    if (record.recovery)
        return record.recovery->leftIn;
    return record.outcome ? record.outcome->leftIn : EncoderState::notSeen;
}

Table valueTable(const HandshakeRecord &record, const DeviceDescription &device)
{
    Table table{WizardReport::tr("Values"),
                {WizardReport::tr("Parameter"), WizardReport::tr("Before"), WizardReport::tr("Wanted"),
                 WizardReport::tr("After")},
                {}};
    for (const ParameterDescription &parameter : device.parameters) {
        if (!parameter.canBeWritten())
            continue;
        const auto wanted = valueOf(record.job.values, parameter.parameter);
        table.rows.append({parameterName(parameter.parameter),
                           knownText(device, knownIn(record.before, parameter.parameter)),
                           wanted ? valueWithUnit(device, {parameter.parameter, *wanted}) : QString(),
                           knownText(device, knownIn(record.after, parameter.parameter))});
    }
    return table;
}

QString meaningOf(const DeviceDescription &device, const Exchange &row, bool isOut)
{
    return explanationText(device, explainWord(device, isOut ? row.out : row.in,
                                               {.direction = isOut ? WordDirection::out : WordDirection::in,
                                                .dialect = device.dialect,
                                                .mode = row.mode,
                                                .coding = row.coding,
                                                .counterpart = isOut ? row.in : row.out}));
}

Table traceTable(const HandshakeRecord &record, const DeviceDescription &device)
{
    Table table{WizardReport::tr("Words"),
                {WizardReport::tr("Cycle"), WizardReport::tr("OUT"), WizardReport::tr("IN"),
                 WizardReport::tr("OUT means"), WizardReport::tr("IN means")},
                {}};
    for (const Exchange &row : record.rows)
        table.rows.append({QString::number(row.cycle), hexWord(row.out), hexWord(row.in),
                           meaningOf(device, row, true), meaningOf(device, row, false)});
    return table;
}

Table requestTable(const HandshakeRecord &record, const DeviceDescription &device)
{
    Table table{WizardReport::tr("Requests"), {WizardReport::tr("Request"), WizardReport::tr("Means")}, {}};
    for (const Step &step : record.progress.steps)
        table.rows.append({QString::fromLatin1(step.line), stepText(device, step)});
    return table;
}

Report reportOf(const HandshakeRecord &record, const DeviceDescription &device, const QString &version)
{
    const QLocale locale;
    Report report{WizardReport::tr("Parameterization of encoder %1").arg(record.place), {}, {}};
    auto fact = [&](const QString &name, const QString &what) { report.facts.append({name, what}); };
    fact(WizardReport::tr("Device"), QStringLiteral("%1 (%2)").arg(record.place, record.device));
    if (record.serialNumber)
        fact(WizardReport::tr("Serial number"), QString::number(*record.serialNumber));
    fact(WizardReport::tr("Begun"), locale.toString(record.begun, QLocale::LongFormat));
    fact(WizardReport::tr("Ended"), locale.toString(record.ended, QLocale::LongFormat));
    fact(WizardReport::tr("Result"), resultText(record));
    fact(WizardReport::tr("Verified"), verificationText(record, device));
    const std::optional<Outcome> &last = record.recovery ? record.recovery : record.outcome;
    if (last && last->restored)
        fact(WizardReport::tr("Restored"), restoredText(last->restored));
    if (record.recovery)
        fact(WizardReport::tr("Brought back"), record.recovery->result
                                                   ? WizardReport::tr("done")
                                                   : refusalText(record.recovery->result.error()));
    fact(WizardReport::tr("Left in"), leftInText(leftIn(record)));
    if (record.setPositionTo)
        fact(WizardReport::tr("Position set to"), positionText(record.setPositionTo));
    fact(WizardReport::tr("Position before"), positionText(record.positionBefore));
    fact(WizardReport::tr("Position after"), positionText(record.positionAfter));
    const int writes = (record.outcome ? record.outcome->eepromWrites : 0) +
                       (record.recovery ? record.recovery->eepromWrites : 0);
    fact(WizardReport::tr("EEPROM writes"),
         WizardReport::tr("%1 by this handshake, %2 by this program since it was connected")
             .arg(writes)
             .arg(record.eepromWritesInAll));
    fact(WizardReport::tr("Program"), QStringLiteral("Codewheel %1").arg(version));
    report.tables = {valueTable(record, device),
                     isOnLine(device) ? requestTable(record, device) : traceTable(record, device)};
    return report;
}

QString padded(const Table &table)
{
    QList<QStringList> all{table.header};
    all += table.rows;
    for (QStringList &row : all)
        std::ranges::transform(row, row.begin(), shownInLine);
    QList<qsizetype> widths(table.header.size(), 0);
    for (const QStringList &row : all)
        for (qsizetype i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], row[i].size());
    QString text;
    for (const QStringList &row : all) {
        QString line;
        for (qsizetype i = 0; i < row.size(); ++i)
            line += row[i].leftJustified(widths[i] + 2);
        text += line.trimmed() + QLatin1Char('\n');
    }
    return text;
}

QString htmlRow(const QStringList &cells, const QString &tag)
{
    QString row = QStringLiteral("<tr>");
    for (const QString &cell : cells)
        row += QStringLiteral("<%1>%2</%1>").arg(tag, cell.toHtmlEscaped());
    return row + QStringLiteral("</tr>\n");
}

} // namespace

QString verificationText(const HandshakeRecord &record, const DeviceDescription &device)
{
    if (!record.outcome || !record.outcome->result)
        return WizardReport::tr("no: the handshake did not end well");
    if (device.capabilities.reads)
        return WizardReport::tr("read back from the encoder, and equal");
    return WizardReport::tr(
        "confirmed in the handshake, and run was answered by operation; this encoder cannot be read");
}

QString reportAsText(const HandshakeRecord &record, const DeviceDescription &device, const QString &version)
{
    const Report report = reportOf(record, device, version);
    QString text = report.title + QLatin1Char('\n') + QString(report.title.size(), QLatin1Char('=')) +
                   QStringLiteral("\n\n");
    qsizetype width = 0;
    for (const auto &[name, what] : report.facts)
        width = std::max(width, name.size());
    for (const auto &[name, what] : report.facts)
        text += (name + QLatin1Char(':')).leftJustified(width + 3) + shownInLine(what) + QLatin1Char('\n');
    for (const Table &table : report.tables)
        text += QStringLiteral("\n%1\n%2\n%3")
                    .arg(table.title, QString(table.title.size(), QLatin1Char('-')), padded(table));
    return text;
}

QString reportAsHtml(const HandshakeRecord &record, const DeviceDescription &device, const QString &version)
{
    const Report report = reportOf(record, device, version);
    QString html = QStringLiteral("<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"><title>%1</title>\n"
                                  "<style>body { font-family: sans-serif } td, th { text-align: left; "
                                  "padding-right: 1.5em; vertical-align: top }</style></head>\n"
                                  "<body><h1>%1</h1>\n<table>\n")
                       .arg(report.title.toHtmlEscaped());
    for (const auto &[name, what] : report.facts)
        html += htmlRow({name, what}, QStringLiteral("td"));
    html += QStringLiteral("</table>\n");
    for (const Table &table : report.tables) {
        html += QStringLiteral("<h2>%1</h2>\n<table>\n").arg(table.title.toHtmlEscaped());
        html += htmlRow(table.header, QStringLiteral("th"));
        for (const QStringList &row : table.rows)
            html += htmlRow(row, QStringLiteral("td"));
        html += QStringLiteral("</table>\n");
    }
    return html + QStringLiteral("</body></html>\n");
}

} // namespace codewheel
