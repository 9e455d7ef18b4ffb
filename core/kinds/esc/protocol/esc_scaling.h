// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_command.h"

#include <cstdint>
#include <optional>

// The scaling factor (F, GF): how many steps of the code disc make up one shown step, as a signed 32-bit
// fraction. The manual calls its format "special"; that it has 29 fraction bits is assumed from its example
// 1F400000h = 8000/8192. For GR and GT the master computes it to 32 bits and sends it with GF.
namespace codewheel::esc {

inline constexpr int defaultFractionBits = 29;
inline constexpr int fewestFractionBits = 17; // 0.00001 needs them
inline constexpr int mostFractionBits = 30;   // 31 could not hold 1.0

inline constexpr double smallestFactor = 0.00001;
inline constexpr double largestFactor = 1.0;

inline constexpr std::uint32_t discSteps = 8192; // on the code disc, per turn
inline constexpr std::uint32_t discTurns = 4096;

// What a value may be, both ends included; none if the smallest is above the largest.
struct ValueRange
{
    std::uint32_t smallest = 1;
    std::uint32_t largest = 0;

    bool holds(std::uint32_t value) const { return value >= smallest && value <= largest; }

    friend bool operator==(const ValueRange &, const ValueRange &) = default;
};

// What a command's data or answer may be, by the tables of the manual: the limits that all parts of the
// program use. Those of the scaling factor follow from the fraction bits of the line.
ValueRange valueRange(Command command, int fractionBits = defaultFractionBits);

// The range that the manual states for F, as the 32 bits; for an impossible number of fraction bits it is
// empty.
ValueRange scalingFactorRange(int fractionBits);
bool isScalingFactor(std::uint32_t raw, int fractionBits);

// What the 32 bits stand for; negative with the highest bit set.
double scalingFactor(std::uint32_t raw, int fractionBits);
// numerator / denominator, to the nearest the format can hold. Empty outside 0.00001..1.0, or for an
// impossible number of fraction bits.
std::optional<std::uint32_t> rawScalingFactor(std::uint64_t numerator, std::uint64_t denominator,
                                              int fractionBits);

// GF to go with GR: `stepsPerTurn` 1..8192.
std::optional<std::uint32_t> factorForSteps(std::uint32_t stepsPerTurn, int fractionBits);
// GF to go with GT: `measuringRange` steps in `turns` (1..4096) turns.
std::optional<std::uint32_t> factorForRange(std::uint32_t measuringRange, std::uint32_t turns,
                                            int fractionBits);

// "Determine from device": the number of fraction bits with which the factor read by F fits the steps per
// turn read by D or, where these are too few to decide, the measuring range read by M. Empty if none fits.
std::optional<int> fractionBitsFrom(std::uint32_t factor, std::uint32_t stepsPerTurn,
                                    std::uint32_t measuringRange);

} // namespace codewheel::esc
