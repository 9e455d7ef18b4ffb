// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"
#include "report/reported_device.h"

namespace codewheel::report_sections {

// How the report describes a kind of bus.
struct BusSections
{
    ReportTable (*structure)(const Project &project, BusId bus, const std::vector<ReportedDevice> &devices);
    ReportSection (*more)(const Project &project, BusId bus) = nullptr; // null: nothing
};

BusSections sectionsOf(const PlannedBus &bus);

// For a kind about which nothing else is known.
ReportTable placeTable(const Project &project, BusId bus, const std::vector<ReportedDevice> &devices);

} // namespace codewheel::report_sections
