// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/instant.h"

#include <cstdint>
#include <deque>
#include <optional>

namespace codewheel {

// The speed of a shaft from the positions it passes, smoothed over half a second of the readings' own time. A
// jump over the end of the range is no speed.
class ShaftMotion
{
public:
    void reset() { m_samples.clear(); }
    // total: the number of positions; nothing where it is not known, then a wrap is seen as a jump.
    void observe(Instant at, std::int64_t position, std::optional<std::int64_t> total);
    // Steps a second; nothing before there are readings of a tenth of a second.
    std::optional<double> stepsPerSecond() const;

private:
    struct Sample
    {
        Instant at{};
        std::int64_t shown = 0;
        std::int64_t way = 0; // steps since the first sample, wraps undone
    };

    std::deque<Sample> m_samples;
};

} // namespace codewheel
