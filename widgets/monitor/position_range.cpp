// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/position_range.h"

#include "catalog/device_description.h"

namespace codewheel {

std::optional<PositionRange> positionRange(const EncoderSession &encoder)
{
    const DeviceDescription &device = encoder.device();
    if (device.find(Parameter::measuringLength) != nullptr) {
        const auto length = encoder.known(Parameter::measuringLength);
        return length ? std::optional(PositionRange{0, length->value}) : std::nullopt;
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
    if (*encoder.latest().coding != PositionCoding::signedBinary)
        return PositionRange{0, total - 1};
    const std::int64_t firstNegative = (total + 1) / 2; // as an unsigned position
    return PositionRange{firstNegative - total, firstNegative - 1};
}

} // namespace codewheel
