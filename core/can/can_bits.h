// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"

namespace codewheel {

// Bits between two frames.
inline constexpr int canIntermission = 3;

// A data or remote frame on the wire, from its start of frame to its end of frame (ISO 11898-1, 10.4), with
// the stuff bits that its data and CRC make.
int canBits(const CanFrame &frame);
// The CRC sequence of 15 bits.
std::uint16_t canCrc(const CanFrame &frame);

// The order of arbitration: of frames that begin at the same time, that with the smallest one goes on.
std::uint32_t canPrecedence(const CanFrame &frame);

} // namespace codewheel
