// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/slcan_clock.h"

#include "can/slcan_codec.h"

#include <algorithm>
#include <utility>

namespace codewheel {

using namespace std::chrono_literals;

Instant SlcanClock::timeOf(int stamp, Instant arrival)
{
    constexpr Instant round = std::chrono::milliseconds(slcanStampRange);
    Instant counted = std::chrono::milliseconds(stamp);
    if (m_last) { // of all rounds, the one next to the time that has passed here
        const Instant expected = m_last->stamp + (arrival - m_last->arrival);
        const Instant behind = expected - counted + round / 2;
        counted += std::max(behind / round, std::int64_t{}) * round;
    }
    note(arrival - counted, arrival);
    m_last = {counted, arrival};
    // The stamp has no fractions of its ms.
    const Instant at = counted + std::min(m_offset, m_offsetBefore) + 1ms;
    m_told = std::max(m_told, std::min(at, arrival));
    return m_told;
}

void SlcanClock::note(Instant offset, Instant arrival)
{
    constexpr Instant longestWay = 250ms; // beyond it the two clocks have parted
    constexpr Instant compared = 250ms;   // at 300 ppm they part by less than 0.1 ms
    const bool isOld = !m_last || arrival - m_since >= 2 * compared;
    if (isOld || offset > std::min(m_offset, m_offsetBefore) + longestWay) {
        m_offset = m_offsetBefore = offset;
        m_since = arrival;
    } else if (arrival - m_since >= compared) {
        m_offsetBefore = std::exchange(m_offset, offset);
        m_since = arrival;
    }
    m_offset = std::min(m_offset, offset);
}

} // namespace codewheel
