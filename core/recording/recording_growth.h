// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <cstdint>
#include <deque>
#include <optional>

namespace codewheel {

// How fast a recording grew lately.
class RecordingGrowth
{
public:
    static constexpr Instant lately = std::chrono::minutes(10);

    void add(Instant at, std::int64_t bytes);     // its size then
    std::optional<double> bytesPerSecond() const; // nothing: not known as yet
    // With that much left; at most `longest`. Nothing: not known, or it does not grow.
    std::optional<Instant> timeUntilFull(std::int64_t bytesLeft) const;

    static constexpr Instant longest = std::chrono::hours(24 * 365 * 100);

private:
    struct Size
    {
        Instant at;
        std::int64_t bytes;
    };
    std::deque<Size> m_sizes;
};

} // namespace codewheel
