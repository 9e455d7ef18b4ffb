// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArrayView>

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

// The Kübler ESC protocol (manual "Multiturn Encoder versions with RS-422/485 Interface", ESC commands
// overview). All numbers on the wire are hexadecimal. No I/O: bytes and time come in as arguments.
namespace codewheel::esc {

enum class Command : std::uint8_t {
    operatingParameters, // O
    version,             // V
    measuringRange,      // M
    stepsPerTurn,        // D
    preset,              // S
    alarms,              // A
    warnings,            // E
    operatingTime,       // T
    offset,              // C
    serialNumber,        // N
    upperLimit,          // H
    lowerLimit,          // L
    scalingFactor,       // F
    deviceCode,          // B
    revolutions,         // U
    position,            // P
    writePreset,         // GP: the position becomes the preset value now
    writeStepsPerTurn,   // GR
    writeRevolutions,    // GM
    writeMeasuringRange, // GT
    writeLowerLimit,     // GL
    writeUpperLimit,     // GH
    writeScalingFactor,  // GF
    writeDirection,      // GD
    writeScaling,        // GS
    writeAddress,        // X
    writeBaudRate,       // Y: 0 = 19200, 1 = 9600, 2 = 4800
};

// One row of the manual's two tables.
struct CommandShape
{
    Command command = Command::position;
    std::string_view letters; // "P", "GP"
    bool writes = false;
    int digits = 0; // of the data of a write, or of the answer of a read; 0: text of 4 to 40 characters
    // Of the data of a write, or of the answer of a read, as the table states it. For the scaling factor the
    // widest possible: valueRange() of esc_scaling.h knows the format.
    std::uint32_t minimum = 0;
    std::uint32_t maximum = 0;
};

std::span<const CommandShape> allCommands();
const CommandShape &shapeOf(Command command);
std::optional<Command> commandOf(QByteArrayView letters);

} // namespace codewheel::esc
