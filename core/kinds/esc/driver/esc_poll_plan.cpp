// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/driver/esc_poll_plan.h"

#include <algorithm>

namespace codewheel {

void EscPollPlan::setSettings(const EscSettings &settings)
{
    m_settings = settings;
    m_settings.positionInterval = std::max(settings.positionInterval, EscSettings::shortestInterval);
}

void EscPollPlan::positionAsked(Instant now)
{
    m_lastPosition = now;
    m_position = now + (m_isSilent ? m_settings.silentInterval : m_settings.positionInterval);
}

void EscPollPlan::askPositionAgain()
{
    m_position =
        m_lastPosition ? std::optional(*m_lastPosition + EscSettings::shortestInterval) : std::nullopt;
}

void EscPollPlan::contact(Instant now)
{
    m_between = {esc::Command::serialNumber, esc::Command::version, esc::Command::deviceCode};
    m_putOff.clear();
    m_status = now;
    m_isSilent = false;
    if (m_lastPosition)
        m_position = *m_lastPosition + m_settings.positionInterval;
}

void EscPollPlan::silence(Instant now)
{
    m_status.reset();
    m_between.clear();
    m_putOff.clear();
    m_position = now + m_settings.silentInterval;
    m_isSilent = true;
}

std::optional<esc::Command> EscPollPlan::between(Instant now)
{
    if (m_status && now >= *m_status && m_between.empty()) {
        m_between = {esc::Command::warnings, esc::Command::alarms};
        m_between.insert(m_between.end(), m_putOff.begin(), m_putOff.end());
        m_putOff.clear();
        m_status = now + m_settings.statusInterval;
    }
    return m_between.empty() ? std::nullopt : std::optional(m_between.front());
}

void EscPollPlan::betweenDone()
{
    if (!m_between.empty())
        m_between.pop_front();
}

void EscPollPlan::putOff()
{
    if (m_between.empty())
        return;
    const esc::Command command = m_between.front();
    if (command != esc::Command::warnings && command != esc::Command::alarms) // these come round again anyway
        m_putOff.push_back(command);
    m_between.pop_front();
}

Instant EscPollPlan::wakesAt(Instant now) const
{
    if (!m_between.empty())
        return now;
    const Instant position = m_position.value_or(now);
    return m_status ? std::min(position, *m_status) : position;
}

} // namespace codewheel
