// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace codewheel {

// The machine: one turn of the driven part moves it by mmPerTurn, and the encoder makes encoderTurns while
// that part makes partTurns.
struct Gear
{
    double mmPerTurn = 0;
    double encoderTurns = 1;
    double partTurns = 1;
    double mmPerStep = 0; // wanted resolution

    // Travel per turn of the encoder; 0 if the input makes no sense.
    double mmPerEncoderTurn() const;
};

// What the encoder accepts.
struct GearLimits
{
    std::int64_t maxSteps = 33'554'431;
    std::int64_t maxRevolutions = 4096;
    std::int64_t physicalStepsPerTurn = 0; // 0: not known
    std::int64_t turns = 4096;             // measuring range, or the physical turns
    std::int64_t totalRange = 33'554'432;
};

struct GearResult
{
    std::int64_t steps = 0;
    std::int64_t revolutions = 0;
    double mmPerStep = 0;       // as achieved
    double travel = 0;          // mm over all turns
    double errorOverTravel = 0; // mm by which the position is off at the far end
};

// The steps and revolutions that come closest to the wanted resolution; of equally close ones, those with the
// fewest revolutions. Nothing if the input makes no sense or no pair within the limits gives even one step.
std::optional<GearResult> stepsForGear(const Gear &gear, const GearLimits &limits);

} // namespace codewheel
