// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

namespace codewheel {

// How an encoder on a serial line is asked. All of it can be set: the manual states only the shortest
// interval, the rest is assumed.
struct EscSettings
{
    // Manual, terminal assignment, note 1: not faster than every 10 ms.
    static constexpr Instant shortestInterval = std::chrono::milliseconds(10);

    Instant positionInterval = shortestInterval;      // from request to request; never below the shortest
    Instant statusInterval = std::chrono::seconds(1); // warnings and alarms
    int silentAfter = 3;                              // requests in a row without an answer
    Instant silentInterval = std::chrono::seconds(1); // between position requests once silent
    std::chrono::seconds jobPatience{2}; // without an answer; then what was confirmed is no longer sent
    double topSpeed = 6000;              // revolutions per minute
    Instant suspectMessages = std::chrono::seconds(10); // at most one message in this time
    int readTries = 3;                                  // of two reads each, per value
    int searchRounds = 2;                               // through all places, after the address has changed
    int fractionBits = 29;                              // of the scaling factor
    bool swapWarningBytes =
        false; // the example of E reads 0098 as 9800h; the tables put the high digit first

    friend bool operator==(const EscSettings &, const EscSettings &) = default;
};

} // namespace codewheel
