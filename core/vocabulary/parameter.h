// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace codewheel {

// The vocabulary of encoder parameters and read-only values, across all makes. Which of them a device has,
// with what number, range and unit, is in its description (catalog/).
enum class Parameter : std::uint8_t {
    steps,
    revolutions,
    direction,
    coding,
    preset,
    zeroOffset,
    offset,
    measuringRange,
    measuringLength, // of a rod, in steps
    externalPreset,  // applied by the preset input of the encoder
    rodLength,       // on the label of a rod; never on the wire
    lowerLimit,      // of the limit switch, steps
    upperLimit,
    scaling,       // 1: on
    scalingFactor, // the 32 bits as sent to the encoder
    lineAddress,   // 1..31
    baudRate,      // Bd
    // read only
    serialNumber,
    presetFlag,
    softwareVersion,
    operatingTime,
    startUpMode,
    multiTurnAndStepsMinusOne,
    temperature,
    errorStatus,
    operatingParameters, // bits
    alarms,              // bits
    warnings,            // bits
    deviceCode,
    opcRegister0, // registers of the INTERBUS chip, one after the other
    opcRegister15 = opcRegister0 + 15,
};

// Register 0..15 of the INTERBUS chip.
constexpr Parameter opcRegister(unsigned number)
{
    return static_cast<Parameter>(static_cast<unsigned>(Parameter::opcRegister0) + number);
}
constexpr bool isOpcRegister(Parameter parameter)
{
    return parameter >= Parameter::opcRegister0 && parameter <= Parameter::opcRegister15;
}

// The language-neutral name used at the command line, in JSON and in device descriptions: "steps",
// "zero-offset".
QString parameterKey(Parameter parameter);
std::optional<Parameter> parameterFromKey(QStringView key);
std::span<const Parameter> allParameters();

// The name in the user's language: "Steps", "Zero offset".
QString parameterName(Parameter parameter);
// The same in running text: "steps", "zero offset".
QString parameterNameInText(Parameter parameter);

struct ParameterValue
{
    Parameter parameter = Parameter::steps;
    std::int64_t value = 0; // as sent to the encoder, e.g. direction 3 = CW; steps never "minus 1"

    friend bool operator==(const ParameterValue &, const ParameterValue &) = default;
};
using ParameterValues = std::vector<ParameterValue>;

// Adds the value, replacing any other of the same parameter.
void replaceValue(ParameterValues &values, ParameterValue value);

std::optional<std::int64_t> valueOf(const ParameterValues &values, Parameter parameter);

} // namespace codewheel
