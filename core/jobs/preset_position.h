// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/position_scale.h"
#include "vocabulary/reading.h"

namespace codewheel {

// Where the position of an encoder goes when it is set to its programmed preset (spec k3.md, arithmetic).
struct PresetPosition
{
    std::int64_t position = 0;
    std::optional<std::int64_t> total{}; // range of the position in steps; empty: not known
};

// Empty where preset, offset or coding, or the range in which it counts, are not known.
std::optional<PresetPosition> presetPosition(const DeviceDescription &device, const ValueOf &valueOf,
                                             std::optional<PositionCoding> coding);

} // namespace codewheel
