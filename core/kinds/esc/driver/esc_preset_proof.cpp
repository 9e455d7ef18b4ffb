// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/driver/esc_preset_proof.h"

#include <algorithm>
#include <cmath>

namespace codewheel {
namespace {

// Between a position and the answer that reports it, or a command and its execution, the line and the adapter
// take this long (assumed).
constexpr double longestDelay = 50'000; // us
constexpr double edgeOfStep = 2;        // steps

// Whether a shaft that was at one place has turned to the other.
bool hasTurned(const EscPresetProof::Position &before, const EscPresetProof::Position &after,
               const EscPositionGuard &guard)
{
    const auto time = static_cast<double>((after.sample.at - before.sample.at).count());
    const double expected = (before.speed + after.speed) / 2 * time;
    const double doubt = std::abs(after.speed - before.speed) / 2 * time +
                         std::max(std::abs(after.speed), std::abs(before.speed)) * longestDelay + edgeOfStep;
    const auto turned = guard.turned(before.sample.position, after.sample.position);
    return std::abs(static_cast<double>(turned) - expected) <= doubt;
}

} // namespace

// A position that no shaft can have turned to decides; otherwise what this one turned, by the speed seen
// before and after.
EscPresetProof::Said EscPresetProof::positionSays(std::int64_t preset, const EscPositionGuard &guard) const
{
    if (!positionAfter)
        return Said::nothing;
    const auto isReachable = [&](const EscPositionAgreement::Sample &from) {
        const auto &[position, at] = positionAfter->sample;
        return guard.canReach(from.position, position, at - from.at);
    };
    if (!isReachable({preset, sentAt.value_or(Instant())}))
        return Said::notDone;
    if (!positionBefore)
        return Said::nothing;
    if (!isReachable(positionBefore->sample))
        return Said::done;
    const bool fromPreset = hasTurnedFromPreset(preset, guard);
    const bool fromBefore = hasTurned(*positionBefore, *positionAfter, guard);
    if (fromPreset == fromBefore)
        return Said::nothing;
    return fromPreset ? Said::done : Said::notDone;
}

bool EscPresetProof::hasTurnedFromPreset(std::int64_t preset, const EscPositionGuard &guard) const
{
    if (!positionAfter || !sentAt)
        return false;
    const double speed = positionBefore ? positionBefore->speed : positionAfter->speed;
    return hasTurned({{preset, *sentAt}, speed}, *positionAfter, guard);
}

// That it equals the preset proves something only if it was different before. If that is not known, a command
// that was answered is believed.
EscPresetProof::Said EscPresetProof::valueSays(std::int64_t preset, bool isAnswered) const
{
    if (!valueAfter)
        return Said::nothing;
    if (valueAfter != preset)
        return Said::notDone;
    const bool hasChanged = valueBefore ? valueBefore != preset : isAnswered;
    return hasChanged ? Said::done : Said::nothing;
}

} // namespace codewheel
