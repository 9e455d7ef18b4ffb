// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/driver/esc_position_agreement.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace codewheel {
namespace {

using Sample = EscPositionAgreement::Sample;

// On top of what the shaft turned: a position at the edge of a step may show as either.
constexpr double edgeSteps = 2;
// How much the speed may differ from one read to the next (assumed).
constexpr double speedChange = 0.5;

double elapsed(const Sample &from, const Sample &to)
{
    return static_cast<double>(std::max<Instant::rep>((to.at - from.at).count(), 1));
}

} // namespace

// Whether the last three fit one movement.
bool EscPositionAgreement::isSteady(const EscPositionGuard &guard) const
{
    if (m_samples.size() < 3)
        return false;
    const auto last = m_samples.end() - 1;
    const auto &[first, second, third] = std::tie(*(last - 2), *(last - 1), *last);
    const auto canTurn = [&](const Sample &from, const Sample &to) {
        return guard.canReach(from.position, to.position, to.at - from.at);
    };
    const auto turned = [&](const Sample &from, const Sample &to) {
        return static_cast<double>(guard.turned(from.position, to.position));
    };
    const double expected = turned(first, second) / elapsed(first, second) * elapsed(second, third);
    return canTurn(first, second) && canTurn(second, third) &&
           std::abs(turned(second, third) - expected) <= edgeSteps + speedChange * std::abs(expected);
}

EscPositionAgreement::State EscPositionAgreement::add(const Sample &sample, const EscPositionGuard &guard)
{
    m_samples.push_back(sample);
    if (m_samples.size() < 2)
        return State::wantsMore;
    const Sample &before = *(m_samples.end() - 2);
    m_speed = static_cast<double>(guard.turned(before.position, sample.position)) / elapsed(before, sample);
    if (before.position == sample.position || isSteady(guard))
        return State::agreed;
    return static_cast<int>(m_samples.size()) < m_mostReads ? State::wantsMore : State::disagreed;
}

} // namespace codewheel
