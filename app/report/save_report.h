// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/refusal.h"
#include "report/report.h"

namespace codewheel {

enum class ReportFormat : std::uint8_t { html, pdf };

// By the ending of the name, ".html" or ".pdf"; nothing for any other.
std::optional<ReportFormat> reportFormat(const QString &path);

// Saves the report in place of a file that may be there; what was there stays until the new one is whole. The
// number of sheets, 0 for a web page. Refused: fileNotWritten.
Result<int> saveReport(const Report &report, const QString &path, ReportFormat format);

} // namespace codewheel
