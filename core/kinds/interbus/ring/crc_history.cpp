// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/crc_history.h"

#include <algorithm>

namespace codewheel {

void CrcHistory::note(const MasterStatus &status, Instant now)
{
    moveOn(now / interval);
    for (const MasterStatus::Segment &segment : status.segments) {
        std::uint32_t &seen = m_seen[segment.segment];
        const std::uint32_t fresh = segment.crcErrors < seen ? segment.crcErrors : segment.crcErrors - seen;
        seen = segment.crcErrors;
        if (fresh == 0)
            continue;
        Segment &history = m_segments[segment.segment];
        history.counts.back() += fresh;
        history.last = now;
    }
}

void CrcHistory::clear()
{
    m_segments.clear();
    m_seen.clear();
}

CrcHistory::Segment CrcHistory::of(int segment) const
{
    const auto found = m_segments.find(segment);
    return found == m_segments.end() ? Segment() : found->second;
}

void CrcHistory::moveOn(std::int64_t toInterval)
{
    const auto steps = std::clamp<std::int64_t>(toInterval - m_interval, 0, intervals);
    m_interval = toInterval;
    for (auto &[number, segment] : m_segments) {
        std::shift_left(segment.counts.begin(), segment.counts.end(), steps);
        std::fill(segment.counts.end() - steps, segment.counts.end(), 0U);
    }
}

} // namespace codewheel
