// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/position_scale.h"
#include "vocabulary/parameter.h"
#include "widgets/dial/rod_state.h"

#include <array>

namespace codewheel {

class EncoderSession;

// What has to be known of a linear encoder for its magnet to be drawn.
inline constexpr std::array rodValues{Parameter::direction, Parameter::measuringLength};

// Length, scale and direction, as far as they are known.
RodState knownOfRod(const EncoderSession &encoder);
// The same with these values.
RodState rodWith(const DeviceDescription &device, const ValueOf &valueOf);
// What the dial shows of the encoder now. `missing`: the names of the rodValues that are not known.
RodState rodReading(const EncoderSession &encoder, const RodState &known, const QString &missing);

} // namespace codewheel
