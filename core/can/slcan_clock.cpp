// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/slcan_clock.h"

#include "can/slcan_codec.h"

namespace codewheel {

using namespace std::chrono_literals;

Instant SlcanClock::timeOf(int stamp, Instant arrival)
{
    constexpr Instant round = std::chrono::milliseconds(slcanStampRange);
    constexpr Instant longestWay = 250ms; // beyond it the two clocks have parted
    Instant counted = std::chrono::milliseconds(stamp);
    if (m_last) { // of all rounds, the one next to the time that has passed here
        const Instant expected = m_last->stamp + (arrival - m_last->arrival);
        const Instant behind = expected - counted + round / 2;
        counted += std::max(behind / round, std::int64_t{}) * round;
    }
    const Instant offset = arrival - counted;
    if (!m_last || offset < m_offset || offset > m_offset + longestWay)
        m_offset = offset;
    m_last = {counted, arrival};
    return counted + m_offset;
}

} // namespace codewheel
