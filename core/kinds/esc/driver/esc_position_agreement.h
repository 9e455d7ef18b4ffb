// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/driver/esc_position_guard.h"

#include <cstdint>
#include <vector>

namespace codewheel {

// The reads of one position that goes into an account. The protocol has no checksum, and the shaft may turn
// between two reads; so a position is accepted when two reads in a row are equal, or when three in a row
// agree within what the shaft turned between them. A single corrupted digit is further off than that, unless
// the shaft could have turned to that position too. Used by the jobs of encoders on a serial line.
class EscPositionAgreement
{
public:
    enum class State : std::uint8_t { wantsMore, agreed, disagreed };

    struct Sample
    {
        std::int64_t position = 0; // steps
        Instant at{};

        friend bool operator==(const Sample &, const Sample &) = default;
    };

    explicit EscPositionAgreement(int mostReads = 6)
        : m_mostReads(mostReads)
    {}

    // `guard` knows how far the shaft can turn, and the end of the measuring range.
    State add(const Sample &sample, const EscPositionGuard &guard);

    // After add() said agreed.
    const Sample &last() const { return m_samples.back(); }
    double speed() const { return m_speed; } // steps per us, from the last two reads

private:
    bool isSteady(const EscPositionGuard &guard) const;

    int m_mostReads;
    std::vector<Sample> m_samples;
    double m_speed = 0;
};

} // namespace codewheel
