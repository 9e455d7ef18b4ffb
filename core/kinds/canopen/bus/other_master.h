// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"
#include "vocabulary/refusal.h"

#include <cstdint>

namespace codewheel {

// What was heard of somebody else who commands and asks nodes on the bus, such as a PLC.
class OtherMaster
{
public:
    enum class Sign : std::uint8_t { commands, sync, requests, guarding, configures, time, heartbeat };

    // A frame that is not ours; only what no encoder sends counts. Of other heartbeats, those of node 127
    // too, and of RPDOs nobody can tell by listening whether an encoder sends them: as they are delivered,
    // and as a TPDO that was given such an identifier. True: it is the first sign of this sort.
    bool take(const CanFrame &frame);
    bool isHeard() const { return m_signs != 0; }
    bool isHeard(Sign sign) const { return (m_signs >> static_cast<unsigned>(sign) & 1U) != 0; }

    // As an argument of messages and refusals, and what it says: "NMT, SYNC".
    RefusalArgument argument() const { return std::int64_t{m_signs}; }
    static QString textOf(const RefusalArgument &argument);

    friend bool operator==(const OtherMaster &, const OtherMaster &) = default;

private:
    unsigned m_signs = 0; // bit by bit
};

} // namespace codewheel
