// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/bus_sections.h"

#include "project/bus_kind.h"
#include "report/report_words.h"
#include "report/texts.h"

namespace codewheel::report_sections {
namespace {

ReportTable placeTable(const Project & /*project*/, BusId /*bus*/, const std::vector<ReportedDevice> &devices)
{
    using enum ReportTable::Column;
    ReportTable table{{ReportTexts::tr("Address"), ReportTexts::tr("Station"), ReportTexts::tr("Group"),
                       ReportTexts::tr("Device")},
                      {text, text, text, text},
                      {}};
    for (const ReportedDevice &device : devices)
        table.rows.push_back({{device.place().toString(), device.planned->station, device.planned->group,
                               report_words::device(device)}});
    return table;
}

constexpr BusSections ofPlaces{placeTable};

} // namespace

const BusSections &sectionsOf(const PlannedBus &bus)
{
    const BusKind *kind = busKind(bus.kind);
    const BusSections *own = kind != nullptr ? kind->reportSections() : nullptr;
    return own != nullptr ? *own : ofPlaces;
}

} // namespace codewheel::report_sections
