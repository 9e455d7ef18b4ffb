// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/exchange.h"

#include <QJsonArray>

#include <vector>

namespace codewheel {

// Rows of words as the manuals print them: cycle, OUT, IN, and what both mean.
QString traceText(const DeviceDescription &device, const std::vector<Exchange> &rows);
QJsonArray traceJson(const DeviceDescription &device, const std::vector<Exchange> &rows);

} // namespace codewheel
