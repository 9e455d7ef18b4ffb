// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"
#include "can/can_log_fault.h"

namespace codewheel {

// The time of a line as it is written: what it counts from is not said by the line alone.
struct CanLogStamp
{
    enum class Kind : std::uint8_t {
        none,
        candump, // seconds
        date,    // since 1970
        asc,     // seconds, as the header says
    };

    Kind kind = Kind::none;
    Instant at{};
};

// What one line is. Without a frame and a fault there is nothing in it to be read.
struct CanLogLine
{
    std::optional<CanFrame> frame{}; // without its time
    std::optional<CanLogFault> fault{};
    CanLogStamp stamp{};

    static CanLogLine faulty(CanLogFault fault) { return {.fault = fault}; }
};

} // namespace codewheel
