// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "serial/byte_link.h"

namespace codewheel {

// Sets an open serial port to any number of baud, such as 14400, for which termios has no constant. Whether
// the port has it now.
bool setLineRate(int port, int baudRate);

// Asks its driver for it (ASYNC_LOW_LATENCY).
LowLatency askForLowLatency(int port);

// The result of the two system calls, by their errno; 0: done.
LowLatency lowLatencyOf(int gettingError, int settingError);

} // namespace codewheel
