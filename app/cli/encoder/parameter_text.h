// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/encoder_session.h"

namespace codewheel {

// A value with its name as typed, followed by the number: "cw (3)"; otherwise as valueText().
QString typedValue(const ParameterDescription &parameter, const Value &value, const KindData &options = {});
// The same for a device that may be unknown, or lack it: then a number.
QString typedValue(const DeviceDescription *device, const ParameterValue &value);
// "1..33554431", "cw (3), ccw (4)"; the same in every language
QString rangeText(const ParameterDescription &parameter);
} // namespace codewheel
