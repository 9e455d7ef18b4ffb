// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/position_scale.h"

#include "catalog/protocol_rules.h"
#include "catalog/total_range.h"
#include "jobs/protocol.h"
#include "vocabulary/circle.h"

#include <algorithm>
#include <cmath>

namespace codewheel {
namespace {

// API without direction: floor(raw x steps / (revolutions x physical steps)) mod total.
std::int64_t scaled(const PositionScale &scale, std::int64_t raw)
{
    return modulo(raw * scale.steps / (scale.revolutions * scale.physicalStepsPerTurn), scale.total());
}

std::int64_t inDirection(const PositionScale &scale, std::int64_t x)
{
    return scale.clockwise ? x : scale.total() - 1 - x;
}

std::int64_t positionOfRaw(const PositionScale &scale, std::int64_t raw)
{
    return scale.shown(inDirection(scale, scaled(scale, raw)) + *scale.zeroOffset + scale.offset);
}

bool differInOffsetsOnly(PositionScale now, const PositionScale &then)
{
    const bool isShiftKnown = now.zeroOffset.has_value() == then.zeroOffset.has_value();
    now.zeroOffset = then.zeroOffset;
    now.offset = then.offset;
    now.preset = then.preset;
    return isShiftKnown && now == then;
}

std::int64_t offsetsOf(const PositionScale &scale)
{
    return scale.zeroOffset.value_or(0) + scale.offset;
}

// Without a range to count in.
std::optional<double> stepsPerTurn(const DeviceDescription &device, const ValueOf &valueOf)
{
    const ScalingState scaling = scalingState(device, valueOf(Parameter::scaling));
    if (scaling == ScalingState::off && device.physicalStepsPerTurn > 0)
        return device.physicalStepsPerTurn;
    const auto steps = valueOf(Parameter::steps);
    const auto revolutions = tellsItsRange(device) ? 1 : valueOf(Parameter::revolutions);
    if (scaling != ScalingState::on || !steps || !revolutions || *steps < 1 || *revolutions < 1)
        return std::nullopt;
    return static_cast<double>(*steps) / static_cast<double>(*revolutions);
}

bool isSignedCoding(const DeviceDescription &device, std::int64_t value)
{
    const Choice *choice = device.find(Parameter::coding)->findChoice(value);
    return choice != nullptr && choice->key.startsWith(QStringLiteral("signed"));
}

} // namespace

// By what the description calls the value. Failing that: codings of the profile with an even number count
// counter-clockwise (Baumer manual 5); direction 4 is CCW (FRABA 5.3).
bool countsClockwise(const DeviceDescription &device, const ParameterValue &directionOrCoding)
{
    const ParameterDescription *description = device.find(directionOrCoding.parameter);
    const Choice *choice = description ? description->findChoice(directionOrCoding.value) : nullptr;
    return choice ? !choice->key.endsWith(QStringLiteral("ccw")) : directionOrCoding.value.number() % 2 != 0;
}

double PositionScale::resolution() const
{
    return static_cast<double>(steps) / static_cast<double>(revolutions);
}

std::int64_t PositionScale::total() const
{
    return totalRange(steps, turns, revolutions);
}

std::int64_t PositionScale::shown(std::int64_t position) const
{
    const std::int64_t pi = modulo(position, total());
    return isSigned ? signedPosition(pi, total()) : pi;
}

std::optional<PositionScale> Protocol::scaleOf(const DeviceDescription &device, const ValueOf &valueOf) const
{
    const auto steps = valueOf(Parameter::steps);
    const auto revolutions = valueOf(Parameter::revolutions);
    if (!steps || !revolutions || *steps < 1 || *revolutions < 1)
        return std::nullopt;
    PositionScale scale;
    scale.steps = *steps;
    scale.revolutions = *revolutions;
    scale.physicalStepsPerTurn = device.physicalStepsPerTurn;
    scale.physicalTurns = device.physicalTurns;
    scale.turns = device.physicalTurns > 0 ? device.physicalTurns : 1;
    if (device.find(Parameter::measuringRange) != nullptr) {
        const auto range = valueOf(Parameter::measuringRange);
        if (!range || *range < 1)
            return std::nullopt;
        scale.turns = *range;
    }
    for (const Parameter parameter : {Parameter::direction, Parameter::coding}) {
        if (device.find(parameter) == nullptr)
            continue;
        const auto value = valueOf(parameter);
        if (!value)
            return std::nullopt;
        scale.clockwise = countsClockwise(device, {parameter, *value});
        scale.isSigned = parameter == Parameter::coding && isSignedCoding(device, *value);
    }
    if (device.find(Parameter::offset) != nullptr)
        scale.offset = valueOf(Parameter::offset).value_or(0);
    scale.zeroOffset = valueOf(Parameter::zeroOffset);
    scale.preset = valueOf(Parameter::preset);
    return scale.total() > 0 ? std::optional(scale) : std::nullopt;
}

std::optional<PositionScale> scaleOf(const DeviceDescription &device, const ValueOf &valueOf)
{
    return protocolOf(device).scaleOf(device, valueOf);
}

std::optional<PositionSpeed::Scale> speedScaleOf(const DeviceDescription &device, const ValueOf &valueOf)
{
    if (onlyTellsPosition(device)) {
        const std::int64_t steps = device.physicalStepsPerTurn;
        return steps < 1 ? std::nullopt
                         : std::optional(PositionSpeed::Scale{.stepsPerTurn = static_cast<double>(steps),
                                                              .total = steps * device.physicalTurns});
    }
    if (const auto scale = scaleOf(device, valueOf))
        return PositionSpeed::Scale{.stepsPerTurn = scale->resolution(), .total = scale->total()};
    const auto turn = stepsPerTurn(device, valueOf);
    return turn ? std::optional(PositionSpeed::Scale{.stepsPerTurn = *turn}) : std::nullopt;
}

std::optional<PositionScale> scaleAfter(const DeviceDescription &device, const ParameterValues &written,
                                        const ParameterValues &known)
{
    const Protocol &protocol = protocolOf(device);
    return protocol.scaleOf(
        device, [&](Parameter parameter) { return protocol.valueAfter(parameter, written, known); });
}

WrapJump wrapJump(const PositionScale &scale)
{
    if (scale.physicalTurns < 1)
        return WrapJump::none;
    if (scale.physicalTurns % scale.turns != 0)
        return WrapJump::rangeDoesNotDivideTurns;
    if (scale.steps * scale.turns % scale.revolutions != 0)
        return WrapJump::totalIsNotWhole;
    return WrapJump::none;
}

std::int64_t jumpAtWrap(const PositionScale &scale)
{
    if (scale.physicalTurns < 1 || scale.total() < 1)
        return 0;
    const std::int64_t due = modulo(scale.physicalTurns * scale.steps / scale.revolutions, scale.total());
    return std::min(due, scale.total() - due);
}

std::optional<ForetoldPosition> foretellPosition(const PositionScale &now, std::int64_t position,
                                                 const PositionScale &then)
{
    if (differInOffsetsOnly(now, then) && then.total() > 0)
        return ForetoldPosition{then.shown(position + offsetsOf(then) - offsetsOf(now)), true};
    const bool tellsThePlace = now.zeroOffset && then.zeroOffset && now.physicalStepsPerTurn > 0 &&
                               now.turns == now.physicalTurns && now.total() > 0 && then.total() > 0;
    if (!tellsThePlace)
        return std::nullopt;
    const std::int64_t api = modulo(position - *now.zeroOffset - now.offset, now.total());
    const std::int64_t x = inDirection(now, api);
    // The raw positions that give x; the encoder is at one of them.
    const std::int64_t divisor = now.revolutions * now.physicalStepsPerTurn;
    const std::int64_t first = (x * divisor + now.steps - 1) / now.steps;
    const std::int64_t last = ((x + 1) * divisor - 1) / now.steps;
    const std::int64_t atFirst = positionOfRaw(then, first);
    return ForetoldPosition{atFirst, atFirst == positionOfRaw(then, last)};
}

std::int64_t positionAfterTurns(const PositionScale &scale, std::int64_t start, double turns)
{
    const auto way = static_cast<std::int64_t>(std::floor(turns * scale.resolution()));
    return scale.shown(start + (scale.clockwise ? way : -way));
}

} // namespace codewheel
