// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/preset_position.h"

namespace codewheel {

std::optional<PresetPosition> presetPosition(const DeviceDescription &device, const ValueOf &valueOf,
                                             std::optional<PositionCoding> coding)
{
    const auto preset = valueOf(Parameter::preset);
    const bool mayHaveOffset = device.find(Parameter::offset) != nullptr || device.isGeneric();
    const auto offset = mayHaveOffset ? valueOf(Parameter::offset) : std::optional<std::int64_t>(0);
    if (!preset || !offset || !coding)
        return std::nullopt;
    const std::int64_t position = *preset + *offset;
    if (const auto scale = scaleOf(device, valueOf))
        return PresetPosition{scale->shown(position), scale->total()};
    const bool isWithinAnyRange = *offset == 0 && coding != PositionCoding::signedBinary;
    return isWithinAnyRange ? std::optional(PresetPosition{position}) : std::nullopt;
}

} // namespace codewheel
