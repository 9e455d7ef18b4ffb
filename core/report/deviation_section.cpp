// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/bus_kind.h"
#include "project/plan_rules.h"
#include "report/deviations.h"
#include "report/report_words.h"
#include "report/sections.h"
#include "report/texts.h"
#include "vocabulary/known_words.h"
#include "vocabulary/sentence.h"

#include <algorithm>

namespace codewheel::report_sections {
namespace {

using Column = ReportTable::Column;

QString camFieldName(unsigned program, CamField field)
{
    const QStringList numbers{QString::number(program), QString::number(field.cam)};
    switch (field.value) {
    case CamValue::start:
        return sentence(ReportTexts::tr("Cam program %1: start of cam %2"), numbers);
    case CamValue::stop:
        return sentence(ReportTexts::tr("Cam program %1: stop of cam %2"), numbers);
    case CamValue::activeCams:
        return sentence(ReportTexts::tr("Cam program %1: active cams 7 to 0"), numbers);
    case CamValue::hysteresis:
        return sentence(ReportTexts::tr("Cam program %1: hysteresis of cam %2"), numbers);
    case CamValue::invertedCams:
        return sentence(ReportTexts::tr("Cam program %1: inverted cams 7 to 0"), numbers);
    case CamValue::shift:
        break;
    }
    return sentence(ReportTexts::tr("Cam program %1: shift"), numbers);
}

QString camValue(CamField field, std::int64_t value)
{
    if (field.value == CamValue::activeCams || field.value == CamValue::invertedCams)
        return QString::number(value, 2).rightJustified(CamProgram::cams, u'0');
    return numberText(value);
}

QString withUnit(const ReportedDevice &device, Parameter parameter, const Value &value)
{
    return QStringLiteral("%1 %2")
        .arg(report_words::value(device, parameter, value), report_words::unit(device, parameter))
        .trimmed();
}

void addRows(ReportTable &table, const ReportedDevice &device, const Deviations &found)
{
    const QString &place = device.shownPlace;
    const QString &station = device.planned->station;
    for (const ValueDeviation &each : found.values)
        table.rows.push_back(
            {{place, station, parameterName(device.description, each.parameter),
              withUnit(device, each.parameter, each.wanted),
              withUnit(device, each.parameter, each.known.value), device.evidence(each.parameter)}});
    for (const CamDeviation &each : found.cams)
        table.rows.push_back(
            {{place, station, camFieldName(each.program, each.field), camValue(each.field, each.wanted),
              camValue(each.field, each.known), known_words::word(each.evidence)}});
}

void addValues(ReportSection &section, const std::vector<ReportedDevice> &devices)
{
    ReportTable table{
        {ReportTexts::tr("No.", "device number"), ReportTexts::tr("Station"), ReportTexts::tr("Value"),
         ReportTexts::tr("Wanted"), ReportTexts::tr("Known"), ReportTexts::tr("Evidence")},
        {Column::text, Column::text, Column::text, Column::number, Column::number, Column::text},
        {}};
    for (const ReportedDevice &device : devices)
        addRows(table, device, deviationsOf(device));
    if (!table.rows.empty())
        section.blocks.emplace_back(std::move(table));
    else
        section.blocks.emplace_back(
            ReportTexts::tr("No encoder is known to have anything other than what is wanted."));
    if (const int notKnown = countDeviations(devices).notKnown; notKnown > 0)
        section.blocks.emplace_back(
            ReportTexts::tr("%n wanted value(s) or cam program(s) could not be compared: what the encoders "
                            "have there is unknown.",
                            nullptr, notKnown));
}

// With the names of the buses if there are several.
ReportTable tableOf(const BusComparisons &compared)
{
    ReportTable table{{ReportTexts::tr("Configured and connected bus")}, {Column::text}, {}};
    const bool areSeveral = compared.lines.size() + static_cast<std::size_t>(compared.notCompared.size()) > 1;
    if (areSeveral) {
        table.header.prepend(ReportTexts::tr("Bus"));
        table.columns.push_back(Column::text);
    }
    for (const auto &[bus, lines] : compared.lines)
        for (const QString &line : lines)
            table.rows.push_back({areSeveral ? QStringList{bus, line} : QStringList{line}});
    return table;
}

QString asConfigured(const BusComparisons &compared)
{
    const bool areSeveral = compared.lines.size() > 1;
    if (!compared.old.isEmpty())
        return areSeveral ? ReportTexts::tr("The connected buses were as configured.")
                          : ReportTexts::tr("The connected bus was as configured.");
    return areSeveral ? ReportTexts::tr("The connected buses are as configured.")
                      : ReportTexts::tr("The connected bus is as configured.");
}

void addComparison(ReportSection &section, const ReportInput &input, const Catalog &catalog)
{
    const BusComparisons compared = busComparisons(input, catalog);
    if (compared.lines.empty()) {
        section.blocks.emplace_back(
            ReportTexts::tr("The configured bus was not compared with a connected one."));
        return;
    }
    if (compared.differences() == 0)
        section.blocks.emplace_back(asConfigured(compared));
    else
        section.blocks.emplace_back(tableOf(compared));
    for (const QString &old : compared.old)
        section.blocks.emplace_back(
            sentence(ReportTexts::tr("Compared as last seen, not up to date: %1"), {old}));
    if (!compared.notCompared.isEmpty())
        section.blocks.emplace_back(sentence(ReportTexts::tr("Not compared with connected ones: %1."),
                                             {compared.notCompared.join(QStringLiteral(", "))}));
}

// What breaks a rule of its bus.
void addFindings(ReportSection &section, const Project &project, const std::vector<ReportedDevice> &devices)
{
    ReportTable table{{ReportTexts::tr("No.", "device number"), ReportTexts::tr("Rules of the bus")},
                      {Column::text, Column::text},
                      {}};
    for (const PlannedBus &bus : project.buses) {
        const auto first =
            std::ranges::find(devices, bus.id, [](const auto &each) { return each.place().bus; });
        if (const BusKind *kind = busKind(bus.kind))
            for (const Finding &finding : kind->planRules().check(project, bus.id))
                table.rows.push_back(
                    {{(first + static_cast<std::ptrdiff_t>(finding.device))->shownPlace, finding.text}});
    }
    if (!table.rows.empty())
        section.blocks.emplace_back(std::move(table));
}

} // namespace

ReportSection deviations(const ReportInput &input, const Catalog &catalog,
                         const std::vector<ReportedDevice> &devices)
{
    ReportSection section{.heading = ReportTexts::tr("Deviations"), .blocks = {}};
    addValues(section, devices);
    addComparison(section, input, catalog);
    addFindings(section, input.project, devices);
    return section;
}

} // namespace codewheel::report_sections
