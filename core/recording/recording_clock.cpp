// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_clock.h"

#include <algorithm>

namespace codewheel {

namespace {

Instant aheadOf(const RecordedClock &clock)
{
    return clock.wall - clock.at;
}

} // namespace

bool ClockWatch::isAhead(const RecordedClock &clock, Instant ahead) const
{
    return aheadOf(clock) - ahead < least && ahead - aheadOf(clock) < least;
}

std::optional<RecordedClock> ClockWatch::news(const RecordedClock &clock)
{
    if (m_ahead && isAhead(clock, *m_ahead)) {
        m_doubtful.reset();
        return std::nullopt;
    }
    const bool isFirst = !m_ahead;
    if (!isFirst && !(m_doubtful && isAhead(clock, aheadOf(*m_doubtful)))) {
        m_doubtful = clock;
        return std::nullopt;
    }
    if (!isFirst && clock.at - m_doubtful->at < moment)
        return std::nullopt;
    const RecordedClock set = isFirst ? clock : *m_doubtful;
    m_ahead = aheadOf(set);
    m_doubtful.reset();
    return set;
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
