// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/bus_sections.h"
#include "report/sections.h"
#include "report/texts.h"

#include <algorithm>

namespace codewheel::report_sections {
namespace {

std::vector<ReportedDevice> reportedOn(BusId bus, const std::vector<ReportedDevice> &devices)
{
    std::vector<ReportedDevice> own;
    std::ranges::copy_if(devices, std::back_inserter(own),
                         [bus](const ReportedDevice &device) { return device.place().bus == bus; });
    return own;
}

} // namespace

ReportSection structure(const ReportInput &input, const std::vector<ReportedDevice> &devices)
{
    ReportSection section{.heading = ReportTexts::tr("Bus structure"), .blocks = {}};
    const auto isPlanned = [&](const PlannedBus &bus) { return !devicesOn(input.project, bus.id).empty(); };
    const auto planned = std::ranges::count_if(input.project.buses, isPlanned);
    for (const PlannedBus &bus : input.project.buses) {
        if (!isPlanned(bus))
            continue;
        const std::vector<ReportedDevice> own = reportedOn(bus.id, devices);
        if (planned > 1)
            section.blocks.emplace_back(bus.name);
        section.blocks.emplace_back(sectionsOf(bus).structure(input.project, bus.id, own));
    }
    if (section.blocks.empty())
        section.blocks.emplace_back(ReportTexts::tr("The project has no devices."));
    return section;
}

} // namespace codewheel::report_sections
