// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_scaling.h"

#include <cmath>
#include <vector>

namespace codewheel::esc {
namespace {

constexpr std::uint64_t smallestFactorPart = 100'000; // 0.00001
constexpr std::uint64_t mostParts = 1ULL << 32;
constexpr std::uint32_t signBit = 0x8000'0000;

bool isFormat(int fractionBits)
{
    return fractionBits >= fewestFractionBits && fractionBits <= mostFractionBits;
}

// The device may have rounded either way, and so may the factor.
bool showsAs(double factor, double discCount, std::uint32_t shown, int fractionBits)
{
    const double roundedBy = 1 + std::ldexp(discCount, -fractionBits);
    return std::abs(factor * discCount - shown) <= roundedBy;
}

} // namespace

ValueRange valueRange(Command command, int fractionBits)
{
    if (command == Command::scalingFactor || command == Command::writeScalingFactor)
        return scalingFactorRange(fractionBits);
    const CommandShape &shape = shapeOf(command);
    return {shape.minimum, shape.maximum};
}

ValueRange scalingFactorRange(int fractionBits)
{
    const auto smallest = rawScalingFactor(1, smallestFactorPart, fractionBits);
    return smallest ? ValueRange{*smallest, std::uint32_t{1} << fractionBits} : ValueRange{};
}

bool isScalingFactor(std::uint32_t raw, int fractionBits)
{
    return scalingFactorRange(fractionBits).holds(raw);
}

double scalingFactor(std::uint32_t raw, int fractionBits)
{
    return std::ldexp(static_cast<double>(static_cast<std::int32_t>(raw)), -fractionBits);
}

std::optional<std::uint32_t> rawScalingFactor(std::uint64_t numerator, std::uint64_t denominator,
                                              int fractionBits)
{
    if (!isFormat(fractionBits) || denominator == 0 || denominator > mostParts || numerator > denominator ||
        numerator * smallestFactorPart < denominator)
        return std::nullopt;
    return static_cast<std::uint32_t>(((numerator << fractionBits) + denominator / 2) / denominator);
}

std::optional<std::uint32_t> factorForSteps(std::uint32_t stepsPerTurn, int fractionBits)
{
    return rawScalingFactor(stepsPerTurn, discSteps, fractionBits);
}

std::optional<std::uint32_t> factorForRange(std::uint32_t measuringRange, std::uint32_t turns,
                                            int fractionBits)
{
    if (turns > discTurns)
        return std::nullopt;
    return rawScalingFactor(measuringRange, std::uint64_t{discSteps} * turns, fractionBits);
}

std::optional<int> fractionBitsFrom(std::uint32_t factor, std::uint32_t stepsPerTurn,
                                    std::uint32_t measuringRange)
{
    if (factor == 0 || (factor & signBit) != 0)
        return std::nullopt;
    std::vector<int> bySteps;
    std::vector<int> byBoth;
    for (int bits = fewestFractionBits; bits <= mostFractionBits; ++bits) {
        const double value = scalingFactor(factor, bits);
        if (!isScalingFactor(factor, bits) || !showsAs(value, discSteps, stepsPerTurn, bits))
            continue;
        bySteps.push_back(bits);
        if (showsAs(value, double{discSteps} * discTurns, measuringRange, bits))
            byBoth.push_back(bits);
    }
    const std::vector<int> &found = bySteps.size() == 1 ? bySteps : byBoth;
    if (found.size() != 1)
        return std::nullopt;
    return found.front();
}

} // namespace codewheel::esc
