// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/kept_values.h"

#include "catalog/protocol_rules.h"

#include <algorithm>

namespace codewheel {

bool keepsValues(const DeviceDescription &device)
{
    return std::ranges::any_of(
        device.parameters, [](const ParameterDescription &its) { return its.canBeWritten && its.stored; });
}

Kept keptOf(const DeviceDescription &device, Parameter parameter, Kept told)
{
    const ParameterDescription *its = device.find(parameter);
    if (its == nullptr || !its->canBeWritten || !protocolRules(device.profile).storesByStep())
        return Kept::byItself;
    if (!its->stored)
        return Kept::untilPowerOff;
    return told == Kept::byItself ? Kept::notKnown : told;
}

bool hasToBeStored(const DeviceDescription &device, const Known &known)
{
    const ParameterDescription *its = device.find(known.parameter);
    const Kept kept = keptOf(device, known.parameter, known.kept);
    return its != nullptr && its->stored && (kept == Kept::untilPowerOff || kept == Kept::notKnown);
}

} // namespace codewheel
