// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace codewheel {

// A point in time, as the owner of the clock counts it. Time is always an argument here: nobody in core asks
// a clock.
using Instant = std::chrono::microseconds;

} // namespace codewheel
