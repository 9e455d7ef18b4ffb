// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel {

// Whether an adapter hands over bytes at once. Many collect them for up to 16 ms unless they are asked not
// to, which halves the rate of position requests.
enum class LowLatency : std::uint8_t {
    granted,
    refused,
    notApplicable, // no adapter: a pseudo terminal
};

// Asks the driver behind this open port for it (ASYNC_LOW_LATENCY).
LowLatency askForLowLatency(int port);

// What the two system calls make of it, by their errno; 0: done.
LowLatency lowLatencyOf(int gettingError, int settingError);

} // namespace codewheel
