// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/driver/esc_values.h"

#include "catalog/value_text.h"
#include "kinds/esc/protocol/esc_bits.h"
#include "kinds/esc/protocol/esc_forms.h"
#include "kinds/esc/protocol/esc_reach.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

// By their numbers on the wire (manual, command Y).
constexpr std::array<std::int64_t, 3> baudRates{19200, 9600, 4800};

// The factor that goes with it is 0.00001 to 1.0 of the physical steps (manual, read command F).
void narrowToFactor(const DeviceDescription &device, std::optional<std::int64_t> turns,
                    ParameterDescription &range)
{
    constexpr std::int64_t leastPart = 100'000;
    const std::int64_t steps = turns.value_or(device.physicalTurns) * device.physicalStepsPerTurn;
    if (steps < range.minimum)
        return;
    range.minimum = std::max(range.minimum, (steps + leastPart - 1) / leastPart);
    range.maximum = std::min(range.maximum, steps);
}

} // namespace

std::optional<esc::Command> escReadCommand(const ParameterDescription &parameter)
{
    return esc::commandOf(escReach(parameter).read);
}

std::optional<esc::Command> escWriteCommand(const ParameterDescription &parameter)
{
    return esc::commandOf(escReach(parameter).write);
}

std::uint32_t escData(const ParameterDescription &parameter, std::int64_t value)
{
    if (parameter.parameter != Parameter::baudRate)
        return static_cast<std::uint32_t>(value);
    const auto found = std::ranges::find(baudRates, value);
    return static_cast<std::uint32_t>(std::distance(baudRates.begin(), found));
}

std::int64_t escValue(const ParameterDescription &parameter, std::uint32_t answer, bool swapWarningBytes)
{
    if (const auto bit = escReach(parameter).bit)
        return (answer >> *bit) & 1U;
    if (swapWarningBytes && escReadCommand(parameter) == esc::Command::warnings)
        return esc::swappedBytes(static_cast<std::uint16_t>(answer));
    return answer;
}

ParameterDescription escNarrowed(const DeviceDescription &device, Parameter parameter,
                                 const ParameterValues &known, int fractionBits)
{
    const ParameterDescription *found = device.find(parameter);
    ParameterDescription narrowed;
    if (found != nullptr)
        narrowed = *found;
    narrowed.parameter = parameter;
    narrowed = withOptions(std::move(narrowed), KindData(EscValueOptions{.fractionBits = fractionBits}));
    const auto atMost = [&](std::optional<std::int64_t> bound) {
        if (bound && *bound >= narrowed.minimum)
            narrowed.maximum = std::min(narrowed.maximum, *bound);
    };
    const bool isPosition = parameter == Parameter::preset || parameter == Parameter::lowerLimit ||
                            parameter == Parameter::upperLimit;
    if (isPosition && valueOf(known, Parameter::scaling) == 1)
        atMost(valueOf(known, Parameter::measuringRange));
    if (parameter == Parameter::measuringRange)
        narrowToFactor(device, valueOf(known, Parameter::revolutions), narrowed);
    return narrowed;
}

std::int64_t escTurnsOf(const ParameterValues &values, const ParameterValues &known)
{
    if (const auto wanted = valueOf(values, Parameter::revolutions))
        return *wanted;
    if (const auto along = valueOf(escSetAlong(values, known), Parameter::revolutions))
        return *along;
    return valueOf(known, Parameter::revolutions).value_or(esc::discTurns);
}

ParameterValues escSetAlong(const ParameterValues &values, const ParameterValues &known)
{
    constexpr std::int64_t turns = esc::discTurns;
    if (!valueOf(values, Parameter::steps) || valueOf(values, Parameter::revolutions) ||
        valueOf(known, Parameter::revolutions) == turns)
        return {};
    return {{Parameter::revolutions, turns}};
}

// The measuring range gives it more precisely than steps per turn.
std::optional<std::int64_t> escScalingFactorFor(const ParameterValues &values, const ParameterValues &known,
                                                int fractionBits)
{
    if (const auto range = valueOf(values, Parameter::measuringRange))
        return esc::factorForRange(static_cast<std::uint32_t>(*range),
                                   static_cast<std::uint32_t>(escTurnsOf(values, known)), fractionBits);
    if (const auto steps = valueOf(values, Parameter::steps))
        return esc::factorForSteps(static_cast<std::uint32_t>(*steps), fractionBits);
    return std::nullopt;
}

std::vector<EscLineAddress> escReadingsOf(EscLineAddress sent)
{
    std::vector<EscLineAddress> readings{sent};
    bool isDecimal = false;
    const unsigned decimal = sent.onWire().toUInt(&isDecimal, 10);
    if (isDecimal && decimal != sent.value && decimal <= EscLineAddress::last)
        readings.push_back({static_cast<std::uint8_t>(decimal)});
    return readings;
}

} // namespace codewheel
