// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

namespace codewheel {

// The deadlines of a paced thread: a grid from `start`, so that a late cycle does not shift the following
// ones.
class Pacer
{
public:
    using Time = std::chrono::steady_clock::time_point;

    Pacer(Time start, std::chrono::nanoseconds period)
        : m_deadline(start)
        , m_period(period)
    {}

    // When the next cycle begins.
    Time deadline() const { return m_deadline; }
    // A cycle ended at `now`. Deadlines missed meanwhile are not caught up; they count as late unless the
    // cycle had to wait for something else.
    void cycleEnded(Time now, bool counts = true)
    {
        m_deadline += m_period;
        if (now <= m_deadline)
            return;
        const auto missed = (now - m_deadline) / m_period + 1;
        if (counts)
            m_lateCycles += static_cast<std::uint64_t>(missed);
        m_deadline += missed * m_period;
    }
    std::uint64_t lateCycles() const { return m_lateCycles; }

private:
    Time m_deadline;
    std::chrono::nanoseconds m_period;
    std::uint64_t m_lateCycles = 0;
};

} // namespace codewheel
