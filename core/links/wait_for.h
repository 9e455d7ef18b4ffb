// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/wake_flag.h"

#include <chrono>
#include <cstdint>

namespace codewheel {

enum class Waited : std::uint8_t {
    ready, // or hung up: the next read or write says
    woken, // the flag was raised; it is lowered now
    timeOut,
};

// For the descriptor (-1: none) to have one of these poll(2) events, for the flag, or for the time to be
// there. The flag comes first.
Waited waitFor(int descriptor, short events, WakeFlag &wake, std::chrono::steady_clock::time_point until);

} // namespace codewheel
