// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/protocol_row.h"

#include "words/la66_word.h"

#include <algorithm>
#include <array>
#include <span>

namespace codewheel {
namespace {

using enum esc::Command;

constexpr std::array services{
    ProtocolRow{Parameter::direction, la66::countingDirection, la66::countingDirection},
    ProtocolRow{Parameter::measuringLength, la66::measuringLength, la66::measuringLength},
    ProtocolRow{Parameter::externalPreset, la66::externalPreset, la66::externalPreset},
    ProtocolRow{Parameter::errorStatus, {}, la66::errorStatus},
};

constexpr unsigned directionBit = 0; // of the operating parameters
constexpr unsigned scalingBit = 2;

constexpr ProtocolRow commands(Parameter parameter, std::optional<esc::Command> read,
                               std::optional<esc::Command> write = {}, std::optional<unsigned> bit = {})
{
    return {.parameter = parameter, .readCommand = read, .readBit = bit, .writeCommand = write};
}

constexpr std::array serialCommands{
    commands(Parameter::steps, stepsPerTurn, writeStepsPerTurn),
    commands(Parameter::revolutions, revolutions, writeRevolutions),
    commands(Parameter::measuringRange, measuringRange, writeMeasuringRange),
    commands(Parameter::scalingFactor, scalingFactor, writeScalingFactor),
    commands(Parameter::scaling, operatingParameters, writeScaling, scalingBit),
    commands(Parameter::direction, operatingParameters, writeDirection, directionBit),
    commands(Parameter::lowerLimit, lowerLimit, writeLowerLimit),
    commands(Parameter::upperLimit, upperLimit, writeUpperLimit),
    commands(Parameter::lineAddress, {}, writeAddress),
    commands(Parameter::baudRate, {}, writeBaudRate),
    commands(Parameter::preset, preset), // writePreset moves the position
    commands(Parameter::offset, offset),
    commands(Parameter::serialNumber, serialNumber),
    commands(Parameter::operatingTime, operatingTime),
    commands(Parameter::operatingParameters, operatingParameters),
    commands(Parameter::alarms, alarms),
    commands(Parameter::warnings, warnings),
    commands(Parameter::deviceCode, deviceCode),
};

std::span<const ProtocolRow> rowsOf(Profile profile)
{
    if (profile == Profile::la66)
        return services;
    return profile == Profile::esc ? std::span<const ProtocolRow>(serialCommands)
                                   : std::span<const ProtocolRow>();
}

} // namespace

ProtocolRow protocolRow(Profile profile, Parameter parameter)
{
    const auto rows = rowsOf(profile);
    const auto found = std::ranges::find(rows, parameter, &ProtocolRow::parameter);
    return found == rows.end() ? ProtocolRow{.parameter = parameter} : *found;
}

} // namespace codewheel
