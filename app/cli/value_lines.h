// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

#include <QJsonArray>

namespace codewheel {

class EncoderSession;

// "= 8192", "= 21.5 °C". Steps and revolutions are their own units. fractionBits: valueText().
QString valueCell(const ParameterDescription &parameter, std::int64_t value,
                  std::optional<int> fractionBits = {});
// What an encoder has, a line for each value.
QString valueLines(const EncoderSession &encoder, const ParameterValues &values);
QJsonArray valuesJson(const DeviceDescription &device, const ParameterValues &values);

} // namespace codewheel
