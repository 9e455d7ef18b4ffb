// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <optional>

namespace codewheel {

// When a frame was on the bus, on the clock of whoever receives it: from the stamp of the adapter, whose ms
// begin again after a minute. The shortest way from the adapter that was seen counts as none.
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
    std::optional<Last> m_last;
    Instant m_offset{}; // of our clock against the stamps
};

} // namespace codewheel
