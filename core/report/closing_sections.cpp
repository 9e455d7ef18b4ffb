// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/eeprom_cost.h"
#include "report/report_words.h"
#include "report/sections.h"
#include "report/texts.h"
#include "vocabulary/sentence.h"

namespace codewheel::report_sections {
namespace {

using Column = ReportTable::Column;

QString toldBy(const EepromCount &count)
{
    switch (count.by) {
    case CountedBy::serialNumber:
        return sentence(ReportTexts::tr("serial number %1, read from it"),
                        {report_words::serialNumber(count.serialNumber)});
    case CountedBy::labelSerialNumber:
        return sentence(ReportTexts::tr("serial number %1, from its label"),
                        {report_words::serialNumberOfLabel(count.serialNumber, {})});
    case CountedBy::place:
        return ReportTexts::tr("project and place; another encoder at this place counts on");
    case CountedBy::session:
        break;
    }
    return ReportTexts::tr("this connection only; nothing is kept of others");
}

QString budget(const Capabilities &can)
{
    if (!can.eepromBudget)
        return ReportTexts::tr("not stated");
    const QStringList numbers{numberText(*can.eepromBudget), numberText(can.eepromLimit.value_or(0))};
    return can.eepromLimit ? sentence(ReportTexts::tr("about %1; nothing is guaranteed beyond %2"), numbers)
                           : sentence(ReportTexts::tr("about %1"), numbers);
}

QStringList writesRow(const ReportedDevice &device, const ReportInput &input)
{
    QStringList cells{device.shownPlace, device.planned->station};
    if (const auto found = input.writes.find(device.place()); found != input.writes.end()) {
        const EepromCount &count = found->second;
        cells << eepromWritesText(count.writes, count.atMost() - count.writes)
              << (count.since.isValid() ? report_words::time(count.since, input.now) : QString())
              << toldBy(count);
    } else {
        cells << report_words::unknown() << QString() << QString();
    }
    return cells << budget(device.description->capabilities);
}

bool storesParameters(const ReportedDevice &device)
{
    return device.description && device.description->capabilities.writes;
}

} // namespace

ReportSection eepromWrites(const ReportInput &input, const std::vector<ReportedDevice> &devices)
{
    ReportSection section{.heading = ReportTexts::tr("EEPROM writes by this program"), .blocks = {}};
    ReportTable table{{ReportTexts::tr("No.", "device number"), ReportTexts::tr("Station"),
                       ReportTexts::tr("Writes"), ReportTexts::tr("Since"),
                       ReportTexts::tr("Encoder identified by"), ReportTexts::tr("Writes the manual states")},
                      {Column::text, Column::text, Column::number, Column::text, Column::text, Column::text},
                      {}};
    for (const ReportedDevice &device : devices)
        if (storesParameters(device))
            table.rows.push_back({writesRow(device, input)});
    if (table.rows.empty()) {
        section.blocks.emplace_back(ReportTexts::tr("The project has no encoder that can be written."));
        return section;
    }
    section.blocks.emplace_back(std::move(table));
    section.blocks.emplace_back(
        ReportTexts::tr("What other programs and controllers wrote is not known and not counted."));
    return section;
}

ReportSection notes(const ReportInput &input, const std::vector<ReportedDevice> &devices)
{
    ReportSection section{.heading = ReportTexts::tr("Notes"), .blocks = {}};
    if (!input.project.note.isEmpty())
        section.blocks.emplace_back(input.project.note);
    ReportFacts ofDevices;
    for (const ReportedDevice &device : devices)
        if (!device.description && !device.planned->note.isEmpty())
            ofDevices.push_back({device.shownPlace, device.planned->note});
    if (!ofDevices.empty())
        section.blocks.emplace_back(std::move(ofDevices));
    return section;
}

ReportSection signatures()
{
    return {.heading = ReportTexts::tr("Signatures"),
            .blocks = {SignaturePlaces{{ReportTexts::tr("Commissioned by"), ReportTexts::tr("Accepted by")},
                                       ReportTexts::tr("Name"),
                                       ReportTexts::tr("Date"),
                                       ReportTexts::tr("Signature")}}};
}

} // namespace codewheel::report_sections
