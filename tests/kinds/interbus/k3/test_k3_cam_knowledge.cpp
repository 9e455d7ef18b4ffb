// SPDX-License-Identifier: GPL-3.0-or-later
// Cam words that no job has sent teach just as much: what is known of the programs follows the wire.
#include "kinds/interbus/k3/k3_knowledge.h"
#include "tests/kinds/interbus/words/driver_table.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class CamWire : public testing::Test
{
protected:
    const Catalog catalog = Catalog::builtIn();
    K3Knowledge fraba{*catalog.find(u"fraba-ocd-ib")};

    void play(const std::vector<Row> &rows)
    {
        for (const Row &row : rows)
            fraba.observe(row.in, row.out, Instant{1});
    }
    void enter(Word program)
    {
        play({{0x0000'0000, pos}, {0x2080'0000 | program, pos}, {0x2080'0000 | program, pos}});
        play({{0x2080'0000 | program, posInCamMode}, {0x0000'0000, posInCamMode}});
    }
    void readOut(Word what, Word value)
    {
        play({{0x2020'0000 | what, posInCamMode},
              {0x2020'0000 | what, 0xA000'0000 | value},
              {0x0000'0000, posInCamMode}});
    }
    void readAll(Word value)
    {
        readOut(0x00, 0x81);
        readOut(0x40, 5);
        for (Word cam = 0; cam < 8; ++cam) {
            readOut(0x10 | cam, value + cam);
            readOut(0x20 | cam, value + cam + 100);
        }
    }
    void setCam3()
    {
        play({{0x4600'0015, posInCamMode},
              {0x4600'0015, 0xC600'0015},
              {0x8000'0000, 0xC600'0015},
              {0x8000'0000, posInCamMode}});
    }
    std::optional<std::int64_t> startOfCam3(unsigned program)
    {
        const auto known = fraba.cams(program);
        return known ? std::optional(known->program.cam[3].start) : std::nullopt;
    }
};

TEST_F(CamWire, AProgramIsKnownOnceAllOfItWasRead)
{
    enter(2);
    readAll(1000);
    const auto known = fraba.cams(2);
    ASSERT_TRUE(known);
    EXPECT_EQ(known->evidence, Evidence::read);
    EXPECT_EQ(known->program.number, 2u);
    EXPECT_EQ(known->program.shift, 5u);
    EXPECT_EQ(known->program.cam[0], (Cam{1000, 1100, true}));
    EXPECT_EQ(known->program.cam[6], (Cam{1006, 1106, false}));
    EXPECT_EQ(known->program.cam[7], (Cam{1007, 1107, true}));
    EXPECT_FALSE(fraba.cams(1));
}

TEST_F(CamWire, AnAcknowledgementTeachesAndIsToldAsSuch)
{
    enter(1);
    readAll(1000);
    setCam3();
    EXPECT_EQ(startOfCam3(1), 0x15);
    EXPECT_EQ(fraba.cams(1)->evidence, Evidence::echoed);
    readOut(0x13, 0x15);
    EXPECT_EQ(fraba.cams(1)->evidence, Evidence::read);
}

// FRABA manual 10.6: the old value is kept
TEST_F(CamWire, ARefusedWordTeachesNothing)
{
    enter(1);
    readAll(1000);
    play({{0x47FF'FFFF, posInCamMode},
          {0x47FF'FFFF, 0x9800'0004},
          {0x8000'0000, 0x9800'0004},
          {0x8000'0000, posInCamMode}});
    EXPECT_EQ(startOfCam3(1), 1003);
    enter(2);
    EXPECT_EQ(fraba.eepromWrites(), 0);
}

TEST_F(CamWire, LeavingAChangedProgramIsOneWriteHoweverManyValuesWereChanged)
{
    enter(1);
    setCam3();
    play({{0x2040'0008, posInCamMode},
          {0x2040'0008, 0xE040'0008},
          {0x8000'0000, 0xE040'0008},
          {0x8000'0000, posInCamMode}});
    EXPECT_EQ(fraba.eepromWrites(), 0);
    enter(2);
    EXPECT_EQ(fraba.eepromWrites(), 1);
    enter(1);
    EXPECT_EQ(fraba.eepromWrites(), 1) << "program 2 was not changed";
    play({{0x2080'0000, posInCamMode}, {0x2080'0000, posInCamMode}, {0x2080'0000, pos}});
    EXPECT_EQ(fraba.eepromWrites(), 1);
    EXPECT_EQ(fraba.mode(), Mode::position);
}

TEST_F(CamWire, PowerOffBeforeTheProgramIsLeftLosesTheChange)
{
    enter(1);
    readAll(1000);
    play({{0x4600'0015, posInCamMode},
          {0x4600'0015, 0xC600'0015},
          {0x4600'0015, 0x0000'0000},
          {0x0000'0000, posInCamMode}});
    EXPECT_EQ(startOfCam3(1), 1003) << "only power-off ends a cam parameterization without run";
    setCam3();
    play({{0x0000'0000, posInCamMode}, {0x0000'0000, 0x0000'0000}, {0x0000'0000, posInCamMode}});
    EXPECT_EQ(startOfCam3(1), std::nullopt) << "IN 00000000 may be an encoder without power";
}

TEST_F(CamWire, ASavedProgramStaysKnownOverPowerOff)
{
    enter(1);
    readAll(1000);
    setCam3();
    enter(2);
    play({{0x0000'0000, 0x0000'0000}, {0x0000'0000, posInCamMode}});
    EXPECT_EQ(startOfCam3(1), 0x15);
}

TEST_F(CamWire, WhereTheProgramIsNotKnownAnAcknowledgementMakesAllUnknown)
{
    enter(1);
    readAll(1000);
    play({{0x2080'0003, posInCamMode}, {0x0000'0000, posInCamMode}}); // may or may not have been taken
    EXPECT_EQ(fraba.mode(), std::nullopt);
    EXPECT_EQ(startOfCam3(1), 1003);
    setCam3();
    EXPECT_EQ(fraba.cams(1), std::nullopt);
}

TEST_F(CamWire, AWordWithdrawnBeforeItWasAnsweredMayHaveBeenTaken)
{
    enter(1);
    readAll(1000);
    play({{0x4600'0015, posInCamMode},
          {0x0000'0000, posInCamMode},
          {0x8000'0000, posInCamMode},
          {0x0000'0000, posInCamMode}});
    EXPECT_EQ(startOfCam3(1), std::nullopt);
    readOut(0x13, 0x15);
    EXPECT_EQ(startOfCam3(1), 0x15);
}

TEST_F(CamWire, ALateAcknowledgementIsTaken)
{
    enter(1);
    readAll(1000);
    play({{0x4600'0015, posInCamMode}, {0x0000'0000, posInCamMode}, {0x0000'0000, 0xC600'0015}});
    EXPECT_EQ(startOfCam3(1), 0x15);
}

TEST_F(CamWire, LostParametersTakeTheProgramsAlong)
{
    enter(1);
    readAll(1000);
    play({{0x0000'0000, 0x8600'0000}});
    EXPECT_EQ(fraba.cams(1), std::nullopt);
    EXPECT_EQ(fraba.mode(), std::nullopt);
}

// Zero is normal: all cams off, and the part of the position is 0.
TEST_F(CamWire, AnAcknowledgementAfterAZeroIsTaken)
{
    enter(1);
    readAll(1000);
    play({{0x4600'0015, posInCamMode}, {0x4600'0015, 0x0000'0000}, {0x4600'0015, 0xC600'0015}});
    play({{0x8000'0000, 0xC600'0015}, {0x8000'0000, posInCamMode}, {0x0000'0000, posInCamMode}});
    EXPECT_EQ(startOfCam3(1), 0x15);
    enter(2);
    EXPECT_EQ(fraba.eepromWrites(), 1);
}

TEST_F(CamWire, AChangeOfAProgramNobodyKnowsIsCountedWhenItIsLeft)
{
    play({{0x0000'0000, posInCamMode}});
    setCam3();
    EXPECT_EQ(fraba.eepromWrites(), 0);
    enter(2);
    EXPECT_EQ(fraba.eepromWrites(), 1);
}

TEST_F(CamWire, LostParametersEndVelocityModeToo)
{
    enter(1);
    play({{0x2080'0000, posInCamMode}, {0x2080'0000, posInCamMode}, {0x2080'0000, pos}, {0x0000'0000, pos}});
    play({{0x2040'0001, pos}, {0x2040'0001, pos}, {0x2040'0001, 0}, {0x0000'0000, 0}});
    ASSERT_EQ(fraba.mode(), Mode::velocity);
    play({{0x0000'0000, 0x8600'0000}});
    EXPECT_EQ(fraba.mode(), std::nullopt);
}

TEST_F(CamWire, APresetThatStandsInOutAtFirstWasSentByOthers)
{
    play({{0x4000'0000, pos}, {0x4000'0000, pos}, {0x0000'0000, pos}});
    EXPECT_EQ(fraba.eepromWrites(), 0);
}

// In position mode 46000015 is no cam word.
TEST_F(CamWire, InPositionModeNoWordTouchesThePrograms)
{
    enter(1);
    readAll(1000);
    play({{0x2080'0000, posInCamMode}, {0x2080'0000, posInCamMode}, {0x2080'0000, pos}, {0x0000'0000, pos}});
    play({{0x4600'0015, pos}, {0x4600'0015, 0x8400'0000}, {0x8000'0000, 0x8400'0000}, {0x8000'0000, pos}});
    EXPECT_EQ(startOfCam3(1), 1003);
    EXPECT_EQ(fraba.eepromWrites(), 0);
}

} // namespace
} // namespace codewheel
