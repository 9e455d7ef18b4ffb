// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

// Sets an open serial port to any number of baud, such as 14400, for which termios has no constant. Whether
// the port has it now.
bool setLineRate(int port, int baudRate);

} // namespace codewheel
