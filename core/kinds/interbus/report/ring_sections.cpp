// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/report/ring_sections.h"

#include "catalog/hex_code.h"
#include "kinds/interbus/plan/process_addresses.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/ring/cycle_time.h"
#include "kinds/interbus/ring/id_code.h"
#include "report/report_words.h"
#include "report/texts.h"
#include "vocabulary/sentence.h"

#include <QLocale>

#include <algorithm>

namespace codewheel::report_sections {
namespace {

using Column = ReportTable::Column;

constexpr int idCodeDigits = 2;

QString addressOf(const std::optional<AddressRange> &range, AddressRules::Unit unit)
{
    if (!range)
        return {};
    const QString text = addressText(range->first, unit);
    return range->byHand ? sentence(ReportTexts::tr("%1 by hand", "address"), {text}) : text;
}

QString nameOf(const ReportedDevice &device, const RingDevice &its)
{
    const bool isUnnamed = device.description == nullptr && its.deviceKey.isEmpty();
    return isUnnamed ? nameOrTerminal(its, nullptr) : report_words::device(device);
}

QString words(const RingDevice &participant)
{
    return QStringLiteral("%1 / %2").arg(participant.inWords).arg(participant.outWords);
}

// Columns that only some projects need.
struct Wanted
{
    bool group = false;
    bool level = false;
};

Wanted columnsOf(std::span<const ProjectDevice> devices)
{
    return {std::ranges::any_of(devices, [](const ProjectDevice &each) { return !each.group.isEmpty(); }),
            std::ranges::any_of(
                devices, [](const ProjectDevice &each) { return ringDevice(each.participant).level > 0; })};
}

ReportTable emptyTable(const Wanted &wanted, AddressRules::Unit unit)
{
    const bool isWord = unit == AddressRules::Unit::word;
    ReportTable table;
    const auto add = [&](const QString &name, Column column) {
        table.header << name;
        table.columns.push_back(column);
    };
    add(ReportTexts::tr("No.", "device number"), Column::text);
    add(ReportTexts::tr("Station"), Column::text);
    if (wanted.group)
        add(ReportTexts::tr("Group"), Column::text);
    add(ReportTexts::tr("Device"), Column::text);
    add(ReportTexts::tr("ID code"), Column::code);
    add(ReportTexts::tr("Words IN / OUT"), Column::number);
    add(isWord ? ReportTexts::tr("IN from word") : ReportTexts::tr("IN from byte"), Column::number);
    add(isWord ? ReportTexts::tr("OUT from word") : ReportTexts::tr("OUT from byte"), Column::number);
    if (wanted.level)
        add(ReportTexts::tr("Level"), Column::number);
    return table;
}

QStringList cellsOf(const ReportedDevice &device, const DeviceAddresses &addresses, AddressRules::Unit unit,
                    const Wanted &wanted)
{
    const ProjectDevice &planned = *device.planned;
    const RingDevice its = ringDevice(planned.participant);
    QStringList cells{device.place().toString(), planned.station};
    if (wanted.group)
        cells << planned.group;
    cells << nameOf(device, its) << hexCode(its.idCode(), idCodeDigits) << words(its)
          << addressOf(addresses.in, unit) << addressOf(addresses.out, unit);
    if (wanted.level)
        cells << QString::number(its.level);
    return cells;
}

QString milliseconds(const RingLoad &load, MicrosecondsOnTheWire bit, CycleTimeForm form)
{
    constexpr double microsecondsPerMillisecond = 1000;
    const double time = cycleTime(load, bit, form).count() / microsecondsPerMillisecond;
    return sentence(ReportTexts::tr("about %1 ms"), {QLocale().toString(time, 'f', 3)});
}

// `devices` are all the devices of the ring.
ReportTable ringTable(const Project &project, BusId ring, const std::vector<ReportedDevice> &devices)
{
    const Wanted wanted = columnsOf(devicesOn(project, ring));
    const AddressRules::Unit unit = ringPlan(project, ring).addresses.unit;
    const std::vector<DeviceAddresses> addresses = processAddresses(project, ring);
    ReportTable table = emptyTable(wanted, unit);
    for (std::size_t i = 0; i < devices.size(); ++i)
        table.rows.push_back({cellsOf(devices[i], addresses[i], unit, wanted)});
    return table;
}

ReportSection cycleTimeSection(const Project &project, BusId ring)
{
    const RingLoad load = ringLoad(structureOf(project, ring), ringPlan(project, ring).cableKilometres);

    ReportTable table{{ReportTexts::tr("Transmission speed"), ReportTexts::tr("Formula of G3 masters"),
                       ReportTexts::tr("Formula of G4 masters")},
                      {Column::text, Column::number, Column::number},
                      {}};
    const auto add = [&](const QString &speed, MicrosecondsOnTheWire bit) {
        table.rows.push_back({{speed, milliseconds(load, bit, CycleTimeForm::g3),
                               milliseconds(load, bit, CycleTimeForm::g4)}});
    };
    add(ReportTexts::tr("500 kBd"), bitAt500kBd);
    add(ReportTexts::tr("2 MBd"), bitAt2MBd);
    const QString from =
        sentence(ReportTexts::tr("Bytes of process data: %1, remote bus devices: %2, km of cable: %3."),
                 {numberText(load.dataBytes), numberText(load.remoteBusDevices),
                  QLocale().toString(load.cableKilometres, 'f', 3)});
    const bool isOnly =
        std::ranges::count(project.buses, findBus(project, ring)->kind, &PlannedBus::kind) == 1;
    const QString heading =
        isOnly ? ReportTexts::tr("Approximate cycle time")
               : sentence(ReportTexts::tr("Approximate cycle time of %1"), {findBus(project, ring)->name});
    return {.heading = heading, .blocks = {std::move(table), from}};
}

} // namespace

const BusSections ofRings{ringTable, cycleTimeSection};

} // namespace codewheel::report_sections
