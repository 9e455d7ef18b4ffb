// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/la66/la66_encoder.h"
#include "tests/kinds/interbus/words/driver_table.h"

#include <gtest/gtest.h>

// What is learned from words that no job has sent: from a monitor, or from a job that was stopped.
namespace codewheel {
namespace {

class La66Knows : public testing::Test
{
protected:
    // IN in consecutive cycles, whatever is in OUT.
    void see(std::initializer_list<Word> in)
    {
        for (const Word word : in)
            table.play({{0x0000'0000, word}});
    }

    DriverTable table{La66Timing{}};
};

TEST_F(La66Knows, AWriteThatCameBackIsThereAndInEeprom)
{
    see({pos, 0xC200'C350, 0xC200'C350, pos});
    EXPECT_EQ(table.known(Parameter::measuringLength), 50'000);
    EXPECT_EQ(table.evidence(Parameter::measuringLength), Evidence::echoed);
    EXPECT_EQ(table.eepromWrites(), 1);
}

TEST_F(La66Knows, AReadTellsItsValueAndWritesNothing)
{
    see({pos, 0x8100'0001, pos, 0x84FF'FFFF, pos, 0x8800'0020, pos});
    EXPECT_EQ(table.known(Parameter::direction), 1);
    EXPECT_EQ(table.known(Parameter::externalPreset), 0xFF'FFFF);
    EXPECT_EQ(table.known(Parameter::errorStatus), 32);
    EXPECT_EQ(table.evidence(Parameter::errorStatus), Evidence::read);
    EXPECT_EQ(table.eepromWrites(), 0);
}

TEST_F(La66Knows, AnAdjustedPositionIsAWriteAndNoParameter)
{
    see({pos, 0xC600'03E8, 0x0000'03E8});
    EXPECT_EQ(table.eepromWrites(), 1);
    for (const Parameter parameter : allParameters())
        EXPECT_EQ(table.known(parameter), std::nullopt);
}

TEST_F(La66Knows, WhatWasRefusedIsNeitherThereNorCounted)
{
    see({pos, 0xE200'C350, pos, 0xA600'0000, pos, 0xE300'0001, pos});
    EXPECT_EQ(table.known(Parameter::measuringLength), std::nullopt);
    EXPECT_EQ(table.eepromWrites(), 0);
}

TEST_F(La66Knows, AnAnswerThatStandsAtTheBeginningIsNotOurs)
{
    see({0xC200'C350, 0xC200'C350, pos});
    EXPECT_EQ(table.known(Parameter::measuringLength), std::nullopt);
    EXPECT_EQ(table.eepromWrites(), 0);
}

TEST(La66Reading, NormalModeShowsThePosition)
{
    const Reading reading = decodeLa66(0x00FF'FFFF, Instant{7});
    EXPECT_EQ(reading.state, EncoderState::operation);
    EXPECT_EQ(reading.position, 16'777'215);
    EXPECT_EQ(reading.coding, PositionCoding::binary);
    EXPECT_EQ(reading.at, Instant{7});
}

TEST(La66Reading, ALostMagnetIsAnErrorThatKeepsThePosition)
{
    const Reading reading = decodeLa66(0x2000'3039, {});
    EXPECT_EQ(reading.state, EncoderState::error);
    EXPECT_EQ(reading.errorNumber, 5u) << "its bit of the error status";
    EXPECT_EQ(reading.position, 12'345);
}

TEST(La66Reading, ServiceModeAndUndefinedWordsShowNoPosition)
{
    for (const Word in : {0x8200'C350u, 0xE200'0000u, 0x8000'0000u})
        EXPECT_EQ(decodeLa66(in, {}).state, EncoderState::service) << std::hex << in;
    for (const Word in : {0x4000'0000u, 0x1000'0000u, 0x0100'0001u})
        EXPECT_EQ(decodeLa66(in, {}).state, EncoderState::unknown) << std::hex << in;
    for (const Word in : {0x8200'C350u, 0x0100'0001u})
        EXPECT_EQ(decodeLa66(in, {}).position, std::nullopt);
}

} // namespace
} // namespace codewheel
