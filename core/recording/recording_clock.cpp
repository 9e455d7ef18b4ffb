// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_clock.h"

#include <algorithm>

namespace codewheel {

bool ClockWatch::isNews(const RecordedClock &clock)
{
    const Instant ahead = clock.wall - clock.at;
    if (m_ahead && ahead - *m_ahead < least && *m_ahead - ahead < least)
        return false;
    m_ahead = ahead;
    return true;
}

WallClock::WallClock(std::vector<RecordedClock> clocks)
    : m_clocks(std::move(clocks))
{
    std::ranges::stable_sort(m_clocks, {}, &RecordedClock::at);
}

Instant WallClock::wall(Instant at) const
{
    if (m_clocks.empty())
        return at;
    const auto next = std::ranges::upper_bound(m_clocks, at, {}, &RecordedClock::at);
    const RecordedClock &clock = next == m_clocks.begin() ? *next : *std::prev(next);
    return clock.wall + (at - clock.at);
}

} // namespace codewheel
