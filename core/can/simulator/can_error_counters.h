// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link.h"

#include <algorithm>

namespace codewheel {

// The error counters of one controller, and the state that follows from them (ISO 11898-1, 12.1.4).
class CanErrorCounters
{
public:
    // A frame that it sent was destroyed.
    void sendingFailed() { m_transmit += 8; }
    // Nobody has acknowledged it, which a passive sender does not count: alone on a bus, none goes bus off.
    void notAcknowledged() { m_transmit += isPassive() ? 0 : 8; }
    void sent() { m_transmit -= m_transmit > 0 ? 1 : 0; }
    // A frame of another was destroyed; `first`: by its own error frame, to which the others have answered.
    void receivingFailed(bool first) { m_receive = std::min(m_receive + (first ? 9 : 1), passiveFrom); }
    void received() { m_receive = m_receive >= passiveFrom ? afterPassive : std::max(m_receive - 1, 0); }
    void goBusOff() { m_transmit = busOffFrom; }

    int transmit() const { return m_transmit; }
    int receive() const { return m_receive; }
    bool isPassive() const { return std::max(m_transmit, m_receive) >= passiveFrom; }
    bool isBusOff() const { return m_transmit >= busOffFrom; }
    CanState state() const
    {
        if (isBusOff())
            return CanState::busOff;
        if (isPassive())
            return CanState::passive;
        return std::max(m_transmit, m_receive) >= warningFrom ? CanState::warning : CanState::active;
    }

private:
    static constexpr int warningFrom = 96;
    static constexpr int passiveFrom = 128;
    static constexpr int busOffFrom = 256;
    static constexpr int afterPassive = 119; // 119 to 127 are allowed

    int m_transmit = 0;
    int m_receive = 0;
};

} // namespace codewheel
