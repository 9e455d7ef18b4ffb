// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

namespace codewheel::canopen {

// How a node is asked.
struct NodeTimes
{
    Instant timeOut = std::chrono::milliseconds(500);
    // Assumed: of storing, restoring and setting the position, and until a node is back after its reset.
    Instant longTimeOut = std::chrono::seconds(5);
    Instant startTimeOut = std::chrono::seconds(3);            // assumed: until a started node shows it
    Instant positionInterval = std::chrono::milliseconds(100); // where no PDO brings the position
    Instant pdoPatience = std::chrono::seconds(1);             // after the last PDO that brought one
    Instant bitsInterval = std::chrono::seconds(1);            // of alarms and warnings
    Instant silenceInterval = std::chrono::seconds(1);         // of a node that does not answer
    int silentAfter = 2; // reads in a row without an answer, each sent three times
};

} // namespace codewheel::canopen
