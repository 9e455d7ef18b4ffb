// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "cli/call/text_table.h"
#include "vocabulary/exchange.h"
#include "vocabulary/rod_scale.h"

#include <QJsonArray>
#include <QJsonObject>

#include <vector>

namespace codewheel {

// Rows of words as the manuals print them: cycle, OUT, IN, and what both mean. Positions of a rod are also
// given in millimetres if its scale is known.
QString traceText(const DeviceDescription &device, const std::vector<Exchange> &rows,
                  const std::optional<RodScale> &scale = {});
QJsonArray traceJson(const DeviceDescription &device, const std::vector<Exchange> &rows,
                     const std::optional<RodScale> &scale = {});

// The same row by row, as it comes. `before`: the row before it, null for the first.
TextTable traceTable();
QStringList traceHead(const DeviceDescription &device);
QStringList traceCells(const DeviceDescription &device, const Exchange &row, const Exchange *before,
                       const std::optional<RodScale> &scale);
QJsonObject traceRowJson(const DeviceDescription &device, const Exchange &row, const Exchange *before,
                         const std::optional<RodScale> &scale);

} // namespace codewheel
