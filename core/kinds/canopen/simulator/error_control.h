// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/nmt.h"
#include "kinds/canopen/simulator/object_dictionary.h"
#include "vocabulary/instant.h"

namespace codewheel::canopen {

// How a simulated node shows that it is there: by heartbeat (1017h), or by answers to guarding, whose end it
// notices (100Ch, 100Dh).
class ErrorControl
{
public:
    void begin(Instant now);

    // The answer to guarding; empty: there is none, since there is a heartbeat.
    std::optional<std::uint8_t> guarded(NmtState state, const ObjectDictionary &objects, Instant now);
    // Each is told once.
    bool isHeartbeatDue(const ObjectDictionary &objects, Instant now);
    bool isGuardingLost(Instant now);

    std::optional<Instant> wakesAt(const ObjectDictionary &objects) const;

private:
    Instant m_beatAt{}; // the last one, or the beginning
    bool m_toggle = false;
    std::optional<Instant> m_lostAt{}; // unless it is guarded before
};

} // namespace codewheel::canopen
