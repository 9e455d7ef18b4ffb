// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <cstddef>
#include <optional>

namespace codewheel {

// What happens to the frames on a simulated CAN bus. Counts are per 1000 frames; what happens to a frame is
// drawn from a random generator with a known seed, so that a run can be repeated.
struct CanBusFaults
{
    int lost = 0;    // acknowledged, but reaches nobody
    int damaged = 0; // destroyed by an error frame, and sent again
    int doubled = 0; // its sender saw an error where the others saw none, and sends it again
    int late = 0;    // with all that its sender has after it
    Instant delay{100'000};
    std::optional<std::size_t> brokenAfter{}; // so many participants, in the order in which they were added

    friend bool operator==(const CanBusFaults &, const CanBusFaults &) = default;
};

} // namespace codewheel
