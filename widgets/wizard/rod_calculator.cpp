// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/rod_calculator.h"

#include <cmath>

namespace codewheel {

std::optional<RodResult> stepsForRod(double millimetres, double mmPerStep, std::int64_t most)
{
    const double steps = std::round(millimetres / mmPerStep);
    if (!(millimetres > 0) || !(mmPerStep > 0) || !(steps >= 1) || !(steps <= static_cast<double>(most)))
        return std::nullopt;
    return RodResult{.steps = static_cast<std::int64_t>(steps),
                     .mmPerStep = millimetres / steps,
                     .errorOverLength = steps * mmPerStep - millimetres};
}

} // namespace codewheel
