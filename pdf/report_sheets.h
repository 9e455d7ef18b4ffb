// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdf/sheet.h"
#include "report/report.h"

namespace codewheel {

// The report laid out on sheets of A4, each with a head and a foot that numbers it. Needs fonts, and so a
// QGuiApplication.
std::vector<Sheet> reportSheets(const Report &report);

} // namespace codewheel
