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

std::optional<std::int64_t> totalRange(const DeviceDescription &device, const ParameterValues &values)
{
    if (tellsItsRange(device))
        return valueOf(values, Parameter::measuringRange);
    const std::int64_t steps = valueOf(values, Parameter::steps).value_or(0);
    const std::int64_t revolutions = valueOf(values, Parameter::revolutions).value_or(0);
    const std::int64_t total = totalRange(steps, turnsOf(device, values), revolutions);
    return total > 0 ? std::optional(total) : std::nullopt;
}

} // namespace codewheel
