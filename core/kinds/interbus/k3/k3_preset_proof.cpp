// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_preset_proof.h"

#include "kinds/interbus/words/word_answer.h"
#include "vocabulary/circle.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace codewheel {
namespace {

constexpr double edgeOfSteps = 2; // a shaft that stands trembles by that much
constexpr double faster = 4;      // than it has turned before (assumed)
constexpr Instant longestQuestion = std::chrono::minutes(1);

} // namespace

std::int64_t K3PresetProof::way(std::int64_t from, std::int64_t to) const
{
    return m_target && m_target->total ? shorterWay(from, to, *m_target->total) : to - from;
}

bool K3PresetProof::isNear(std::int64_t position, double steps) const
{
    return m_target && std::abs(static_cast<double>(way(m_target->position, position))) <= steps;
}

// Where the range is not known, a position that goes on behind its last step looks like a jump to the first.
bool K3PresetProof::mayBeEndOfRange(std::int64_t before, std::int64_t position, double reach) const
{
    if (!m_target || m_target->total)
        return false;
    const auto isAtZero = [reach](std::int64_t at) { return static_cast<double>(at) <= reach; };
    return (m_direction > 0 && isAtZero(position)) || (m_direction < 0 && isAtZero(before));
}

// What is not seen without a gap proves nothing.
void K3PresetProof::see(std::optional<std::int64_t> position, Instant now)
{
    ++m_cycles;
    if (!position) {
        m_last.reset();
        m_speed.reset();
        m_direction = 0;
        m_hasArrived = m_stoodThere = false;
        return;
    }
    const auto last = std::exchange(m_last, Seen{*position, now});
    if (*position == 0 && (!last || last->position != 0))
        m_zeroSince = now;
    m_stoodThere = m_stoodThere && isNear(*position, edgeOfSteps);
    if (!last || now <= last->at)
        return;
    const auto time = static_cast<double>((now - last->at).count());
    const std::int64_t moved = way(last->position, *position);
    const double speed = std::abs(static_cast<double>(moved)) / time;
    const double reach = edgeOfSteps + faster * m_speed.value_or(speed) * time;
    m_couldHide = m_couldHide || isNear(last->position, 2 * reach);
    if (std::abs(static_cast<double>(moved)) > reach) {
        if (!mayBeEndOfRange(last->position, *position, reach))
            jumpTo(*position, reach);
        return;
    }
    m_speed = m_isAsked ? std::max(m_speed.value_or(0), speed) : speed;
    m_isAsked = m_isAsked && now - m_begunAt < longestQuestion;
    m_direction = moved != 0 ? moved : m_direction;
}

void K3PresetProof::jumpTo(std::int64_t position, double reach)
{
    m_hasJumped = true;
    m_hasArrived = isNear(position, reach);
}

void K3PresetProof::begin(std::optional<Target> target, Instant now)
{
    m_target = target;
    m_begunAt = now;
    m_cycles = 0;
    m_isAsked = true;
    m_hasJumped = false;
    m_hasArrived = false;
    m_couldHide = false;
    m_stoodThere = m_last && isNear(m_last->position, edgeOfSteps);
}

bool K3PresetProof::hasActed(Instant now, const K3Timing &timing) const
{
    return m_hasJumped || (now - m_begunAt >= timing.presetActs && m_cycles >= cyclesOfAnswer);
}

// Position 0, or an encoder that has just lost its power, or its place on the bus.
bool K3PresetProof::showsOnlyZero(Instant now, const K3Timing &timing) const
{
    return m_last && m_last->position == 0 && now - m_zeroSince < timing.restart;
}

bool K3PresetProof::isOver(Instant now, const K3Timing &timing) const
{
    if (now - m_begunAt >= timing.timeOut && m_cycles >= cyclesOfAnswer)
        return true;
    if (showsOnlyZero(now, timing))
        return false;
    return m_hasArrived || (m_stoodThere && hasActed(now, timing)) || (!m_target && m_hasJumped);
}

K3PresetProof::Said K3PresetProof::says() const
{
    if (m_hasArrived || m_stoodThere)
        return Said::done;
    return m_target && m_last && !m_couldHide ? Said::notDone : Said::nothing;
}

std::optional<K3PresetProof::Target> presetTarget(const DeviceDescription &device,
                                                  const K3Knowledge &knowledge)
{
    const auto valueOf = [&](Parameter parameter) { return knowledge.value(parameter); };
    const bool isInPositionMode = !device.mayHaveModes() || knowledge.mode() == Mode::position;
    return isInPositionMode ? presetPosition(device, valueOf, knowledge.coding()) : std::nullopt;
}

} // namespace codewheel
