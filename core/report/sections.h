// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"
#include "report/reported_device.h"

// The sections of a commissioning report, one file each; put together by makeReport(). All take the devices
// from reportedDevices(input).
namespace codewheel::report_sections {

// What differs from what is wanted, how the connected bus differs from the configured one, and what breaks
// its rules.
ReportSection deviations(const ReportInput &input, const Catalog &catalog,
                         const std::vector<ReportedDevice> &devices);
// The bus, device by device, with addresses.
ReportSection structure(const ReportInput &input, const std::vector<ReportedDevice> &devices);
// A chapter, and a part for each encoder: its parameters and cams, wanted and known.
std::vector<ReportSection> encoders(const ReportInput &input, const std::vector<ReportedDevice> &devices);
ReportSection eepromWrites(const ReportInput &input, const std::vector<ReportedDevice> &devices);
// Of the project and of devices; those of encoders are with the encoders. No blocks: there are no notes.
ReportSection notes(const ReportInput &input, const std::vector<ReportedDevice> &devices);
ReportSection signatures();

} // namespace codewheel::report_sections
