// SPDX-License-Identifier: GPL-3.0-or-later
#include "esc_line/line_figures.h"

#include <algorithm>

namespace codewheel {

void LineCounter::note(const esc::ExchangeResult &result)
{
    m_figures.requests += static_cast<std::uint64_t>(result.sent);
    m_figures.retries += static_cast<std::uint64_t>(std::max(0, result.sent - 1));
    m_figures.timeOuts += static_cast<std::uint64_t>(result.timeOuts);
    m_figures.garbageBytes += static_cast<std::uint64_t>(result.garbageBytes);
    m_figures.lateBytes += static_cast<std::uint64_t>(result.lateBytes);
    if (!result.answer) {
        ++m_figures.unanswered;
        return;
    }
    ++m_figures.answers;
    noteTime(result.answerTime);
}

void LineCounter::noteTime(Instant time)
{
    if (m_times.size() < samples) {
        m_times.push_back(time);
    } else {
        m_sorted.erase(std::ranges::lower_bound(m_sorted, m_times[m_oldest]));
        m_times[m_oldest] = time;
        m_oldest = (m_oldest + 1) % samples;
    }
    m_sorted.insert(std::ranges::upper_bound(m_sorted, time), time);

    auto &told = m_figures.answerTime;
    if (!told)
        told = {.shortest = time, .median = time, .longest = time};
    told->shortest = std::min(told->shortest, time);
    told->median = m_sorted[m_sorted.size() / 2];
    told->longest = std::max(told->longest, time);
}

Instant LineCounter::longestAnswer() const
{
    return m_figures.answerTime ? m_figures.answerTime->longest : Instant{};
}

} // namespace codewheel
