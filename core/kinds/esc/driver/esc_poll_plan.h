// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/driver/esc_settings.h"
#include "kinds/esc/protocol/esc_command.h"

#include <deque>
#include <optional>

namespace codewheel {

// What is asked of an encoder on a serial line while no job wants anything, and when: the position
// continually; once it answers, its identity; and warnings and alarms now and then. A silent one is asked
// seldom.
class EscPollPlan
{
public:
    explicit EscPollPlan(const EscSettings &settings) { setSettings(settings); }

    void setSettings(const EscSettings &settings);

    bool isPositionDue(Instant now) const { return !m_position || now >= *m_position; }
    void positionAsked(Instant now);
    void askPositionAgain(); // as soon as the encoder allows

    // The encoder answers, but may not be the same one: its identity is asked for.
    void contact(Instant now);
    void silence(Instant now);
    bool isInContact() const { return m_status.has_value(); }

    // What goes between two positions; the same until it is done or put off.
    std::optional<esc::Command> between(Instant now);
    void betweenDone();
    void putOff(); // to be asked for again with the next warnings and alarms

    Instant wakesAt(Instant now) const;

private:
    EscSettings m_settings;
    std::optional<Instant> m_lastPosition; // asked for
    std::optional<Instant> m_position;     // due; empty: at once
    std::optional<Instant> m_status;       // due; empty: no contact
    bool m_isSilent = false;
    std::deque<esc::Command> m_between;
    std::deque<esc::Command> m_putOff;
};

} // namespace codewheel
