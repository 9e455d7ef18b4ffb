// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/encoder_session.h"

namespace codewheel {

// The position that can be given to the encoder by a command that carries it: an encoder on a serial line
// takes 1 to its measuring range (ESC manual, GP), an LA-66 any of 24 bits (manual 3.4).
ParameterDescription positionToSet(const EncoderSession &encoder);

// What is sent to set it, and what that costs.
QString positionToSetText(const EncoderSession &encoder);

} // namespace codewheel
