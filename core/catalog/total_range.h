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

// How many positions the encoder has with these values, where turns is the measuring range, or the physical
// turns if the encoder has none. Empty if one of them is not known.
std::optional<std::int64_t> totalRange(const DeviceDescription &device, const ParameterValues &values);

} // namespace codewheel
