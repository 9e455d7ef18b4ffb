// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/position_range.h"

#include "catalog/position_format.h"

namespace codewheel {
namespace {

PositionRange rangeOf(std::int64_t total, PositionCoding coding)
{
    if (coding != PositionCoding::signedBinary)
        return {0, total - 1};
    const std::int64_t firstNegative = (total + 1) / 2; // as an unsigned position
    return {firstNegative - total, firstNegative - 1};
}

} // namespace

std::optional<PositionRange> positionRange(const EncoderSession &encoder)
{
    const DeviceDescription &device = encoder.device();
    if (device.find(Parameter::measuringLength) != nullptr) {
        const auto length = encoder.known(Parameter::measuringLength);
        return length ? std::optional(PositionRange{0, length->value}) : std::nullopt;
    }
    if (device.profile == Profile::esc) {
        const auto range = encoder.known(Parameter::measuringRange);
        return range && range->value > 1 ? std::optional(PositionRange{0, range->value - 1}) : std::nullopt;
    }
    if (onlyTellsPosition(device.profile)) {
        const std::int64_t positions = std::int64_t{device.physicalStepsPerTurn} * device.physicalTurns;
        return positions < 2 ? std::nullopt : std::optional(rangeOf(positions, device.coding));
    }
    const auto steps = encoder.known(Parameter::steps);
    const auto revolutions = encoder.known(Parameter::revolutions);
    if (!steps || !revolutions || revolutions->value < 1 || !encoder.latest().coding)
        return {};

    std::int64_t turns = device.physicalTurns;
    if (device.find(Parameter::measuringRange) != nullptr) {
        const auto range = encoder.known(Parameter::measuringRange);
        turns = range ? range->value : 0;
    }
    const std::int64_t total = steps->value * turns / revolutions->value;
    if (total < 2)
        return {};
    return rangeOf(total, *encoder.latest().coding);
}

} // namespace codewheel
