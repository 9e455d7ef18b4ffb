// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace codewheel {

// A point in time, as counted by whoever owns the clock. Time is always an argument here: nothing in core
// asks a clock.
using Instant = std::chrono::microseconds;

} // namespace codewheel
