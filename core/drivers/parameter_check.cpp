// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/parameter_check.h"

#include "catalog/data_field.h"

#include <QStringList>

#include <set>

namespace codewheel {
namespace {

QString allowedTexts(const ParameterDescription &parameter)
{
    QStringList keys;
    for (const Choice &choice : parameter.choices)
        keys.append(choice.key);
    return keys.join(QStringLiteral(", "));
}

} // namespace

Result<void> checkToRead(const DeviceDescription &device, const std::vector<Parameter> &parameters)
{
    if (!device.capabilities.reads)
        return refuse(RefusalKind::notSupported, RefusalId::readingNotSupported, {device.fullName()});
    if (parameters.empty())
        return refuse(RefusalKind::badInput, RefusalId::nothingToDo);
    for (const Parameter parameter : parameters) {
        const ParameterDescription *description = device.find(parameter);
        if (description == nullptr || !description->canBeRead())
            return refuse(RefusalKind::badInput, RefusalId::parameterNotSupported,
                          {parameter, device.fullName()});
    }
    return {};
}

Result<void> checkToWrite(const DeviceDescription &device, const ParameterValues &values)
{
    if (!device.capabilities.writes)
        return refuse(RefusalKind::notSupported, RefusalId::writingNotSupported, {device.fullName()});
    std::set<Parameter> seen;
    for (const ParameterValue &value : values) {
        if (auto checked = checkValue(device, value); !checked)
            return checked;
        if (!seen.insert(value.parameter).second)
            return refuse(RefusalKind::badInput, RefusalId::parameterGivenTwice, {value.parameter});
    }
    return {};
}

Result<void> checkValue(const DeviceDescription &device, const ParameterValue &value)
{
    const ParameterDescription *parameter = device.find(value.parameter);
    if (parameter == nullptr)
        return refuse(RefusalKind::badInput, RefusalId::parameterNotSupported,
                      {value.parameter, device.fullName()});
    if (!parameter->canBeWritten())
        return refuse(RefusalKind::badInput, RefusalId::parameterReadOnly,
                      {value.parameter, device.fullName()});
    if (!parameter->choices.empty()) {
        if (parameter->findChoice(value.value) == nullptr)
            return refuse(RefusalKind::badInput, RefusalId::valueNotAllowed,
                          {value.parameter, QString::number(value.value), allowedTexts(*parameter)});
    } else if (value.value < parameter->minimum || value.value > parameter->maximum) {
        return refuse(RefusalKind::badInput, RefusalId::valueOutOfRange,
                      {value.parameter, value.value, parameter->minimum, parameter->maximum});
    }
    // Whatever the description says: the word would carry another value.
    if (value.value < 0 || value.value > largestData(device.profile))
        return refuse(RefusalKind::badInput, RefusalId::valueOutOfRange,
                      {value.parameter, value.value, std::int64_t{0}, largestData(device.profile)});
    return {};
}

} // namespace codewheel
