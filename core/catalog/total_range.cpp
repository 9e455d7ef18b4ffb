// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/total_range.h"

namespace codewheel {
namespace {

std::int64_t turnsOf(const DeviceDescription &device, const ParameterValues &values)
{
    if (device.find(Parameter::measuringRange) != nullptr)
        return valueOf(values, Parameter::measuringRange).value_or(0);
    return device.physicalTurns;
}

} // namespace

bool tellsItsRange(const DeviceDescription &device)
{
    const ParameterDescription *range = device.find(Parameter::measuringRange);
    return range != nullptr && range->unit == Unit::steps;
}

ScalingState scalingState(const DeviceDescription &device, std::optional<std::int64_t> scaling)
{
    if (device.find(Parameter::scaling) == nullptr)
        return ScalingState::on;
    if (!scaling)
        return ScalingState::unknown;
    return *scaling == 0 ? ScalingState::off : ScalingState::on;
}

std::int64_t physicalRange(const DeviceDescription &device)
{
    return std::int64_t{device.physicalStepsPerTurn} * device.physicalTurns;
}

std::optional<std::int64_t> totalRange(const DeviceDescription &device, const ParameterValues &values)
{
    const ScalingState state = scalingState(device, valueOf(values, Parameter::scaling));
    if (state == ScalingState::unknown)
        return std::nullopt;
    if (state == ScalingState::off)
        return physicalRange(device) > 0 ? std::optional(physicalRange(device)) : std::nullopt;
    if (tellsItsRange(device))
        return valueOf(values, Parameter::measuringRange);
    const std::int64_t steps = valueOf(values, Parameter::steps).value_or(0);
    const std::int64_t revolutions = valueOf(values, Parameter::revolutions).value_or(0);
    const std::int64_t total = totalRange(steps, turnsOf(device, values), revolutions);
    return total > 0 ? std::optional(total) : std::nullopt;
}

} // namespace codewheel
