// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"
#include "report/reported_device.h"

namespace codewheel::report_sections {

// How the report tells of a kind of bus.
struct BusSections
{
    ReportTable (*structure)(const Project &project, BusId bus, const std::vector<ReportedDevice> &devices);
    ReportSection (*more)(const Project &project, BusId bus) = nullptr; // null: nothing
};

// A kind of which it knows nothing else has a table of places.
BusSections sectionsOf(const PlannedBus &bus);

} // namespace codewheel::report_sections
