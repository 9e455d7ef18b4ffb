// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/reading.h"

namespace codewheel {

// The error number of a magnet outside the measuring range: its bit of the error status (LA-66 manual 3.5).
inline constexpr unsigned magnetErrorNumber = 5;

// What IN of an LA-66 shows. With the error bit in normal mode the position is the last valid one, or is
// valid again but the error status has not been read.
Reading decodeLa66(Word in, Instant at) noexcept;

} // namespace codewheel
