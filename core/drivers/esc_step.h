// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/event.h"
#include "esc/esc_request.h"

#include <vector>

namespace codewheel {

// A step of a job as the driver of serial encoders carries it out. Step::line is the request it is about.
struct EscStep : Step
{
    enum class Task : std::uint8_t {
        read,           // until two reads agree; the value is told by the outcome
        refresh,        // the same; only what is known is brought up to date, and a failure is none
        write,          // sent once
        readBack,       // what was written must be there
        positionBefore, // before the first write
        positionAfter,  // after the last
        search,         // of the encoder whose address or baud rate was changed
    };

    Task task = Task::read;
    esc::Request request{};
    std::int64_t value = 0; // write, readBack: of the parameter; positionAfter: the preset
};
using EscSteps = std::vector<EscStep>;

} // namespace codewheel
