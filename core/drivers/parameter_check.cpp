// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/parameter_check.h"

#include "catalog/data_field.h"
#include "catalog/value_text.h"
#include "encoder/hex.h"

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

Result<void> checkToWrite(const DeviceDescription &device, const ParameterValues &values, int fractionBits)
{
    if (!device.capabilities.writes)
        return refuse(RefusalKind::notSupported, RefusalId::writingNotSupported, {device.fullName()});
    std::set<Parameter> seen;
    for (const ParameterValue &value : values) {
        if (auto checked = checkValue(device, value, fractionBits); !checked)
            return checked;
        if (!seen.insert(value.parameter).second)
            return refuse(RefusalKind::badInput, RefusalId::parameterGivenTwice, {value.parameter});
    }
    return {};
}

Result<void> checkRange(const ParameterDescription &parameter, std::int64_t value)
{
    if (value >= parameter.minimum && value <= parameter.maximum)
        return {};
    const auto asTyped = [&](std::int64_t number) {
        return parameter.parameter == Parameter::scalingFactor
                   ? RefusalArgument(hexWord(Word{static_cast<std::uint32_t>(number)}) + u'h')
                   : RefusalArgument(number);
    };
    return refuse(
        RefusalKind::badInput, RefusalId::valueOutOfRange,
        {parameter.parameter, asTyped(value), asTyped(parameter.minimum), asTyped(parameter.maximum)});
}

Result<void> checkValue(const DeviceDescription &device, const ParameterValue &value, int fractionBits)
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
    } else if (auto checked = checkRange(atFractionBits(*parameter, fractionBits), value.value); !checked) {
        return checked;
    }
    // Whatever the description says: the word would carry another value.
    if (value.value < 0 || value.value > largestData(device.profile))
        return refuse(RefusalKind::badInput, RefusalId::valueOutOfRange,
                      {value.parameter, value.value, std::int64_t{0}, largestData(device.profile)});
    return {};
}

} // namespace codewheel
