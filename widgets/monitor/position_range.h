// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"

namespace codewheel {

// First and last position an encoder can show.
struct PositionRange
{
    std::int64_t first = 0;
    std::int64_t last = 0;

    friend bool operator==(const PositionRange &, const PositionRange &) = default;
};

// From the known steps, revolutions and measuring range, and the coding, or from the measuring length of a
// rod; on a serial line from the measuring range, which is in steps there. Nothing if one of them is missing.
std::optional<PositionRange> positionRange(const EncoderSession &encoder);

} // namespace codewheel
