// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/parameter.h"

#include "vocabulary/enumeration_rows.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

struct ParameterRow
{
    Parameter parameter;
    const char *key;
    const char *name;
    const char *nameInText;
};

constexpr std::array parameterRows{
    ParameterRow{Parameter::steps, "steps", QT_TRANSLATE_NOOP("Parameter", "Steps"),
                 QT_TRANSLATE_NOOP("Parameter", "steps")},
    ParameterRow{Parameter::revolutions, "revolutions", QT_TRANSLATE_NOOP("Parameter", "Revolutions"),
                 QT_TRANSLATE_NOOP("Parameter", "revolutions")},
    ParameterRow{Parameter::direction, "direction", QT_TRANSLATE_NOOP("Parameter", "Direction"),
                 QT_TRANSLATE_NOOP("Parameter", "direction")},
    ParameterRow{Parameter::coding, "coding", QT_TRANSLATE_NOOP("Parameter", "Coding"),
                 QT_TRANSLATE_NOOP("Parameter", "coding")},
    ParameterRow{Parameter::preset, "preset", QT_TRANSLATE_NOOP("Parameter", "Preset"),
                 QT_TRANSLATE_NOOP("Parameter", "preset")},
    ParameterRow{Parameter::zeroOffset, "zero-offset", QT_TRANSLATE_NOOP("Parameter", "Zero offset"),
                 QT_TRANSLATE_NOOP("Parameter", "zero offset")},
    ParameterRow{Parameter::offset, "offset", QT_TRANSLATE_NOOP("Parameter", "Offset"),
                 QT_TRANSLATE_NOOP("Parameter", "offset")},
    ParameterRow{Parameter::measuringRange, "measuring-range",
                 QT_TRANSLATE_NOOP("Parameter", "Measuring range"),
                 QT_TRANSLATE_NOOP("Parameter", "measuring range")},
    ParameterRow{Parameter::measuringLength, "measuring-length",
                 QT_TRANSLATE_NOOP("Parameter", "Measuring length in steps"),
                 QT_TRANSLATE_NOOP("Parameter", "measuring length in steps")},
    ParameterRow{Parameter::externalPreset, "external-preset",
                 QT_TRANSLATE_NOOP("Parameter", "External preset"),
                 QT_TRANSLATE_NOOP("Parameter", "external preset")},
    ParameterRow{Parameter::rodLength, "rod-length", QT_TRANSLATE_NOOP("Parameter", "Rod length"),
                 QT_TRANSLATE_NOOP("Parameter", "rod length")},
    ParameterRow{Parameter::lowerLimit, "lower-limit", QT_TRANSLATE_NOOP("Parameter", "Lower limit"),
                 QT_TRANSLATE_NOOP("Parameter", "lower limit")},
    ParameterRow{Parameter::upperLimit, "upper-limit", QT_TRANSLATE_NOOP("Parameter", "Upper limit"),
                 QT_TRANSLATE_NOOP("Parameter", "upper limit")},
    ParameterRow{Parameter::scaling, "scaling", QT_TRANSLATE_NOOP("Parameter", "Scaling"),
                 QT_TRANSLATE_NOOP("Parameter", "scaling")},
    ParameterRow{Parameter::scalingFactor, "scaling-factor", QT_TRANSLATE_NOOP("Parameter", "Scaling factor"),
                 QT_TRANSLATE_NOOP("Parameter", "scaling factor")},
    ParameterRow{Parameter::lineAddress, "address", QT_TRANSLATE_NOOP("Parameter", "Address"),
                 QT_TRANSLATE_NOOP("Parameter", "address")},
    ParameterRow{Parameter::baudRate, "baud-rate", QT_TRANSLATE_NOOP("Parameter", "Baud rate"),
                 QT_TRANSLATE_NOOP("Parameter", "baud rate")},
    ParameterRow{Parameter::serialNumber, "serial-number", QT_TRANSLATE_NOOP("Parameter", "Serial number"),
                 QT_TRANSLATE_NOOP("Parameter", "serial number")},
    ParameterRow{Parameter::presetFlag, "preset-flag", QT_TRANSLATE_NOOP("Parameter", "Preset flag"),
                 QT_TRANSLATE_NOOP("Parameter", "preset flag")},
    ParameterRow{Parameter::softwareVersion, "software-version",
                 QT_TRANSLATE_NOOP("Parameter", "Software version"),
                 QT_TRANSLATE_NOOP("Parameter", "software version")},
    ParameterRow{Parameter::operatingTime, "operating-time", QT_TRANSLATE_NOOP("Parameter", "Operating time"),
                 QT_TRANSLATE_NOOP("Parameter", "operating time")},
    ParameterRow{Parameter::startUpMode, "start-up-mode", QT_TRANSLATE_NOOP("Parameter", "Start-up mode"),
                 QT_TRANSLATE_NOOP("Parameter", "start-up mode")},
    ParameterRow{Parameter::multiTurnAndStepsMinusOne, "multi-turn-steps-minus-1",
                 QT_TRANSLATE_NOOP("Parameter", "Multi-turn and steps minus 1"),
                 QT_TRANSLATE_NOOP("Parameter", "multi-turn and steps minus 1")},
    ParameterRow{Parameter::temperature, "temperature", QT_TRANSLATE_NOOP("Parameter", "Temperature"),
                 QT_TRANSLATE_NOOP("Parameter", "temperature")},
    ParameterRow{Parameter::errorStatus, "error-status", QT_TRANSLATE_NOOP("Parameter", "Error status"),
                 QT_TRANSLATE_NOOP("Parameter", "error status")},
    ParameterRow{Parameter::operatingParameters, "operating-parameters",
                 QT_TRANSLATE_NOOP("Parameter", "Operating parameters"),
                 QT_TRANSLATE_NOOP("Parameter", "operating parameters")},
    ParameterRow{Parameter::alarms, "alarms", QT_TRANSLATE_NOOP("Parameter", "Alarms"),
                 QT_TRANSLATE_NOOP("Parameter", "alarms")},
    ParameterRow{Parameter::warnings, "warnings", QT_TRANSLATE_NOOP("Parameter", "Warnings"),
                 QT_TRANSLATE_NOOP("Parameter", "warnings")},
    ParameterRow{Parameter::deviceCode, "device-code", QT_TRANSLATE_NOOP("Parameter", "Device code"),
                 QT_TRANSLATE_NOOP("Parameter", "device code")},
    ParameterRow{opcRegister(0), "opc-register-0", QT_TRANSLATE_NOOP("Parameter", "OPC register 0"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register 0")},
    ParameterRow{opcRegister(1), "opc-register-1", QT_TRANSLATE_NOOP("Parameter", "OPC register 1"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register 1")},
    ParameterRow{opcRegister(2), "opc-register-2", QT_TRANSLATE_NOOP("Parameter", "OPC register 2"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register 2")},
    ParameterRow{opcRegister(3), "opc-register-3", QT_TRANSLATE_NOOP("Parameter", "OPC register 3"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register 3")},
    ParameterRow{opcRegister(4), "opc-register-4", QT_TRANSLATE_NOOP("Parameter", "OPC register 4"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register 4")},
    ParameterRow{opcRegister(5), "opc-register-5", QT_TRANSLATE_NOOP("Parameter", "OPC register 5"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register 5")},
    ParameterRow{opcRegister(6), "opc-register-6", QT_TRANSLATE_NOOP("Parameter", "OPC register 6"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register 6")},
    ParameterRow{opcRegister(7), "opc-register-7", QT_TRANSLATE_NOOP("Parameter", "OPC register 7"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register 7")},
    ParameterRow{opcRegister(8), "opc-register-8", QT_TRANSLATE_NOOP("Parameter", "OPC register 8"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register 8")},
    ParameterRow{opcRegister(9), "opc-register-9", QT_TRANSLATE_NOOP("Parameter", "OPC register 9"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register 9")},
    ParameterRow{opcRegister(10), "opc-register-10", QT_TRANSLATE_NOOP("Parameter", "OPC register A"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register A")},
    ParameterRow{opcRegister(11), "opc-register-11", QT_TRANSLATE_NOOP("Parameter", "OPC register B"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register B")},
    ParameterRow{opcRegister(12), "opc-register-12", QT_TRANSLATE_NOOP("Parameter", "OPC register C"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register C")},
    ParameterRow{opcRegister(13), "opc-register-13", QT_TRANSLATE_NOOP("Parameter", "OPC register D"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register D")},
    ParameterRow{opcRegister(14), "opc-register-14", QT_TRANSLATE_NOOP("Parameter", "OPC register E"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register E")},
    ParameterRow{opcRegister(15), "opc-register-15", QT_TRANSLATE_NOOP("Parameter", "OPC register F"),
                 QT_TRANSLATE_NOOP("Parameter", "OPC register F")},
};

constexpr auto parameters = [] {
    std::array<Parameter, parameterRows.size()> all{};
    std::transform(parameterRows.begin(), parameterRows.end(), all.begin(),
                   [](const ParameterRow &row) { return row.parameter; });
    return all;
}();

static_assert(areInOrder(parameterRows, &ParameterRow::parameter));

const ParameterRow &parameterRow(Parameter parameter)
{
    return parameterRows.at(static_cast<std::size_t>(parameter));
}

} // namespace

QString parameterKey(Parameter parameter)
{
    return QString::fromLatin1(parameterRow(parameter).key);
}

std::optional<Parameter> parameterFromKey(QStringView key)
{
    for (const ParameterRow &row : parameterRows)
        if (key == QLatin1String(row.key))
            return row.parameter;
    return std::nullopt;
}

std::span<const Parameter> allParameters()
{
    return parameters;
}

QString parameterName(Parameter parameter)
{
    return QCoreApplication::translate("Parameter", parameterRow(parameter).name);
}

QString parameterNameInText(Parameter parameter)
{
    return QCoreApplication::translate("Parameter", parameterRow(parameter).nameInText);
}

void replaceValue(ParameterValues &values, ParameterValue value)
{
    std::erase_if(values, [&](const ParameterValue &other) { return other.parameter == value.parameter; });
    values.push_back(value);
}

std::optional<std::int64_t> valueOf(const ParameterValues &values, Parameter parameter)
{
    const auto found = std::ranges::find(values, parameter, &ParameterValue::parameter);
    return found == values.end() ? std::nullopt : std::optional(found->value);
}

} // namespace codewheel
