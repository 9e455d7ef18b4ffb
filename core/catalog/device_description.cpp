// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/device_description.h"

#include "catalog/protocol_rules.h"

#include <QCoreApplication>

namespace codewheel {

bool ParameterDescription::takes(const Value &value) const
{
    if (isText())
        return value.isText() && value.toString().size() <= textLength;
    const auto number = value.asNumber();
    return choices.empty() ? number && *number >= minimum && *number <= maximum
                           : findChoice(value) != nullptr;
}

std::vector<Parameter> DeviceDescription::readableValues() const
{
    std::vector<Parameter> readable;
    for (const ParameterDescription &parameter : parameters)
        if (parameter.canBeRead && !parameter.isDetail)
            readable.push_back(parameter.parameter);
    return readable;
}

DeviceDescription DeviceDescription::labelled(int turns, int stepsPerTurn) const
{
    DeviceDescription device = *this;
    device.physicalTurns = turns > 0 ? turns : physicalTurns;
    device.physicalStepsPerTurn = stepsPerTurn > 0 ? stepsPerTurn : physicalStepsPerTurn;
    return device;
}

bool DeviceDescription::mayHaveModes() const
{
    return quirks.hasModes || (isGeneric() && protocolRules(profile).dependsOnMake());
}

QString DeviceDescription::fullName() const
{
    if (isGeneric())
        return QCoreApplication::translate("DeviceDescription", "%1, make not known").arg(name);
    return vendor + u' ' + name;
}

QString parameterName(const ParameterDescription &parameter)
{
    return parameter.name.isEmpty() ? parameterName(parameter.parameter) : parameter.name.toString();
}

QString parameterName(const DeviceDescription *device, Parameter parameter)
{
    const ParameterDescription *its = device != nullptr ? device->find(parameter) : nullptr;
    return its != nullptr ? parameterName(*its) : parameterName(parameter);
}

QString parameterNameInText(const DeviceDescription &device, Parameter parameter)
{
    const ParameterDescription *its = device.find(parameter);
    return its != nullptr && !its->name.isEmpty() ? its->name.toString() : parameterNameInText(parameter);
}

bool mayStorePreset(const DeviceDescription &device)
{
    return device.capabilities.presetIsStored ||
           (device.isGeneric() && protocolRules(device.profile).dependsOnMake());
}

} // namespace codewheel
