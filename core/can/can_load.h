// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"

#include <deque>

namespace codewheel {

// How full a bus is: the share of the bit times of the last second that its frames took, with their stuff
// bits and the bits between two frames. An error frame counts without what it destroyed, of which nobody
// tells how much it was.
class CanLoad
{
public:
    explicit CanLoad(int rate) // Bd
        : m_rate(rate)
    {}

    // A frame that was on the bus, received or sent, with its time; one after the other.
    void add(const CanFrame &frame);
    // From 0 to 1.
    double share(Instant now);

private:
    struct Taken
    {
        Instant at;
        int bits = 0;
    };

    void forget(Instant upTo);

    int m_rate;
    std::deque<Taken> m_taken;
    std::int64_t m_bits = 0; // their sum
};

} // namespace codewheel
