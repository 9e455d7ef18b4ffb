// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/instant.h"

namespace codewheel {

// What happens to the bytes on a simulated serial line, in both directions. Counts are of 1000 bytes; what a
// byte suffers is drawn from a random number whose seed is known, so that a run can be repeated.
struct LineFaults
{
    int lost = 0;
    int corrupted = 0; // one bit of it is another
    int doubled = 0;
    int delayed = 0; // with all that follow it
    Instant delay{20'000};
    bool echo = false; // the adapter hears what it sends: half duplex

    friend bool operator==(const LineFaults &, const LineFaults &) = default;
};

} // namespace codewheel
