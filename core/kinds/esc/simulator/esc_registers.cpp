// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/simulator/esc_registers.h"

namespace codewheel {

void EscRegisters::setStepsPerTurn(std::uint32_t steps)
{
    stepsPerTurn = steps;
    revolutions = 4096;
    measuringRange = steps * revolutions;
    isPerTurn = true;
    hasCalculatedFactor = false;
}

// The manual does not say that it waits for GF: while the steps per revolution apply, it takes effect at
// once.
void EscRegisters::setRevolutions(std::uint32_t turns)
{
    revolutions = turns;
    if (!isPerTurn)
        return;
    measuringRange = stepsPerTurn * turns;
    if (hasCalculatedFactor)
        workingRange = measuringRange;
}

void EscRegisters::setMeasuringRange(std::uint32_t steps)
{
    measuringRange = steps;
    isPerTurn = false;
    hasCalculatedFactor = false;
}

void EscRegisters::setFactor(std::uint32_t value)
{
    factor = value;
    hasCalculatedFactor = true;
    workingRange = measuringRange;
}

std::uint32_t EscRegisters::position(std::int64_t raw, bool falls) const
{
    const auto steps = static_cast<std::uint64_t>(raw);
    const std::uint64_t scaled = isScaled ? steps * factor >> fractionBits : steps;
    const std::uint64_t counted = scaled % range();
    const std::uint64_t turned = falls ? range() - 1 - counted : counted;
    return static_cast<std::uint32_t>((turned + offset) % range());
}

void EscRegisters::setPosition(std::uint32_t value, std::int64_t raw, bool falls)
{
    offset = 0;
    offset = (value + range() - position(raw, falls)) % range();
}

} // namespace codewheel
