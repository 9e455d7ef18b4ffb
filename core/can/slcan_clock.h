// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <optional>

namespace codewheel {

// When a frame was on the bus, on the clock of whoever receives it: from the stamp of the adapter, whose ms
// begin again after a minute. The shortest way from the adapter that was seen just now counts as
// none: the two clocks do not run at the same pace. A time is never before that of the frame before, nor too
// early by more than its way.
class SlcanClock
{
public:
    Instant timeOf(int stamp, Instant arrival);

private:
    struct Last
    {
        Instant stamp; // counted on over the minutes
        Instant arrival;
    };
    void note(Instant offset, Instant arrival);

    std::optional<Last> m_last;
    // Of our clock against the stamps, the smallest since then and the one before.
    Instant m_since{};
    Instant m_offset{};
    Instant m_offsetBefore{};
    Instant m_told{};
};

} // namespace codewheel
