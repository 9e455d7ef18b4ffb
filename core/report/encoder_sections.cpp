// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/total_range.h"
#include "jobs/value_notes.h"
#include "report/cam_blocks.h"
#include "report/report_words.h"
#include "report/sections.h"
#include "report/texts.h"
#include "vocabulary/sentence.h"

namespace codewheel::report_sections {
namespace {

using Column = ReportTable::Column;

QString headingOf(const ReportedDevice &device)
{
    const QStringList parts{device.shownPlace, report_words::device(device), device.planned->station};
    return device.planned->station.isEmpty()
               ? sentence(ReportTexts::tr("%1: %2", "place, device"), parts)
               : sentence(ReportTexts::tr("%1: %2, %3", "place, device, station"), parts);
}

QString serialNumber(const ReportedDevice &device)
{
    QStringList parts;
    const StoredValue *known = device.known(Parameter::serialNumber);
    if (known != nullptr)
        parts << QStringLiteral("%1 (%2)").arg(report_words::serialNumber(known->value.toString()),
                                               device.evidence(Parameter::serialNumber));
    if (const QString &label = device.planned->label.serialNumber; !label.isEmpty())
        parts << sentence(
            ReportTexts::tr("%1 (from the label)"),
            {report_words::serialNumberOfLabel(label, known ? known->value.asNumber() : std::nullopt)});
    return parts.empty() ? report_words::unknown() : parts.join(QStringLiteral(", "));
}

QString labelText(const DeviceLabel &label)
{
    return sentence(ReportTexts::tr("%1 revolutions, %2 steps per revolution"),
                    {label.turns > 0 ? numberText(label.turns) : report_words::unknown(),
                     label.stepsPerTurn > 0 ? numberText(label.stepsPerTurn) : report_words::unknown()});
}

// Of what it has as wanted.
std::optional<ValueNote> notInForce(const ReportedDevice &device)
{
    const ParameterValues known = device.knownValues();
    ParameterValues there = device.planned->wanted;
    std::erase_if(there, [&](const ParameterValue &wanted) {
        return findValue(known, wanted.parameter) != wanted.value;
    });
    return scalingNote(*device.description, there, known);
}

ReportFacts factsOf(const ReportedDevice &device, const QDateTime &now)
{
    const ProjectDevice &planned = *device.planned;
    ReportFacts facts{{ReportTexts::tr("Serial number"), serialNumber(device)}};
    if (planned.label.turns > 0 || planned.label.stepsPerTurn > 0)
        facts.push_back({ReportTexts::tr("Label"), labelText(planned.label)});
    if (!planned.group.isEmpty())
        facts.push_back({ReportTexts::tr("Group"), planned.group});
    if (const auto range = totalRange(*device.description, device.knownValues()))
        facts.push_back({ReportTexts::tr("Total range"),
                         sentence(ReportTexts::tr("%1 positions"), {numberText(*range)})});
    facts.push_back(
        {ReportTexts::tr("Known values"),
         !device.isConnected ? ReportTexts::tr("as stored in the project; the encoder was not asked")
         : device.notLive
             ? sentence(ReportTexts::tr("of the connected encoder, not up to date. %1", "why, when"),
                        {report_words::lastSeen(*device.notLive, now)})
         : device.isSimulated ? ReportTexts::tr("of a simulated encoder")
                              : ReportTexts::tr("of the connected encoder")});
    if (const auto unscaled = notInForce(device))
        facts.push_back({forceLabel(*unscaled), noteText(*unscaled)});
    if (!planned.note.isEmpty())
        facts.push_back({ReportTexts::tr("Note"), planned.note});
    return facts;
}

QString remark(const std::optional<Value> &wanted, const StoredValue *known)
{
    if (!wanted)
        return {};
    if (!known)
        return ReportTexts::tr("not compared");
    return *wanted == known->value ? ReportTexts::tr("as wanted") : ReportTexts::tr("differs");
}

ReportTable::Row rowOf(const ReportedDevice &device, Parameter parameter, const QDateTime &now)
{
    const auto wanted = findValue(device.planned->wanted, parameter);
    const StoredValue *known = device.known(parameter);
    return {{parameterName(device.description, parameter),
             wanted ? report_words::value(device, parameter, *wanted) : QString(),
             known ? report_words::value(device, parameter, known->value) : report_words::unknown(),
             report_words::unit(device, parameter), device.evidence(parameter),
             known ? report_words::time(known->at, now) : QString(), remark(wanted, known)},
            wanted && known && *wanted != known->value};
}

void addParameters(ReportSection &section, const ReportedDevice &device, const QDateTime &now)
{
    const std::vector<Parameter> parameters = device.parameters();
    if (parameters.empty()) {
        section.blocks.emplace_back(ReportTexts::tr("It has no parameters: it only sends its position."));
        return;
    }
    ReportTable table{{ReportTexts::tr("Parameter"), ReportTexts::tr("Wanted"), ReportTexts::tr("Known"),
                       ReportTexts::tr("Unit"), ReportTexts::tr("Evidence"), ReportTexts::tr("Date, time"),
                       ReportTexts::tr("Remark")},
                      {Column::text, Column::number, Column::number, Column::text, Column::text, Column::text,
                       Column::text},
                      {}};
    for (const Parameter parameter : parameters)
        table.rows.push_back(rowOf(device, parameter, now));
    section.blocks.emplace_back(std::move(table));
}

ReportSection encoder(const ReportedDevice &device, const QDateTime &now)
{
    ReportSection section{ReportSection::Level::part, headingOf(device), {factsOf(device, now)}};
    addParameters(section, device, now);
    for (ReportBlock &block : camBlocks(device, now))
        section.blocks.push_back(std::move(block));
    return section;
}

} // namespace

std::vector<ReportSection> encoders(const ReportInput &input, const std::vector<ReportedDevice> &devices)
{
    std::vector<ReportSection> sections{
        {.heading = ReportTexts::tr("Encoders"),
         .blocks = {
             ReportTexts::tr("Known values are: read, from the encoder; confirmed, by the encoder in a "
                             "handshake, after which it went into operation with them; by hand, set by "
                             "somebody, and the encoder was not asked; unknown, nobody knows what the "
                             "encoder has.")}}};
    for (const ReportedDevice &device : devices)
        if (device.description)
            sections.push_back(encoder(device, input.now));
    if (sections.size() == 1)
        sections.front().blocks = {ReportTexts::tr("The project has no encoders.")};
    return sections;
}

} // namespace codewheel::report_sections
