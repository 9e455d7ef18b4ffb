// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/master_status.h"
#include "vocabulary/instant.h"

#include <array>
#include <map>
#include <optional>

namespace codewheel {

// How the CRC errors of each segment were spread over the last minutes, as far as snapshots of the ring were
// taken. Kept by RingSession, shown by the master panel.
class CrcHistory
{
public:
    static constexpr std::size_t intervals = 30;
    static constexpr std::chrono::seconds interval{10};

    struct Segment
    {
        std::array<std::uint32_t, intervals> counts{}; // errors of each interval, the current one last
        std::optional<Instant> last;                   // when the last error was seen
    };

    // Errors are counted from the start of the ring, and may start from 0 again.
    void note(const MasterStatus &status, Instant now);
    void clear();
    // All 0 for a segment without errors.
    Segment of(int segment) const;

private:
    void moveOn(std::int64_t toInterval);

    std::int64_t m_interval = 0; // the current one, counted from Instant 0
    std::map<int, Segment> m_segments;
    std::map<int, std::uint32_t> m_seen;
};

} // namespace codewheel
