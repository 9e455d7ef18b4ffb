// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

namespace codewheel {

// What happens to the bytes on a simulated serial line, in both directions. Counts are per 1000 bytes; what
// happens to a byte is drawn from a random generator with a known seed, so that a run can be repeated.
struct EscLineFaults
{
    int lost = 0;
    int corrupted = 0; // one of its bits is flipped
    int doubled = 0;
    int delayed = 0; // together with all that follow it
    Instant delay{20'000};
    bool echo = false; // the adapter hears what it sends: half duplex

    friend bool operator==(const EscLineFaults &, const EscLineFaults &) = default;
};

} // namespace codewheel
