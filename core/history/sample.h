// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <algorithm>
#include <cstdint>

namespace codewheel {

// A value, and when it stood on the bus.
struct Sample
{
    Instant at{};
    std::int64_t value = 0;

    friend bool operator==(const Sample &, const Sample &) = default;
};

// From `from` up to, but not including, `to`.
struct TimeSpan
{
    Instant from{};
    Instant to{};

    friend bool operator==(const TimeSpan &, const TimeSpan &) = default;
};

// The smallest and the largest of some values.
struct Extent
{
    std::int64_t least = 0;
    std::int64_t greatest = 0;

    void include(const Extent &other)
    {
        least = std::min(least, other.least);
        greatest = std::max(greatest, other.greatest);
    }
    friend bool operator==(const Extent &, const Extent &) = default;
};

// What some values have been, however many. Bits: of values that are 32-bit words.
struct Summary
{
    Extent extent;
    std::uint32_t always = 0; // 1 in all of them
    std::uint32_t ever = 0;   // 1 in any of them

    void include(const Summary &other)
    {
        extent.include(other.extent);
        always &= other.always;
        ever |= other.ever;
    }
    friend bool operator==(const Summary &, const Summary &) = default;
};

} // namespace codewheel
