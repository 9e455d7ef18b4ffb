// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_word.h"
#include "simulator/turning_shaft.h"

#include <cstdint>

namespace codewheel {

// The parameters of a K3 encoder under the numbers of the profile (FRABA 5.3, Baumer 5).
struct ParameterSet
{
    std::int64_t steps = 8192;          // 1
    std::int64_t revolutions = 1;       // 2
    std::int64_t coding = 3;            // 3: 1/2 signed, 3/4 unsigned, 5/6 Gray; odd CW, even CCW
    std::int64_t preset = 0;            // 4
    std::int64_t zeroOffset = 0;        // 5, NPV
    std::int64_t offset = 0;            // 6, Baumer
    std::int64_t measuringRange = 4096; // 15, Baumer; elsewhere the physical turns
    bool presetArmed = false;           // FRABA preset flag: programmed, not yet activated

    friend bool operator==(const ParameterSet &, const ParameterSet &) = default;
};

// Numbers in D28..D25; 7 is not a value but the command "set to default".
namespace parameter_number {
inline constexpr unsigned steps = 1;
inline constexpr unsigned revolutions = 2;
inline constexpr unsigned coding = 3;
inline constexpr unsigned preset = 4;
inline constexpr unsigned zeroOffset = 5;
inline constexpr unsigned offset = 6;
inline constexpr unsigned setToDefault = 7;
inline constexpr unsigned measuringRange = 15;
} // namespace parameter_number

inline constexpr std::int64_t mostTurns = 4096;

// Steps over the whole measuring range; 0 if the set makes no sense.
constexpr std::int64_t totalRange(const ParameterSet &set)
{
    return set.revolutions < 1 ? 0 : set.steps * set.measuringRange / set.revolutions;
}

// Whether the values, each and together, are possible for an encoder. The zero offset is not checked: it is
// kept modulo the total range.
constexpr bool isAdmissible(const ParameterSet &set, PhysicalResolution physical)
{
    const std::int64_t total = totalRange(set);
    return set.steps >= 1 && set.steps <= k3::dataMask && set.revolutions >= 1 &&
           set.revolutions <= mostTurns && set.coding >= 1 && set.coding <= 6 && set.measuringRange >= 1 &&
           set.measuringRange <= mostTurns && set.steps <= physical.stepsPerTurn * set.revolutions &&
           total >= 1 && total <= k3::largestTotalRange && set.preset < total && set.offset < total;
}

} // namespace codewheel
