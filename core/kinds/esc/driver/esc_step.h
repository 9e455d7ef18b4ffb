// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_request.h"
#include "vocabulary/event.h"

#include <vector>

namespace codewheel {

// A step of a job as carried out by the driver of serial encoders. Step::line is its request.
struct EscStep : Step
{
    enum class Task : std::uint8_t {
        read,           // until two reads agree; the value is part of the outcome
        refresh,        // the same, but it only updates what is known, and may fail
        write,          // sent once
        readBack,       // what was written must be found
        positionBefore, // before the first write
        positionAfter,  // after the last
        search,         // for the encoder whose address or baud rate was changed
    };

    Task task = Task::read;
    esc::Request request{};
    std::int64_t value = 0; // write, readBack: of the parameter; positionAfter: the preset
};
using EscSteps = std::vector<EscStep>;

} // namespace codewheel
