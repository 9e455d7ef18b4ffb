// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/wizard_report.h"

#include "catalog/device_description.h"
#include "catalog/explain_word.h"
#include "catalog/protocol_rules.h"
#include "jobs/job_report.h"
#include "jobs/step_text.h"
#include "jobs/value_notes.h"
#include "journal/eeprom_cost.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "widgets/job/known_text.h"

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

using Column = ReportTable::Column;

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

QString settingText(const HandshakeRecord &record)
{
    if (record.setsByPreset)
        return record.isPositionSet() ? WizardReport::tr("Position set by the preset")
                                      : WizardReport::tr("Preset to set the position by");
    return record.isPositionSet() ? WizardReport::tr("Position set to")
                                  : WizardReport::tr("Position to be set");
}

ReportSection valueSection(const HandshakeRecord &record, const DeviceDescription &device)
{
    ReportTable table{{WizardReport::tr("Parameter"), WizardReport::tr("Before"), WizardReport::tr("Wanted"),
                       WizardReport::tr("After")},
                      std::vector<Column>(4),
                      {}};
    for (const ParameterDescription &parameter : device.parameters) {
        if (!parameter.canBeWritten)
            continue;
        const auto wanted = findValue(record.job.values, parameter.parameter);
        table.rows.push_back(
            {{parameterName(parameter), knownText(device, knownIn(record.before, parameter.parameter)),
              wanted ? valueWithUnit(device, {parameter.parameter, *wanted}) : QString(),
              knownText(device, knownIn(record.after, parameter.parameter))}});
    }
    return {.heading = WizardReport::tr("Values"), .blocks = {table}};
}

QString meaningOf(const DeviceDescription &device, const Exchange &row, bool isOut)
{
    return explanationText(device, explainWord(device, isOut ? row.out : row.in,
                                               {.direction = isOut ? WordDirection::out : WordDirection::in,
                                                .mode = row.mode,
                                                .coding = row.coding,
                                                .counterpart = isOut ? row.in : row.out}));
}

ReportSection wordSection(const HandshakeRecord &record, const DeviceDescription &device)
{
    ReportTable table{{WizardReport::tr("Cycle"), WizardReport::tr("OUT"), WizardReport::tr("IN"),
                       WizardReport::tr("OUT means"), WizardReport::tr("IN means")},
                      {Column::number, Column::code, Column::code, Column::text, Column::text},
                      {}};
    for (const Exchange &row : record.rows)
        table.rows.push_back(
            {{QString::number(row.cycle), hexWord(row.out),
              row.isAnswered ? hexWord(row.in) : QString(QChar(0x2013)), meaningOf(device, row, true),
              row.isAnswered ? meaningOf(device, row, false) : WizardReport::tr("not answered")}});
    return {.heading = WizardReport::tr("Words"), .blocks = {table}};
}

ReportSection requestSection(const HandshakeRecord &record, const DeviceDescription &device)
{
    ReportTable table{
        {WizardReport::tr("Request"), WizardReport::tr("Means")}, {Column::code, Column::text}, {}};
    for (const Step &step : record.progress.steps)
        table.rows.push_back({{QString::fromLatin1(step.line), stepText(device, step)}});
    return {.heading = WizardReport::tr("Requests"), .blocks = {table}};
}

} // namespace

Report reportOf(const HandshakeRecord &record, const DeviceDescription &device, const QString &version)
{
    const QLocale locale;
    Report report;
    report.language =
        QCoreApplication::translate("DeviceDescription", "en", "code of the language of these texts");
    report.title = WizardReport::tr("Parameterization of encoder %1").arg(record.place);
    auto fact = [&](const QString &name, const QString &what) { report.facts.push_back({name, what}); };
    fact(WizardReport::tr("Device"), QStringLiteral("%1 (%2)").arg(record.place, record.device));
    if (record.serialNumber)
        fact(WizardReport::tr("Serial number"),
             valueWithUnit(device, {Parameter::serialNumber, *record.serialNumber}));
    fact(WizardReport::tr("Begun"), locale.toString(record.begun, QLocale::LongFormat));
    fact(WizardReport::tr("Ended"), locale.toString(record.ended, QLocale::LongFormat));
    fact(WizardReport::tr("Result"), resultText(record));
    fact(WizardReport::tr("Verified"), verificationText(record, device));
    if (const auto unscaled = unscaledNote(record, device))
        fact(forceLabel(*unscaled), noteText(*unscaled));
    const std::optional<Outcome> &last = record.last();
    if (last && last->restored)
        fact(WizardReport::tr("Restored"), restoredText(last->restored));
    if (record.recovery)
        fact(WizardReport::tr("Brought back"), record.recovery->result
                                                   ? WizardReport::tr("done")
                                                   : refusalText(record.recovery->result.error()));
    if (last)
        for (const QString &one : doubtSentences(last->inDoubt, device))
            fact(WizardReport::tr("Not known"), one);
    fact(WizardReport::tr("State at the end of the handshake"), leftInText(leftIn(record)));
    if (const auto left = last ? leftModeReport(*last) : std::nullopt)
        fact(WizardReport::tr("Mode afterwards"), messageText(*left));
    if (record.leftOut)
        fact(WizardReport::tr("Left out"), noteText(*record.leftOut));
    if (record.setsPosition)
        fact(settingText(record), positionText(record.setPositionTo));
    fact(WizardReport::tr("Position before"), positionText(record.positionBefore));
    fact(WizardReport::tr("Position after"), positionText(record.positionAfter));
    const int writes = (record.outcome ? record.outcome->eepromWrites : 0) +
                       (record.recovery ? record.recovery->eepromWrites : 0);
    const int perhaps = (record.outcome ? record.outcome->inDoubt.eepromWrites : 0) +
                        (record.recovery ? record.recovery->inDoubt.eepromWrites : 0);
    fact(WizardReport::tr("EEPROM writes"),
         WizardReport::tr("%1 by this handshake, %2 by this program since it was connected")
             .arg(eepromWritesText(writes, perhaps))
             .arg(record.eepromWritesInAll));
    fact(WizardReport::tr("Program"), QStringLiteral("Codewheel %1").arg(version));
    report.sections = {valueSection(record, device),
                       !device.hasWords() ? requestSection(record, device) : wordSection(record, device)};
    return report;
}

QString verificationText(const HandshakeRecord &record, const DeviceDescription &device)
{
    if (record.outcome && isCancelled(*record.outcome))
        return WizardReport::tr("no: the handshake was cancelled");
    if (!record.outcome || !record.outcome->result)
        return WizardReport::tr("no: the handshake did not end well");
    if (record.job.values.empty())
        return WizardReport::tr("the encoder shows the position that was set");
    if (device.capabilities.reads)
        return WizardReport::tr("read back from the encoder, and equal");
    if (!activatesByRun(device))
        return WizardReport::tr("confirmed by the encoder, which cannot be read");
    return WizardReport::tr(
        "confirmed in the handshake, and run was answered by operation; this encoder cannot be read");
}

std::optional<ValueNote> unscaledNote(const HandshakeRecord &record, const DeviceDescription &device)
{
    const bool isDone = record.outcome && record.outcome->result;
    return isDone ? scalingNote(device, record.job.values, valuesOf(record.after)) : std::nullopt;
}

} // namespace codewheel
