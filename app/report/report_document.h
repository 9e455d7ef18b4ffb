// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"

#include <QTextDocument>

#include <memory>

namespace codewheel {

// The report's web page as one long sheet, as wide as the body of a sheet, in dots of the device.
std::unique_ptr<QTextDocument> reportDocument(const Report &report, QPaintDevice &device);

} // namespace codewheel
