// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace codewheel {

struct RodResult
{
    std::int64_t steps = 0;     // measuring length
    double mmPerStep = 0;       // as achieved
    double errorOverLength = 0; // mm by which steps of the wanted resolution miss the end of the rod
};

// The measuring length in steps that comes closest to the wanted resolution (LA-66 manual 3.2): measuring
// length [mm] / resolution [mm]. Nothing if the input makes no sense, or gives no step, or more than `most`.
std::optional<RodResult> stepsForRod(double millimetres, double mmPerStep, std::int64_t most);

} // namespace codewheel
