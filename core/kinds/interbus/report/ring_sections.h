// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"
#include "report/reported_device.h"

// What only the report of a ring has.
namespace codewheel::report_sections {

// Its devices with their addresses in the process image; `devices` are all the devices of the ring.
ReportTable ringTable(const Project &project, BusId ring, const std::vector<ReportedDevice> &devices);
// About how long a bus cycle takes, by both formulas.
ReportSection cycleTime(const Project &project, BusId ring);

} // namespace codewheel::report_sections
