// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"

#include <string>
#include <string_view>

namespace codewheel {

// The line of a frame in a log, as candump -L writes it and other programs read it, with its end:
// "(1544106679.432583) can0 185#88130000". A frame without a time, or with one before 1970, gets 0, one
// without an interface can0.
std::string canLogLine(const CanFrame &frame);

} // namespace codewheel
