// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"

class QIODevice;

namespace codewheel {

// Writes the report as a PDF of A4 sheets to the open device, and tells how many; 0 where it could not be
// written. Needs fonts, and so a QGuiApplication; no screen.
int writeReportPdf(const Report &report, QIODevice &device);

// Whether there is a font to write with at all.
bool hasFontsForPdf();

} // namespace codewheel
