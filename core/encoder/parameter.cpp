// SPDX-License-Identifier: GPL-3.0-or-later
#include "encoder/parameter.h"

#include "encoder/enumeration_rows.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

struct Row
{
    Parameter parameter;
    const char *key;
    const char *name;
    const char *nameInText;
};

constexpr std::array rows{
    Row{Parameter::steps, "steps", QT_TRANSLATE_NOOP("Parameter", "Steps"),
        QT_TRANSLATE_NOOP("Parameter", "steps")},
    Row{Parameter::revolutions, "revolutions", QT_TRANSLATE_NOOP("Parameter", "Revolutions"),
        QT_TRANSLATE_NOOP("Parameter", "revolutions")},
    Row{Parameter::direction, "direction", QT_TRANSLATE_NOOP("Parameter", "Direction"),
        QT_TRANSLATE_NOOP("Parameter", "direction")},
    Row{Parameter::coding, "coding", QT_TRANSLATE_NOOP("Parameter", "Coding"),
        QT_TRANSLATE_NOOP("Parameter", "coding")},
    Row{Parameter::preset, "preset", QT_TRANSLATE_NOOP("Parameter", "Preset"),
        QT_TRANSLATE_NOOP("Parameter", "preset")},
    Row{Parameter::zeroOffset, "zero-offset", QT_TRANSLATE_NOOP("Parameter", "Zero offset"),
        QT_TRANSLATE_NOOP("Parameter", "zero offset")},
    Row{Parameter::offset, "offset", QT_TRANSLATE_NOOP("Parameter", "Offset"),
        QT_TRANSLATE_NOOP("Parameter", "offset")},
    Row{Parameter::measuringRange, "measuring-range", QT_TRANSLATE_NOOP("Parameter", "Measuring range"),
        QT_TRANSLATE_NOOP("Parameter", "measuring range")},
    Row{Parameter::measuringLength, "measuring-length",
        QT_TRANSLATE_NOOP("Parameter", "Measuring length in steps"),
        QT_TRANSLATE_NOOP("Parameter", "measuring length in steps")},
    Row{Parameter::externalPreset, "external-preset", QT_TRANSLATE_NOOP("Parameter", "External preset"),
        QT_TRANSLATE_NOOP("Parameter", "external preset")},
    Row{Parameter::rodLength, "rod-length", QT_TRANSLATE_NOOP("Parameter", "Rod length"),
        QT_TRANSLATE_NOOP("Parameter", "rod length")},
    Row{Parameter::lowerLimit, "lower-limit", QT_TRANSLATE_NOOP("Parameter", "Lower limit"),
        QT_TRANSLATE_NOOP("Parameter", "lower limit")},
    Row{Parameter::upperLimit, "upper-limit", QT_TRANSLATE_NOOP("Parameter", "Upper limit"),
        QT_TRANSLATE_NOOP("Parameter", "upper limit")},
    Row{Parameter::scaling, "scaling", QT_TRANSLATE_NOOP("Parameter", "Scaling"),
        QT_TRANSLATE_NOOP("Parameter", "scaling")},
    Row{Parameter::scalingFactor, "scaling-factor", QT_TRANSLATE_NOOP("Parameter", "Scaling factor"),
        QT_TRANSLATE_NOOP("Parameter", "scaling factor")},
    Row{Parameter::lineAddress, "address", QT_TRANSLATE_NOOP("Parameter", "Address"),
        QT_TRANSLATE_NOOP("Parameter", "address")},
    Row{Parameter::baudRate, "baud-rate", QT_TRANSLATE_NOOP("Parameter", "Baud rate"),
        QT_TRANSLATE_NOOP("Parameter", "baud rate")},
    Row{Parameter::serialNumber, "serial-number", QT_TRANSLATE_NOOP("Parameter", "Serial number"),
        QT_TRANSLATE_NOOP("Parameter", "serial number")},
    Row{Parameter::presetFlag, "preset-flag", QT_TRANSLATE_NOOP("Parameter", "Preset flag"),
        QT_TRANSLATE_NOOP("Parameter", "preset flag")},
    Row{Parameter::softwareVersion, "software-version", QT_TRANSLATE_NOOP("Parameter", "Software version"),
        QT_TRANSLATE_NOOP("Parameter", "software version")},
    Row{Parameter::operatingTime, "operating-time", QT_TRANSLATE_NOOP("Parameter", "Operating time"),
        QT_TRANSLATE_NOOP("Parameter", "operating time")},
    Row{Parameter::startUpMode, "start-up-mode", QT_TRANSLATE_NOOP("Parameter", "Start-up mode"),
        QT_TRANSLATE_NOOP("Parameter", "start-up mode")},
    Row{Parameter::multiTurnAndStepsMinusOne, "multi-turn-steps-minus-1",
        QT_TRANSLATE_NOOP("Parameter", "Multi-turn and steps minus 1"),
        QT_TRANSLATE_NOOP("Parameter", "multi-turn and steps minus 1")},
    Row{Parameter::temperature, "temperature", QT_TRANSLATE_NOOP("Parameter", "Temperature"),
        QT_TRANSLATE_NOOP("Parameter", "temperature")},
    Row{Parameter::errorStatus, "error-status", QT_TRANSLATE_NOOP("Parameter", "Error status"),
        QT_TRANSLATE_NOOP("Parameter", "error status")},
    Row{Parameter::operatingParameters, "operating-parameters",
        QT_TRANSLATE_NOOP("Parameter", "Operating parameters"),
        QT_TRANSLATE_NOOP("Parameter", "operating parameters")},
    Row{Parameter::alarms, "alarms", QT_TRANSLATE_NOOP("Parameter", "Alarms"),
        QT_TRANSLATE_NOOP("Parameter", "alarms")},
    Row{Parameter::warnings, "warnings", QT_TRANSLATE_NOOP("Parameter", "Warnings"),
        QT_TRANSLATE_NOOP("Parameter", "warnings")},
    Row{Parameter::deviceCode, "device-code", QT_TRANSLATE_NOOP("Parameter", "Device code"),
        QT_TRANSLATE_NOOP("Parameter", "device code")},
    Row{opcRegister(0), "opc-register-0", QT_TRANSLATE_NOOP("Parameter", "OPC register 0"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register 0")},
    Row{opcRegister(1), "opc-register-1", QT_TRANSLATE_NOOP("Parameter", "OPC register 1"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register 1")},
    Row{opcRegister(2), "opc-register-2", QT_TRANSLATE_NOOP("Parameter", "OPC register 2"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register 2")},
    Row{opcRegister(3), "opc-register-3", QT_TRANSLATE_NOOP("Parameter", "OPC register 3"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register 3")},
    Row{opcRegister(4), "opc-register-4", QT_TRANSLATE_NOOP("Parameter", "OPC register 4"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register 4")},
    Row{opcRegister(5), "opc-register-5", QT_TRANSLATE_NOOP("Parameter", "OPC register 5"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register 5")},
    Row{opcRegister(6), "opc-register-6", QT_TRANSLATE_NOOP("Parameter", "OPC register 6"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register 6")},
    Row{opcRegister(7), "opc-register-7", QT_TRANSLATE_NOOP("Parameter", "OPC register 7"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register 7")},
    Row{opcRegister(8), "opc-register-8", QT_TRANSLATE_NOOP("Parameter", "OPC register 8"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register 8")},
    Row{opcRegister(9), "opc-register-9", QT_TRANSLATE_NOOP("Parameter", "OPC register 9"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register 9")},
    Row{opcRegister(10), "opc-register-10", QT_TRANSLATE_NOOP("Parameter", "OPC register A"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register A")},
    Row{opcRegister(11), "opc-register-11", QT_TRANSLATE_NOOP("Parameter", "OPC register B"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register B")},
    Row{opcRegister(12), "opc-register-12", QT_TRANSLATE_NOOP("Parameter", "OPC register C"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register C")},
    Row{opcRegister(13), "opc-register-13", QT_TRANSLATE_NOOP("Parameter", "OPC register D"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register D")},
    Row{opcRegister(14), "opc-register-14", QT_TRANSLATE_NOOP("Parameter", "OPC register E"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register E")},
    Row{opcRegister(15), "opc-register-15", QT_TRANSLATE_NOOP("Parameter", "OPC register F"),
        QT_TRANSLATE_NOOP("Parameter", "OPC register F")},
};

constexpr auto parameters = [] {
    std::array<Parameter, rows.size()> all{};
    std::transform(rows.begin(), rows.end(), all.begin(), [](const Row &row) { return row.parameter; });
    return all;
}();

static_assert(areInOrder(rows, &Row::parameter));

const Row &rowOf(Parameter parameter)
{
    return rows.at(static_cast<std::size_t>(parameter));
}

} // namespace

QString parameterKey(Parameter parameter)
{
    return QString::fromLatin1(rowOf(parameter).key);
}

std::optional<Parameter> parameterFromKey(QStringView key)
{
    for (const Row &row : rows)
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
    return QCoreApplication::translate("Parameter", rowOf(parameter).name);
}

QString parameterNameInText(Parameter parameter)
{
    return QCoreApplication::translate("Parameter", rowOf(parameter).nameInText);
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
