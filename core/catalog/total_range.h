// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

namespace codewheel {

// floor(steps x turns / revolutions); 0: the values make no sense.
constexpr std::int64_t totalRange(std::int64_t steps, std::int64_t turns, std::int64_t revolutions) noexcept
{
    return steps < 1 || turns < 1 || revolutions < 1 ? 0 : steps * turns / revolutions;
}

// Whether the measuring range of the encoder is in steps, making it the total range; otherwise it is in
// revolutions.
bool tellsItsRange(const DeviceDescription &device);

// Whether an encoder counts the steps it is given, or those of its code disc. Some have a switch for it, and
// keep the steps they are given while it is off.
enum class ScalingState : std::uint8_t { on, off, unknown };
ScalingState scalingState(const DeviceDescription &device, std::optional<std::int64_t> scaling);

// All steps of the code discs; 0: not known.
std::int64_t physicalRange(const DeviceDescription &device);

// How many positions the encoder has with these values, where turns is the measuring range, or the physical
// turns if the encoder has none. Empty if one of them is not known.
std::optional<std::int64_t> totalRange(const DeviceDescription &device, const ParameterValues &values);

} // namespace codewheel
