// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/known.h"
#include "vocabulary/position_speed.h"

#include <functional>
#include <optional>

namespace codewheel {

// How an encoder derives its position from its shaft (docs/protocols/k3.md, arithmetic), as far as needed to
// tell what a set of parameters will do.
struct PositionScale
{
    std::int64_t steps = 1;
    std::int64_t revolutions = 1;
    std::int64_t turns = 4096; // measuring range, or the physical turns if it has none
    bool clockwise = true;
    bool isSigned = false;
    std::optional<std::int64_t> zeroOffset; // empty: not known
    std::optional<std::int64_t> preset;
    std::int64_t offset = 0;
    std::int64_t physicalStepsPerTurn = 0; // 0: not known
    std::int64_t physicalTurns = 0;

    double resolution() const;  // steps per turn
    std::int64_t total() const; // total range in steps; 0: the values make no sense
    // PI within the total range, as the coding shows it.
    std::int64_t shown(std::int64_t position) const;

    friend bool operator==(const PositionScale &, const PositionScale &) = default;
};

// By its direction, or its coding if that determines it.
bool countsClockwise(const DeviceDescription &device, const ParameterValue &directionOrCoding);

using ValueOf = std::function<std::optional<std::int64_t>(Parameter)>;

// Empty if steps or revolutions, the direction of an encoder that has one, or whether it scales its position,
// are not known.
std::optional<PositionScale> scaleOf(const DeviceDescription &device, const ValueOf &valueOf);

// What it takes to derive the speed of an encoder on a shaft from its positions; empty if the steps per turn
// are not known.
std::optional<PositionSpeed::Scale> speedScaleOf(const DeviceDescription &device, const ValueOf &valueOf);

// Once `written` is written to an encoder that is known to have `known`.
std::optional<PositionScale> scaleAfter(const DeviceDescription &device, const ParameterValues &written,
                                        const ParameterValues &known);

// Why the position will jump when the physical turns are used up.
enum class WrapJump : std::uint8_t {
    none,
    rangeDoesNotDivideTurns, // measuring range 5 of 4096 turns
    totalIsNotWhole,         // 1000 steps in 3 revolutions: a fraction of a step is cut
};
WrapJump wrapJump(const PositionScale &scale);
// By how many steps it jumps there: instead of going on, the position starts at 0 again.
std::int64_t jumpAtWrap(const PositionScale &scale);

// What an encoder that shows `position` with the scale `now` will show with the scale `then`, the shaft not
// moving.
struct ForetoldPosition
{
    std::int64_t position = 0;
    bool exact = false; // otherwise off by about a step of the old scale

    friend bool operator==(const ForetoldPosition &, const ForetoldPosition &) = default;
};
std::optional<ForetoldPosition> foretellPosition(const PositionScale &now, std::int64_t position,
                                                 const PositionScale &then);

// The position `turns` clockwise from where it is `start`.
std::int64_t positionAfterTurns(const PositionScale &scale, std::int64_t start, double turns);

} // namespace codewheel
