// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "report/report.h"
#include "report/report_input.h"

namespace codewheel {

// A project of two encoders and a bus terminal, as at the end of a day of commissioning, 1 March 2026, UTC: a
// FRABA K3 with a value that differs and one that is unknown, and a Baumer K3.
ReportInput exampleInput();
// The FRABA at 1.0, which tests change.
ProjectDevice &fraba(ReportInput &input);

const Catalog &catalog();

// The report in English and the C locale.
Report reportOf(const ReportInput &input);
const ReportSection &sectionOf(const Report &report, const char *heading);
// Cells of a row joined by " | ".
std::vector<std::string> rowsOf(const ReportSection &section);
// "name: text"
std::vector<std::string> factsOf(const std::vector<ReportBlock> &blocks);
std::vector<std::string> paragraphsOf(const ReportSection &section);

QString htmlOf(const ReportInput &input);

} // namespace codewheel
