// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

#include <QJsonArray>

namespace codewheel {

// "= 8192", "= 21.5 °C". Steps and revolutions are their own units.
QString valueCell(const ParameterDescription &parameter, std::int64_t value);
// What an encoder has, a line for each value.
QString valueLines(const DeviceDescription &device, const ParameterValues &values);
QJsonArray valuesJson(const DeviceDescription &device, const ParameterValues &values);

} // namespace codewheel
