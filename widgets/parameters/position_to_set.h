// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/encoder_session.h"

namespace codewheel {

// The position that may be given to the encoder where the command that sets it brings the value along: an
// encoder on a serial line takes 1 to its measuring range (ESC manual, GP), an LA-66 any of 24 bit (manual
// 3.4).
ParameterDescription positionToSet(const EncoderSession &encoder);

// What is sent for it, and what it costs.
QString positionToSetText(const EncoderSession &encoder);

} // namespace codewheel
