// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/answer_times.h"

#include <algorithm>

namespace codewheel {

AnswerTime AnswerTimes::note(Instant time)
{
    if (m_times.size() < samples) {
        m_times.push_back(time);
    } else {
        m_sorted.erase(std::ranges::lower_bound(m_sorted, m_times[m_oldest]));
        m_times[m_oldest] = time;
        m_oldest = (m_oldest + 1) % samples;
    }
    m_sorted.insert(std::ranges::upper_bound(m_sorted, time), time);

    if (!m_told)
        m_told = {.shortest = time, .median = time, .longest = time};
    m_told->shortest = std::min(m_told->shortest, time);
    m_told->median = m_sorted[m_sorted.size() / 2];
    m_told->longest = std::max(m_told->longest, time);
    return *m_told;
}

} // namespace codewheel
