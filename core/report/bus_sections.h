// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"
#include "report/reported_device.h"

namespace codewheel::report_sections {

// How the report describes the buses of a kind (BusKind::reportSections()).
struct BusSections
{
    ReportTable (*structure)(const Project &project, BusId bus, const std::vector<ReportedDevice> &devices);
    ReportSection (*more)(const Project &project, BusId bus) = nullptr; // null: nothing
};

// Of a kind that has none: a table of the places.
const BusSections &sectionsOf(const PlannedBus &bus);

} // namespace codewheel::report_sections
