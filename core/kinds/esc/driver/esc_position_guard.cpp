// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/driver/esc_position_guard.h"

#include "vocabulary/circle.h"

#include <cmath>
#include <cstdlib>

namespace codewheel {
namespace {

constexpr double secondsPerMinute = 60;
constexpr std::int64_t largestPosition = 33'554'432; // manual, table of the read commands, P

} // namespace

std::int64_t EscPositionGuard::turned(std::int64_t from, std::int64_t to) const
{
    const bool isOnCircle = m_scale.total && std::abs(to - from) <= *m_scale.total;
    return isOnCircle ? shorterWay(from, to, *m_scale.total) : to - from;
}

bool EscPositionGuard::canReach(std::int64_t from, std::int64_t to, Instant within) const
{
    const std::int64_t distance = std::abs(turned(from, to));
    const double turns = m_scale.topSpeed / secondsPerMinute * std::chrono::duration<double>(within).count();
    return static_cast<double>(distance) <= std::ceil(turns * static_cast<double>(m_scale.stepsPerTurn)) + 1;
}

bool EscPositionGuard::fits(const std::optional<Sample> &before, const Sample &now) const
{
    return before && canReach(before->position, now.position, now.at - before->at);
}

EscPositionGuard::Verdict EscPositionGuard::judge(std::int64_t position, Instant at)
{
    const Sample now{position, at};
    if (m_suspect && fits(m_suspect, now)) {
        ++m_figures.confirmed;
    } else if (m_suspect && fits(m_taken, now)) {
        ++m_figures.refuted;
    } else if ((m_taken && !fits(m_taken, now)) || position > largestPosition) {
        m_suspect = now;
        ++m_figures.suspect;
        return Verdict::suspect;
    }
    m_suspect.reset();
    m_taken = now;
    return Verdict::taken;
}

void EscPositionGuard::forget()
{
    m_taken.reset();
    m_suspect.reset();
}

} // namespace codewheel
