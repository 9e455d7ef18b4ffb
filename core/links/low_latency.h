// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "serial/byte_link.h"

namespace codewheel {

// Asks the driver of this open port for it (ASYNC_LOW_LATENCY).
LowLatency askForLowLatency(int port);

// The result of the two system calls, by their errno; 0: done.
LowLatency lowLatencyOf(int gettingError, int settingError);

} // namespace codewheel
