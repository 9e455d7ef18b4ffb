// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/local_text.h"
#include "vocabulary/value.h"

#include <QString>

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

namespace codewheel {

// The name of a value of encoders. The ones below mean the same whatever the encoder, and views ask for them:
// a device has them wherever its protocol keeps them. What only some encoders have is named by its
// description
// ("opc-register-3"). Two are equal if their keys are. Which of them a device has, with what range and unit,
// and how it is reached, is in its description (catalog/).
class Parameter
{
public:
    static const Parameter steps;
    static const Parameter revolutions;
    static const Parameter direction;
    static const Parameter coding;
    static const Parameter preset;
    static const Parameter zeroOffset;
    static const Parameter offset;
    static const Parameter measuringRange;
    static const Parameter measuringLength; // of a rod, in steps
    static const Parameter externalPreset;  // applied by the preset input of the encoder
    static const Parameter rodLength;       // on the label of a rod; never on the wire
    static const Parameter lowerLimit;      // of the limit switch, steps
    static const Parameter upperLimit;
    static const Parameter scaling;       // 1: on
    static const Parameter scalingFactor; // the 32 bits as sent to the encoder
    static const Parameter lineAddress;   // 1..31
    static const Parameter baudRate;      // Bd
    static const Parameter serialNumber;  // read only from here on
    static const Parameter presetFlag;
    static const Parameter softwareVersion;
    static const Parameter operatingTime;
    static const Parameter startUpMode;
    static const Parameter multiTurnAndStepsMinusOne;
    static const Parameter temperature;
    static const Parameter errorStatus;
    static const Parameter operatingParameters; // bits
    static const Parameter alarms;              // bits
    static const Parameter warnings;            // bits
    static const Parameter deviceCode;

    // The one with this key: small letters, digits, '-', ':' and '.'. `name` is shown; where descriptions
    // give several names for a key, or none, the key is. From any thread.
    static Parameter of(QStringView key, const LocalText &name = {});

    friend constexpr bool operator==(Parameter, Parameter) = default;
    // As listed above, then by their keys, numbers in them by value.
    friend std::strong_ordering operator<=>(Parameter one, Parameter other);

private:
    friend struct ParameterRows;
    explicit constexpr Parameter(std::uint16_t id)
        : m_id(id)
    {}

    std::uint16_t m_id; // index of its row
};

inline constexpr Parameter Parameter::steps{0};
inline constexpr Parameter Parameter::revolutions{1};
inline constexpr Parameter Parameter::direction{2};
inline constexpr Parameter Parameter::coding{3};
inline constexpr Parameter Parameter::preset{4};
inline constexpr Parameter Parameter::zeroOffset{5};
inline constexpr Parameter Parameter::offset{6};
inline constexpr Parameter Parameter::measuringRange{7};
inline constexpr Parameter Parameter::measuringLength{8};
inline constexpr Parameter Parameter::externalPreset{9};
inline constexpr Parameter Parameter::rodLength{10};
inline constexpr Parameter Parameter::lowerLimit{11};
inline constexpr Parameter Parameter::upperLimit{12};
inline constexpr Parameter Parameter::scaling{13};
inline constexpr Parameter Parameter::scalingFactor{14};
inline constexpr Parameter Parameter::lineAddress{15};
inline constexpr Parameter Parameter::baudRate{16};
inline constexpr Parameter Parameter::serialNumber{17};
inline constexpr Parameter Parameter::presetFlag{18};
inline constexpr Parameter Parameter::softwareVersion{19};
inline constexpr Parameter Parameter::operatingTime{20};
inline constexpr Parameter Parameter::startUpMode{21};
inline constexpr Parameter Parameter::multiTurnAndStepsMinusOne{22};
inline constexpr Parameter Parameter::temperature{23};
inline constexpr Parameter Parameter::errorStatus{24};
inline constexpr Parameter Parameter::operatingParameters{25};
inline constexpr Parameter Parameter::alarms{26};
inline constexpr Parameter Parameter::warnings{27};
inline constexpr Parameter Parameter::deviceCode{28};

// The language-neutral name used at the command line, in JSON and in device descriptions: "steps",
// "zero-offset".
QString parameterKey(Parameter parameter);
// Only if a description has named it, or everybody knows it.
std::optional<Parameter> parameterFromKey(QStringView key);
// In their order, with what descriptions have named.
std::vector<Parameter> allParameters();
// Those that everybody knows.
std::vector<Parameter> commonParameters();

// The name in the user's language: "Steps", "Zero offset".
QString parameterName(Parameter parameter);
// The same in running text: "steps", "zero offset".
QString parameterNameInText(Parameter parameter);

struct ParameterValue
{
    Parameter parameter = Parameter::steps;
    Value value = 0; // as sent to the encoder, e.g. direction 3 = CW; steps never "minus 1"

    friend bool operator==(const ParameterValue &, const ParameterValue &) = default;
};
using ParameterValues = std::vector<ParameterValue>;

// Adds the value, replacing any other of the same parameter.
void replaceValue(ParameterValues &values, ParameterValue value);

std::optional<Value> findValue(const ParameterValues &values, Parameter parameter);
// Its number; empty also if it is a text.
std::optional<std::int64_t> valueOf(const ParameterValues &values, Parameter parameter);

} // namespace codewheel
