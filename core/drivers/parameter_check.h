// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

namespace codewheel {

// Whether a device can be asked for these (some at least), or told these: parameters it has, values in range,
// each once. Used by the plans of the drivers.
Result<void> checkToRead(const DeviceDescription &device, const std::vector<Parameter> &parameters);
Result<void> checkToWrite(const DeviceDescription &device, const ParameterValues &values);
Result<void> checkValue(const DeviceDescription &device, const ParameterValue &value);

} // namespace codewheel
