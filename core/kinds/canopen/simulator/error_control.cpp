// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/simulator/error_control.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

Instant heartbeatOf(const ObjectDictionary &objects)
{
    return std::chrono::milliseconds(objects.number(0x1017));
}

} // namespace

void ErrorControl::begin(Instant now)
{
    *this = {};
    m_beatAt = now;
}

std::optional<std::uint8_t> ErrorControl::guarded(NmtState state, const ObjectDictionary &objects,
                                                  Instant now)
{
    constexpr std::uint8_t toggleBit = 0x80;
    if (heartbeatOf(objects) > Instant{})
        return std::nullopt;
    const Instant lifeTime = std::chrono::milliseconds(objects.number(0x100C) * objects.number(0x100D));
    m_lostAt = lifeTime > Instant{} ? std::optional(now + lifeTime) : std::nullopt;
    const auto answer =
        static_cast<std::uint8_t>(static_cast<std::uint8_t>(state) | (m_toggle ? toggleBit : 0));
    m_toggle = !m_toggle;
    return answer;
}

bool ErrorControl::isHeartbeatDue(const ObjectDictionary &objects, Instant now)
{
    const Instant period = heartbeatOf(objects);
    if (period == Instant{} || now < m_beatAt + period)
        return false;
    m_beatAt = now < m_beatAt + 2 * period ? m_beatAt + period : now; // or just switched on
    m_lostAt.reset();
    return true;
}

bool ErrorControl::isGuardingLost(Instant now)
{
    if (!m_lostAt || now < *m_lostAt)
        return false;
    m_lostAt.reset();
    return true;
}

std::optional<Instant> ErrorControl::wakesAt(const ObjectDictionary &objects) const
{
    const Instant period = heartbeatOf(objects);
    const auto beat = period > Instant{} ? std::optional(m_beatAt + period) : std::nullopt;
    return beat && m_lostAt ? std::min(beat, m_lostAt) : beat ? beat : m_lostAt;
}

} // namespace codewheel::canopen
