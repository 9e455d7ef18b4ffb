// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/gear_calculator.h"

#include <algorithm>
#include <cmath>

namespace codewheel {
namespace {

constexpr double equallyClose = 1e-9; // in steps per turn

bool isPositive(double number)
{
    return std::isfinite(number) && number > 0;
}

std::int64_t mostSteps(const GearLimits &limits, std::int64_t revolutions)
{
    std::int64_t most = std::min(limits.maxSteps, limits.totalRange * revolutions / limits.turns);
    if (limits.physicalStepsPerTurn > 0)
        most = std::min(most, limits.physicalStepsPerTurn * revolutions);
    return most;
}

} // namespace

double Gear::mmPerEncoderTurn() const
{
    const bool makesSense = isPositive(mmPerTurn) && isPositive(encoderTurns) && isPositive(partTurns);
    return makesSense ? mmPerTurn * partTurns / encoderTurns : 0;
}

std::optional<GearResult> stepsForGear(const Gear &gear, const GearLimits &limits)
{
    const double mmPerTurn = gear.mmPerEncoderTurn();
    if (!isPositive(mmPerTurn) || !isPositive(gear.mmPerStep) || limits.turns < 1)
        return std::nullopt;
    const double wanted = mmPerTurn / gear.mmPerStep; // steps per turn
    GearResult best;
    double bestError = 0;
    for (std::int64_t revolutions = 1; revolutions <= limits.maxRevolutions; ++revolutions) {
        const auto most = static_cast<double>(mostSteps(limits, revolutions));
        const double steps = std::round(wanted * static_cast<double>(revolutions));
        if (steps < 1 || steps > most)
            continue;
        const double error = std::abs(steps / static_cast<double>(revolutions) - wanted);
        if (best.steps > 0 && error >= bestError - equallyClose)
            continue;
        best.steps = static_cast<std::int64_t>(steps);
        best.revolutions = revolutions;
        bestError = error;
    }
    if (best.steps == 0)
        return std::nullopt;
    const double perTurn = static_cast<double>(best.steps) / static_cast<double>(best.revolutions);
    best.mmPerStep = mmPerTurn / perTurn;
    best.travel = mmPerTurn * static_cast<double>(limits.turns);
    best.errorOverTravel = (perTurn - wanted) * static_cast<double>(limits.turns) * gear.mmPerStep;
    return best;
}

} // namespace codewheel
