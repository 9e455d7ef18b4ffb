// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/encoder_session.h"
#include "encoder/event.h"

namespace codewheel {

// "read", "echoed", "told", "unknown": how a value is known.
QString evidenceText(const std::optional<Known> &known);
// In a sentence, with what would make it surer. reads: the encoder can be read.
QString evidenceExplanation(const std::optional<Known> &known, bool reads);

// "8 192 steps", "3 (CW)". options: valueText().
QString valueWithUnit(const DeviceDescription &device, const ParameterValue &value,
                      const std::optional<ValueOptions> &options = {});
// "Steps = 255, Direction = 3 (CW)"
QString valueList(const DeviceDescription &device, const ParameterValues &values);
// "8 192 steps (read)"; "unknown".
QString knownText(const DeviceDescription &device, const std::optional<Known> &known);

// That the values from before are in the encoder again, and how that is known; empty where they are not.
QString restoredText(const std::optional<Evidence> &restored);

// "position", "velocity", "cam", "not known".
QString modeName(std::optional<Mode> mode);

// The state an encoder was left in, as a sentence.
QString leftInText(EncoderState state);
// Both: what the encoder has again, and where it was left.
QString endText(const Outcome &outcome);

} // namespace codewheel
