// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"
#include "report/report_input.h"

namespace codewheel {

class Catalog;

// The commissioning report of a project, in the current language and number format. The same input gives the
// same report; what is not known is reported as unknown.
Report makeReport(const ReportInput &input, const Catalog &catalog);

} // namespace codewheel
