// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <algorithm>
#include <optional>

namespace codewheel {

// SYNC of another master, and how often it comes.
class SyncHeard
{
public:
    void take(Instant at)
    {
        constexpr Instant longestPeriod = std::chrono::minutes(1); // otherwise it has begun anew
        const Instant since = at - m_at.value_or(at);
        m_period = since <= longestPeriod ? since : Instant();
        m_at = at;
    }
    // It is not missing, as a heartbeat would be.
    bool goesOn(Instant now) const
    {
        constexpr int timesMissed = 3;
        constexpr Instant atLeast = std::chrono::seconds(1);
        return m_at && now - *m_at <= std::max(m_period * timesMissed, atLeast);
    }

    friend bool operator==(const SyncHeard &, const SyncHeard &) = default;

private:
    std::optional<Instant> m_at{};
    Instant m_period{}; // 0: not known
};

} // namespace codewheel
