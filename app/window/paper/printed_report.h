// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"

class QPrinter;

namespace codewheel {

// All sheets of a report, with their own margins.
void printReport(const Report &report, QPrinter &printer);

} // namespace codewheel
