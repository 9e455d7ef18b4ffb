// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/known.h"
#include "encoder/reading.h"

namespace codewheel {

// "read", "echoed", "told", "unknown": how a value is known.
QString evidenceText(const std::optional<Known> &known);
QString evidenceExplanation(const std::optional<Known> &known);

// "8 192 steps", "3 (CW)"
QString valueWithUnit(const DeviceDescription &device, const ParameterValue &value);
// "8 192 steps (read)"; "unknown".
QString knownText(const DeviceDescription &device, const std::optional<Known> &known);

// The state an encoder was left in, as a sentence.
QString leftInText(EncoderState state);

} // namespace codewheel
