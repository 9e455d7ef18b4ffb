// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_command.h"

#include "kinds/esc/protocol/esc_scaling.h"
#include "vocabulary/enumeration_rows.h"

#include <algorithm>
#include <array>

namespace codewheel::esc {
namespace {

constexpr std::uint32_t all16 = 0xFFFF;
constexpr std::uint32_t all32 = 0xFFFF'FFFF;
constexpr std::uint32_t disc = 33'554'432; // steps on the code disc over all turns
constexpr std::uint32_t mostFactor = std::uint32_t{1} << mostFractionBits; // 1.0

constexpr std::array commandShapes{
    // The answers of reads. Bits, device numbers and times may be anything.
    CommandShape{Command::operatingParameters, "O", false, 4, 0, all16},
    CommandShape{Command::version, "V", false, 0, 0, 0},
    CommandShape{Command::measuringRange, "M", false, 8, 1, disc},
    CommandShape{Command::stepsPerTurn, "D", false, 4, 1, 8192},
    CommandShape{Command::preset, "S", false, 8, 1, disc - 1},
    CommandShape{Command::alarms, "A", false, 4, 0, all16},
    CommandShape{Command::warnings, "E", false, 4, 0, all16},
    CommandShape{Command::operatingTime, "T", false, 8, 0, all32},
    CommandShape{Command::offset, "C", false, 8, 0, all32},
    CommandShape{Command::serialNumber, "N", false, 8, 0, all32},
    CommandShape{Command::upperLimit, "H", false, 8, 1, disc},
    CommandShape{Command::lowerLimit, "L", false, 8, 1, disc},
    CommandShape{Command::scalingFactor, "F", false, 8, 1, mostFactor},
    CommandShape{Command::deviceCode, "B", false, 4, 0x8000, 0xA000},
    CommandShape{Command::revolutions, "U", false, 4, 1, 4096},
    // The table starts at 1; the SET input makes the position 0 (manual 1).
    CommandShape{Command::position, "P", false, 8, 0, disc},
    // The data of writes.
    CommandShape{Command::writePreset, "GP", true, 8, 1, disc - 1},
    CommandShape{Command::writeStepsPerTurn, "GR", true, 8, 1, 8192},
    CommandShape{Command::writeRevolutions, "GM", true, 4, 1, 4096},
    CommandShape{Command::writeMeasuringRange, "GT", true, 8, 1, disc - 1},
    CommandShape{Command::writeLowerLimit, "GL", true, 8, 1, disc - 1},
    CommandShape{Command::writeUpperLimit, "GH", true, 8, 1, disc - 1},
    CommandShape{Command::writeScalingFactor, "GF", true, 8, 1, mostFactor},
    CommandShape{Command::writeDirection, "GD", true, 1, 0, 1},
    CommandShape{Command::writeScaling, "GS", true, 1, 0, 1},
    CommandShape{Command::writeAddress, "X", true, 2, 1, 31},
    CommandShape{Command::writeBaudRate, "Y", true, 1, 0, 2},
};

static_assert(areInOrder(commandShapes, &CommandShape::command) &&
              commandShapes.size() == static_cast<std::size_t>(Command::writeBaudRate) + 1);

} // namespace

std::span<const CommandShape> allCommands()
{
    return commandShapes;
}

const CommandShape &shapeOf(Command command)
{
    return commandShapes.at(static_cast<std::size_t>(command));
}

std::optional<Command> commandOf(QByteArrayView letters)
{
    const std::string_view wanted(letters.data(), static_cast<std::size_t>(letters.size()));
    const auto row = std::ranges::find(commandShapes, wanted, &CommandShape::letters);
    if (row == commandShapes.end())
        return std::nullopt;
    return row->command;
}

} // namespace codewheel::esc
