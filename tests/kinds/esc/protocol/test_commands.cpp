// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_scaling.h"

#include <gtest/gtest.h>

namespace codewheel::esc {
namespace {

struct CommandRow
{
    const char *letters;
    Command command;
    bool writes;
    int digits;
    std::uint32_t minimum;
    std::uint32_t maximum;
};

// Manual, "ESC-Commands Overview".
constexpr CommandRow commandRows[] = {
    {"O", Command::operatingParameters, false, 4, 0, 0xFFFF},
    {"V", Command::version, false, 0, 0, 0},
    {"M", Command::measuringRange, false, 8, 1, 33'554'432},
    {"D", Command::stepsPerTurn, false, 4, 1, 8'192},
    {"S", Command::preset, false, 8, 1, 33'554'431},
    {"A", Command::alarms, false, 4, 0, 0xFFFF},
    {"E", Command::warnings, false, 4, 0, 0xFFFF},
    {"T", Command::operatingTime, false, 8, 0, 0xFFFF'FFFF},
    {"C", Command::offset, false, 8, 0, 0xFFFF'FFFF},
    {"N", Command::serialNumber, false, 8, 0, 0xFFFF'FFFF},
    {"H", Command::upperLimit, false, 8, 1, 33'554'432},
    {"L", Command::lowerLimit, false, 8, 1, 33'554'432},
    {"F", Command::scalingFactor, false, 8, 1, 0x4000'0000},
    {"B", Command::deviceCode, false, 4, 0x8000, 0xA000},
    {"U", Command::revolutions, false, 4, 1, 4'096},
    {"P", Command::position, false, 8, 0, 33'554'432},
    {"GP", Command::writePreset, true, 8, 1, 33'554'431},
    {"GR", Command::writeStepsPerTurn, true, 8, 1, 8'192},
    {"GM", Command::writeRevolutions, true, 4, 1, 4'096},
    {"GT", Command::writeMeasuringRange, true, 8, 1, 33'554'431},
    {"GL", Command::writeLowerLimit, true, 8, 1, 33'554'431},
    {"GH", Command::writeUpperLimit, true, 8, 1, 33'554'431},
    {"GF", Command::writeScalingFactor, true, 8, 1, 0x4000'0000},
    {"GD", Command::writeDirection, true, 1, 0, 1},
    {"GS", Command::writeScaling, true, 1, 0, 1},
    {"X", Command::writeAddress, true, 2, 1, 31},
    {"Y", Command::writeBaudRate, true, 1, 0, 2},
};

TEST(EscCommands, AreThoseOfBothTables)
{
    EXPECT_EQ(allCommands().size(), std::size(commandRows));
    for (const CommandRow &row : commandRows) {
        SCOPED_TRACE(row.letters);
        EXPECT_EQ(commandOf(row.letters), row.command);
        const CommandShape &shape = shapeOf(row.command);
        EXPECT_EQ(shape.command, row.command);
        EXPECT_EQ(shape.letters, row.letters);
        EXPECT_EQ(shape.writes, row.writes);
        EXPECT_EQ(shape.digits, row.digits);
        EXPECT_EQ(shape.minimum, row.minimum);
        EXPECT_EQ(shape.maximum, row.maximum);
    }
}

// 0.00001 to 1.0 (manual, read command F), whatever the line's format.
TEST(EscCommands, TheLimitsOfTheScalingFactorFollowFromItsFormat)
{
    for (const Command factor : {Command::scalingFactor, Command::writeScalingFactor}) {
        EXPECT_EQ(valueRange(factor), (ValueRange{0x14F9, 0x2000'0000}));
        EXPECT_EQ(valueRange(factor, 29), (ValueRange{0x14F9, 0x2000'0000}));
        EXPECT_EQ(valueRange(factor, 30), (ValueRange{0x29F1, 0x4000'0000}));
        EXPECT_EQ(valueRange(factor, 17), (ValueRange{1, 0x2'0000}));
        EXPECT_FALSE(valueRange(factor, 31).holds(0x2000'0000));
    }
    EXPECT_EQ(valueRange(Command::deviceCode, 30), (ValueRange{0x8000, 0xA000}));
}

TEST(EscCommands, NothingElseIsOne)
{
    for (const char *letters : {"", "G", "g", "p", "Q", "GPP", "PG", "GO", "0", "X1"})
        EXPECT_EQ(commandOf(letters), std::nullopt) << letters;
}

} // namespace
} // namespace codewheel::esc
