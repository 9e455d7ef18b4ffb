// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"
#include "vocabulary/refusal.h"

namespace codewheel {

enum class ReportFormat : std::uint8_t { html, pdf };

// From the suffix, ".html" or ".pdf"; nothing for any other.
std::optional<ReportFormat> reportFormat(const QString &path);

// Saves the report, replacing any existing file once the new one is complete. Returns the number of sheets, 0
// for a web page. Refused: fileNotWritten.
Result<int> saveReport(const Report &report, const QString &path, ReportFormat format);

} // namespace codewheel
