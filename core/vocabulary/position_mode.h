// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"

namespace codewheel {

// Somebody says that the encoder is in position mode: none reports its mode.
inline void tellPositionMode(EncoderSession &encoder)
{
    constexpr std::int64_t startsUpAsK3 = 1; // read-out 9, FRABA manual 10.2
    encoder.tell(Parameter::startUpMode, startsUpAsK3);
}

} // namespace codewheel
