// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/encoder/parameter_text.h"

#include "catalog/value_text.h"
#include "cli/call/texts.h"
#include "vocabulary/sentence.h"

namespace codewheel {

QString typedValue(const ParameterDescription &parameter, const Value &value, const KindData &options)
{
    const Choice *choice = parameter.findChoice(value);
    return choice && choice->key != value.toString()
               ? QStringLiteral("%1 (%2)").arg(choice->key, value.toString())
               : valueText(parameter, value, options);
}

QString typedValue(const DeviceDescription *device, const ParameterValue &value)
{
    const ParameterDescription *parameter = device ? device->find(value.parameter) : nullptr;
    return parameter ? typedValue(*parameter, value.value) : plainText(value.value);
}

// Millimetres, or hexadecimal digits.
static bool isShownOtherwise(const ParameterDescription &parameter)
{
    return parameter.unit == Unit::micrometres || parameter.parameter == Parameter::scalingFactor ||
           parameter.parameter == Parameter::deviceCode;
}

QString rangeText(const ParameterDescription &parameter)
{
    if (parameter.isText())
        return textLimit(parameter);
    if (parameter.choices.empty() && isShownOtherwise(parameter))
        return QStringLiteral("%1..%2").arg(valueText(parameter, parameter.minimum),
                                            valueText(parameter, parameter.maximum));
    if (parameter.choices.empty())
        return QStringLiteral("%1..%2").arg(parameter.minimum).arg(parameter.maximum);
    return listed(parameter.choices,
                  [&](const Choice &choice) { return typedValue(parameter, choice.value); });
}

} // namespace codewheel
