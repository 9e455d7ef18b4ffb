// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/transfer_report.h"

#include "catalog/catalog.h"
#include "journal/eeprom_cost.h"
#include "transfer/transfer_words.h"
#include "vocabulary/shown_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

using Column = ReportTable::Column;

// The translation context of these texts.
struct TransferReport
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::TransferReport)
};

QString titleOf(const TransferAccount &account)
{
    switch (account.kind) {
    case TransferKind::write:
        return TransferReport::tr("Values written to encoders");
    case TransferKind::clone:
        return TransferReport::tr("Values of one encoder given to others");
    case TransferKind::restore:
        return TransferReport::tr("Earlier values restored");
    case TransferKind::replace:
        break;
    }
    return account.isDone() ? TransferReport::tr("Encoder replaced")
                            : TransferReport::tr("Replacement of an encoder, not completed");
}

QString timeText(const QDateTime &at)
{
    return QLocale().toString(at, QLocale::ShortFormat);
}

QString positionText(const std::optional<std::int64_t> &position)
{
    return position ? QLocale().toString(qlonglong{*position}) : TransferReport::tr("not known");
}

ReportFacts accountFacts(const EncoderAccount &account)
{
    ReportFacts facts{{TransferReport::tr("Device"), account.device},
                      {TransferReport::tr("Result"), transfer_words::outcome(account)}};
    if (account.notInForce)
        facts.push_back({forceLabel(*account.notInForce), noteText(*account.notInForce)});
    if (!account.isBegun)
        return facts;
    facts.push_back({TransferReport::tr("Begun"), timeText(account.begun)});
    facts.push_back({TransferReport::tr("Ended"), timeText(account.ended)});
    facts.push_back({TransferReport::tr("EEPROM writes"),
                     eepromWritesText(account.eepromWrites, account.eepromWritesPerhaps)});
    if (account.positionWanted) {
        facts.push_back({TransferReport::tr("Position to be set"), positionText(account.positionWanted)});
        facts.push_back(
            {TransferReport::tr("Setting the position"), transfer_words::becameOfPosition(account)});
    }
    facts.push_back({TransferReport::tr("Position before"), positionText(account.positionBefore)});
    facts.push_back({TransferReport::tr("Position after"), positionText(account.positionAfter)});
    facts.push_back({TransferReport::tr("State afterwards"), transfer_words::leftIn(account)});
    return facts;
}

ReportTable tableOf(const EncoderAccount &account, const Catalog &catalog)
{
    const DeviceDescription *device = catalog.find(account.deviceKey);
    ReportTable table{{TransferReport::tr("Parameter"), TransferReport::tr("Before"),
                       TransferReport::tr("Wanted"), TransferReport::tr("What became of it")},
                      {Column::text, Column::number, Column::number, Column::text},
                      {}};
    for (const AccountRow &row : account.rows)
        table.rows.push_back({{parameterName(device, row.wanted.parameter),
                               transfer_words::known(device, row.wanted.parameter, row.before),
                               transfer_words::value(device, row.wanted), transfer_words::became(row)},
                              !isThere(row.became)});
    for (const AccountCamRow &row : account.cams)
        table.rows.push_back(
            {{TransferReport::tr("Cam program %1").arg(row.program), {}, {}, transfer_words::became(row)},
             row.became == Became::notDone});
    return table;
}

QString headingOf(const EncoderAccount &account)
{
    const QString place = account.place.shown();
    return account.station.isEmpty() ? place : QStringLiteral("%1 %2").arg(place, account.station);
}

QString padded(const QString &text, qsizetype width, ReportTable::Column column)
{
    return column == ReportTable::Column::number ? text.rightJustified(width) : text.leftJustified(width);
}

QString textOf(ReportTable table)
{
    for (ReportTable::Row &row : table.rows)
        for (QString &cell : row.cells)
            cell = shownInLine(cell);
    std::vector<qsizetype> widths;
    for (const QString &name : table.header)
        widths.push_back(name.size());
    for (const ReportTable::Row &row : table.rows)
        for (std::size_t i = 0; i < widths.size(); ++i)
            widths[i] = std::max(widths[i], row.cells.at(static_cast<qsizetype>(i)).size());
    const auto line = [&](const QStringList &cells) {
        QString text;
        for (std::size_t i = 0; i < widths.size(); ++i)
            text += padded(cells.at(static_cast<qsizetype>(i)), widths[i], table.columns[i]) +
                    QStringLiteral("  ");
        while (text.endsWith(u' '))
            text.chop(1);
        return text + u'\n';
    };
    QString text = line(table.header);
    for (const ReportTable::Row &row : table.rows)
        text += line(row.cells);
    return text;
}

QString textOf(const ReportFacts &facts)
{
    qsizetype width = 0;
    for (const ReportFact &fact : facts)
        width = std::max(width, fact.name.size());
    QString text;
    for (const ReportFact &fact : facts)
        text += (fact.name + u':').leftJustified(width + 2) + shownInLine(fact.text) + u'\n';
    return text;
}

} // namespace

Report reportOf(const TransferAccount &account, const Catalog &catalog, const QString &version)
{
    Report report;
    report.language =
        QCoreApplication::translate("DeviceDescription", "en", "code of the language of these texts");
    report.title = titleOf(account);
    report.subject = account.source;
    report.origin = QStringLiteral("Codewheel %1, %2").arg(version, timeText(account.at));
    const auto done = std::ranges::count_if(account.encoders, &EncoderAccount::isDone);
    report.facts = {
        {TransferReport::tr("Date"), timeText(account.at)},
        {TransferReport::tr("Encoders"),
         TransferReport::tr("%1 of %2 have all of it").arg(done).arg(account.encoders.size())},
        {TransferReport::tr("Written"), QString::number(account.count(Became::written))},
        {TransferReport::tr("Already there"), QString::number(account.count(Became::alreadyThere))}};
    if (const int stored = account.count(Became::stored); stored > 0)
        report.facts.push_back({TransferReport::tr("Stored, in force before"), QString::number(stored)});
    report.facts.push_back({TransferReport::tr("EEPROM writes"),
                            eepromWritesText(account.eepromWrites(), account.eepromWritesPerhaps())});
    report.facts.push_back({TransferReport::tr("Software"), QStringLiteral("Codewheel %1").arg(version)});
    for (const EncoderAccount &encoder : account.encoders)
        report.sections.push_back(
            {.heading = headingOf(encoder), .blocks = {accountFacts(encoder), tableOf(encoder, catalog)}});
    return report;
}

QString reportAsText(const Report &report)
{
    QString text = report.title + u'\n' + QString(report.title.size(), u'=') + QStringLiteral("\n\n");
    if (!report.subject.isEmpty())
        text += shownInLine(report.subject) + QStringLiteral("\n\n");
    text += textOf(report.facts);
    for (const ReportSection &section : report.sections) {
        const QString heading = shownInLine(section.heading);
        text += u'\n' + heading + u'\n' + QString(heading.size(), u'-') + QStringLiteral("\n\n");
        for (const ReportBlock &block : section.blocks) {
            if (const auto *facts = std::get_if<ReportFacts>(&block))
                text += textOf(*facts) + u'\n';
            else if (const auto *table = std::get_if<ReportTable>(&block))
                text += textOf(*table);
        }
    }
    return text;
}

} // namespace codewheel
