// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel {

// What a simulated ESC encoder stores, as delivered, and the position derived from it. Everything is stored
// at once and survives a power cycle (assumed: the manual mentions no EEPROM).
struct EscRegisters
{
    static constexpr std::uint32_t physicalSteps = 8192;
    static constexpr std::uint32_t physicalRange = 33'554'432; // 8192 steps x 4096 revolutions

    explicit EscRegisters(int bits = 29)
        : fractionBits(bits)
        , factor(one())
    {}

    int fractionBits; // of the factor; the manual says "special format" (assumed: 29)

    std::uint32_t stepsPerTurn = physicalSteps;   // D, GR
    std::uint32_t revolutions = 4096;             // U, GM
    std::uint32_t measuringRange = physicalRange; // M, GT
    std::uint32_t preset = 1;                     // S, GP
    std::uint32_t offset = 0;                     // C
    std::uint32_t lowerLimit = 1;                 // L, GL
    std::uint32_t upperLimit = physicalRange - 1; // H, GH
    std::uint32_t factor;                         // F, GF
    bool countsCcw = false;                       // GD
    bool isScaled = false;                        // GS
    bool isPerTurn = true;            // GR set the resolution; false: GT set the total measuring range
    bool hasCalculatedFactor = false; // GF was sent since the last GR or GT

    // What GF made of measuringRange: until then, GR and GT show in D and M but change nothing else.
    std::uint32_t workingRange = physicalRange;

    std::uint32_t one() const { return 1U << fractionBits; }
    // 0.00001, the smallest the manual allows.
    std::uint32_t leastFactor() const { return one() / 100'000; }
    std::uint32_t range() const { return isScaled ? workingRange : physicalRange; }
    bool hasLimits() const { return lowerLimit != 1 || upperLimit != physicalRange - 1; }

    void setStepsPerTurn(std::uint32_t steps); // the revolutions become 4096 (manual, GR)
    void setRevolutions(std::uint32_t turns);
    void setMeasuringRange(std::uint32_t steps);
    void setFactor(std::uint32_t value);

    // 0..range() - 1. `raw` is the physical position; with `falls` the values decrease when the shaft turns
    // clockwise.
    std::uint32_t position(std::int64_t raw, bool falls) const;
    // The position at `raw` becomes `value`, below range().
    void setPosition(std::uint32_t value, std::int64_t raw, bool falls);
};

} // namespace codewheel
