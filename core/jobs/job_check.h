// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/encoder_session.h"

namespace codewheel {

// Whether a device can do the job by its capabilities, and whether the input makes sense: parameters it has
// (at least one), values in range, each once. `options`: of its line, for a scaling factor. What only its
// protocol refuses is checked by the plan of its driver, which calls this first.
Result<void> checkJob(const DeviceDescription &device, const Job &job, const KindData &options = {});

Result<void> checkValue(const DeviceDescription &device, const ParameterValue &value,
                        const KindData &options = {});
// Whether the value is a text that is short enough.
Result<void> checkText(const ParameterDescription &parameter, const Value &value);
// Whether the value is a number between the minimum and the maximum.
Result<void> checkRange(const ParameterDescription &parameter, const Value &value);

} // namespace codewheel
