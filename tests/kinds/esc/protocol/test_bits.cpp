// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_bits.h"

#include <gtest/gtest.h>

namespace codewheel::esc {
namespace {

struct BitCase
{
    Command command;
    int bit;
    const char *key;
    const char *text;
};

// Manual, "Warning Parameters", "Alarm Parameters", "Read Operating Parameters".
const BitCase bitCases[] = {
    {Command::operatingParameters, 0, "counterClockwise", "direction CCW"},
    {Command::operatingParameters, 1, "diagnosticActive", "diagnostic active"},
    {Command::operatingParameters, 2, "scalingOn", "scaling on"},
    {Command::operatingParameters, 12, "calculatedFactor", "calculated factor"},
    {Command::operatingParameters, 13, "resolutionPerTurn", "resolution per revolution"},
    {Command::operatingParameters, 14, "limitSwitchActive", "limit switch active"},
    {Command::alarms, 0, "positionError", "position error"},
    {Command::alarms, 12, "generalFault", "general fault"},
    {Command::alarms, 14, "batteryFlat", "battery flat"},
    {Command::alarms, 15, "temperatureExceeded", "temperature exceeded"},
    {Command::warnings, 0, "frequencyExceeded", "frequency exceeded"},
    {Command::warnings, 1, "lightControl", "light control"},
    {Command::warnings, 4, "batteryLimit", "battery limit reached"},
    {Command::warnings, 5, "referenceReached", "reference point reached"},
    {Command::warnings, 11, "turningCounterClockwise", "turning CCW"},
    {Command::warnings, 12, "lowerLimitReached", "lower limit switch on"},
    {Command::warnings, 13, "upperLimitReached", "upper limit switch on"},
    {Command::warnings, 14, "positionWarning", "position warning"},
    {Command::warnings, 15, "standstill", "standstill"},
};

TEST(EscBits, AreThoseOfTheManual)
{
    std::size_t described = 0;
    for (const CommandShape &shape : allCommands())
        described += bitsOf(shape.command).size();
    EXPECT_EQ(described, std::size(bitCases));
    for (const BitCase &row : bitCases) {
        SCOPED_TRACE(row.key);
        int found = 0;
        for (const BitRow &known : bitsOf(row.command)) {
            if (known.bit != row.bit)
                continue;
            ++found;
            EXPECT_STREQ(known.key, row.key);
            EXPECT_EQ(bitText(known.id, true), QString::fromLatin1(row.text));
        }
        EXPECT_EQ(found, 1);
    }
}

QString said(Command command, std::uint16_t value)
{
    return bitTexts(command, value).join(QStringLiteral(", "));
}

TEST(EscBits, OfTheManualsExamples)
{
    EXPECT_EQ(
        said(Command::operatingParameters, 0x7005),
        QStringLiteral(
            "limit switch active, resolution per revolution, calculated factor, scaling on, direction CCW"));
    EXPECT_EQ(said(Command::alarms, 0x4000), QStringLiteral("battery flat"));
    EXPECT_EQ(said(Command::alarms, 0x5000), QStringLiteral("battery flat, general fault"));
    EXPECT_EQ(said(Command::warnings, 0x9800),
              QStringLiteral("standstill, lower limit switch on, turning CCW"));
}

TEST(EscBits, OfTheExampleOfWarningsAreSwapped)
{
    EXPECT_EQ(swappedBytes(0x0098), 0x9800);
    EXPECT_EQ(swappedBytes(0x1234), 0x3412);
}

TEST(EscBits, ThatAreZeroSaySomethingOnlyWhereTheyDo)
{
    EXPECT_EQ(said(Command::operatingParameters, 0),
              QStringLiteral("total measuring range, scaling off, direction CW"));
    EXPECT_TRUE(bitTexts(Command::alarms, 0).isEmpty());
    EXPECT_TRUE(bitTexts(Command::warnings, 0).isEmpty());
}

TEST(EscBits, ThatNobodyDescribesAreNamed)
{
    EXPECT_EQ(said(Command::alarms, 0x2004), QStringLiteral("bit 13 (not described), bit 2 (not described)"));
    EXPECT_EQ(bitTexts(Command::alarms, 0xFFFF).size(), 16);
    EXPECT_TRUE(bitTexts(Command::position, 0xFFFF).isEmpty());
}

} // namespace
} // namespace codewheel::esc
