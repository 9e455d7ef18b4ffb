// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "esc/esc_scaling.h"

namespace codewheel {

// Whether a device can be asked for these (some at least), or told these: parameters it has, values in range,
// each once. `fractionBits`: of its line, for a scaling factor. Used by the plans of the drivers.
Result<void> checkToRead(const DeviceDescription &device, const std::vector<Parameter> &parameters);
Result<void> checkToWrite(const DeviceDescription &device, const ParameterValues &values,
                          int fractionBits = esc::defaultFractionBits);
Result<void> checkValue(const DeviceDescription &device, const ParameterValue &value,
                        int fractionBits = esc::defaultFractionBits);
// Whether the value lies between the minimum and the maximum.
Result<void> checkRange(const ParameterDescription &parameter, std::int64_t value);

} // namespace codewheel
