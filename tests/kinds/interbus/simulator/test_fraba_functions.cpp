// SPDX-License-Identifier: GPL-3.0-or-later
#include "handshake_rows.h"
#include "kinds/interbus/simulator/fraba_k3.h"

namespace codewheel {
namespace {

struct ReadOutRow
{
    Word out;
    Word in;
};

void expectReadOuts(FrabaK3 &encoder, const std::vector<ReadOutRow> &rows)
{
    for (const ReadOutRow &row : rows)
        EXPECT_EQ(hex8(send(encoder, {0x0000'0000, row.out})), hex8(row.in)) << hex8(row.out);
}

class FrabaFunctions : public testing::Test
{
protected:
    FrabaK3 m_encoder{thirteenPlusTwelve, 12'345, {.serialNumber = 4711, .operatingTime = 99}};
};

// FRABA manual 5.3, initialisation of the preset; 5.4.1: each preset can be activated once
TEST_F(FrabaFunctions, Manual541APresetIsActivatedOnce)
{
    send(m_encoder, {0x0800'0064, 0x8000'0000, 0x0000'0000});
    play(m_encoder, {
                        {0x0000'0000, pos},
                        {0x4000'0000, pos, 2},
                        {0x4000'0000, 0x0000'0064, 3},
                        {0x0000'0000, 0x0000'0064, 2},
                    });
    m_encoder.turnBy(5);
    play(m_encoder,
         {{0x4000'0000, 0x0000'0069, 4}, {0x0000'0000, 0x0000'0069}}); // a second edge does nothing
    send(m_encoder, {0x0800'0064, 0x8000'0000, 0x0000'0000});          // armed again
    play(m_encoder, {{0x4000'0000, 0x0000'0069, 2}, {0x4000'0000, 0x0000'0064}});
}

TEST_F(FrabaFunctions, APresetNeverProgrammedIsNotActivated)
{
    play(m_encoder, {{0x0000'0000, pos}, {0x4000'0000, pos, 5}});
}

TEST_F(FrabaFunctions, ThePresetIsNotInitialisedOutsideOperation)
{
    EXPECT_EQ(send(m_encoder, {0x0800'0064, 0x0000'0000, 0x4000'0000}), 0xC800'0064);
    // Run while D30 stays set: no new edge.
    EXPECT_EQ(send(m_encoder, {0xC000'0000, 0x4000'0000}), pos);
    EXPECT_EQ(send(m_encoder, {0x0000'0000, 0x4000'0000}), 0x0000'0064);
}

TEST_F(FrabaFunctions, TheFrabaPresetActsInEveryCycleInWhichItIsSeen)
{
    send(m_encoder, {0x0800'0064, 0x8000'0000, 0x0000'0000});
    const int before = m_encoder.eepromWrites();
    play(m_encoder, {{0x6000'0000, pos}, {0x0000'0000, 0x0000'0064, 3}});
    EXPECT_EQ(m_encoder.eepromWrites(), before + 1);
    m_encoder.turnBy(50);
    play(m_encoder, {{0x0000'0000, 0x0000'0096}, {0x6000'0000, 0x0000'0096}, {0x6000'0000, 0x0000'0064, 4}});
    EXPECT_EQ(m_encoder.eepromWrites(), before + 6);
}

// FRABA manual 10.2
TEST_F(FrabaFunctions, Manual102VelocityModeAtOnceAndKept)
{
    m_encoder.turnTo(0);
    m_encoder.setSpeed(-150);
    send(m_encoder, {0x2040'0001});
    play(m_encoder, {{0x2040'0001, 0x01FF'FF6A}, {0x0000'0000, 0x01FF'FF6A, 3}});
    m_encoder.setSpeed(1500.4);
    play(m_encoder, {{0x0000'0000, 0x0000'05DC, 3}});
    EXPECT_EQ(send(m_encoder, {0x2021'0009}), 0xA000'0002);
    send(m_encoder, {0x0000'0000, 0x0600'0004, 0x8000'0000}); // CCW
    play(m_encoder, {{0x0000'0000, 0x01FF'FA24, 3}});
    m_encoder.setPower(false);
    m_encoder.setPower(true);
    play(m_encoder, {{0x0000'0000, 0x01FF'FA24, 3}});
    m_encoder.setSpeed(0);
    m_encoder.turnTo(0);
    EXPECT_EQ(send(m_encoder, {0x2040'0000}), 0x01FF'FFFF);
}

TEST_F(FrabaFunctions, DefaultEndsTheVelocityMode)
{
    send(m_encoder, {0x2040'0001, 0x0000'0000, 0x0E00'0000, 0x8000'0000});
    play(m_encoder, {{0x0000'0000, pos}});
}

// FRABA manual 10.1: physical steps, 1 revolution, CW, preset and zero offset 0 (assumed)
TEST_F(FrabaFunctions, Manual101DefaultIsConfirmedAndActsAtRun)
{
    send(m_encoder,
         {0x0200'00FF, 0x0400'0002, 0x0600'0004, 0x0800'0064, 0x0A00'000A, 0x8000'0000, 0x0000'0000});
    const int before = m_encoder.eepromWrites();
    EXPECT_EQ(send(m_encoder, {0x0E00'0000}), 0xCE00'0000);
    EXPECT_EQ(send(m_encoder, {0x0000'0000, 0x2021'0001}), 0xA000'00FF) << "not before run";
    EXPECT_EQ(send(m_encoder, {0x0000'0000}), 0xCE00'0000);
    EXPECT_EQ(send(m_encoder, {0x8000'0000, 0x0000'0000}), pos);
    expectReadOuts(m_encoder, {
                                  {0x2021'0001, 0xA000'2000},
                                  {0x2021'0002, 0xA000'0001},
                                  {0x2021'0003, 0xA000'0003},
                                  {0x2021'0004, 0xA000'0000},
                                  {0x2021'0005, 0xA000'0000},
                                  {0x2021'0006, 0xA000'0000},
                                  {0x2021'0009, 0xA000'0001},
                              });
    EXPECT_EQ(m_encoder.eepromWrites(), before + 1);
    EXPECT_EQ(send(m_encoder, {0x0000'0000, 0x0E00'0001}), 0x8200'0000) << "its data are 0";
}

// FRABA manual 6: the code is valid up to 800 kHz
TEST_F(FrabaFunctions, ShowsNoPositionAbove800Kilohertz)
{
    m_encoder.setSpeed(5860);
    play(m_encoder, {{0x0000'0000, 0x8000'0000, 5}});
    m_encoder.setSpeed(0);
    m_encoder.turnTo(12'345);
    play(m_encoder, {{0x0000'0000, pos}}); // by itself
}

TEST_F(FrabaFunctions, Manual102ReadOutAnswersWithoutTheNumber)
{
    send(m_encoder,
         {0x0200'1000, 0x0400'0002, 0x0600'0004, 0x0800'0064, 0x0A00'000A, 0x8000'0000, 0x0000'0000});
    expectReadOuts(m_encoder, {
                                  {0x2021'0000, 0xA000'1267}, // serial number 4711
                                  {0x2021'0001, 0xA000'1000}, // steps
                                  {0x2021'0002, 0xA000'0002}, // revolutions
                                  {0x2021'0003, 0xA000'0004}, // complement
                                  {0x2021'0004, 0xA000'0064}, // preset
                                  {0x2021'0005, 0xA000'000A}, // zero point shifting
                                  {0x2021'0006, 0xA000'0001}, // preset flag: programmed
                                  {0x2021'0007, 0xA000'0103}, // software version
                                  {0x2021'0008, 0xA000'0063}, // operating time
                                  {0x2021'0009, 0xA000'0001}, // start-up mode: K3
                                  {0x2021'000A, 0xA000'0002}, // multi-turn, steps as they are
                                  {0x2021'000C, 0xA000'00F5}, // 24.5 degC
                                  {0x2021'000B, 0xA400'000B}, // unknown
                                  {0x2021'000E, 0xA400'000E},
                                  {0x2021'001C, 0xA400'001C},
                                  {0x2021'010D, 0xA400'010D},
                                  {0x2021'FFFF, 0xA400'FFFF},
                              });
}

TEST_F(FrabaFunctions, ReadOutStandsAsLongAsItIsAskedForAndShowsThePositionAgain)
{
    play(m_encoder, {
                        {0x0000'0000, pos},
                        {0x2021'0001, pos, 2},
                        {0x2021'0001, 0xA000'2000, 10},
                        {0x2021'0002, 0xA000'2000, 2},
                        {0x2021'0002, 0xA000'0001, 2},
                        {0x0000'0000, 0xA000'0001},
                        {0x0000'0000, pos, 3},
                    });
}

TEST_F(FrabaFunctions, ReadOutGivesTheConfirmationBack)
{
    play(m_encoder, {
                        {0x0200'00FF, pos, 2},
                        {0x0200'00FF, 0xC200'00FF, 3},
                        {0x2021'0001, 0xC200'00FF, 2},
                        {0x2021'0001, 0xA000'2000, 2}, // active, not pending
                        {0x0000'0000, 0xA000'2000},
                        {0x0000'0000, 0xC200'00FF, 2},
                    });
}

// "Read out stop" is any word with D16 = 0: parameter data may contain D16.
TEST_F(FrabaFunctions, AParameterWordWithD16DoesNotEndTheReadOut)
{
    play(m_encoder, {
                        {0x2021'0001, pos, 2},
                        {0x2021'0001, 0xA000'2000, 2},
                        {0x0401'0001, 0xA000'2000, 5},
                        {0x0400'0001, 0xA000'2000},
                        {0x0400'0001, pos},
                        {0x0400'0001, 0xC400'0001, 3},
                    });
}

TEST(FrabaPlates, StepsMinusOneExpectsAndReadsOutOneLess)
{
    FrabaK3 encoder({4096, 1}, 4095, {.stepsMinusOne = true});
    EXPECT_EQ(send(encoder, {0x2021'000A}), 0xA000'0001); // single turn, steps minus 1
    EXPECT_EQ(send(encoder, {0x0000'0000, 0x2021'0001}), 0xA000'0FFF);
    EXPECT_EQ(send(encoder, {0x0000'0000, 0x0200'00FE}), 0xC200'00FE);
    EXPECT_EQ(send(encoder, {0x8000'0000, 0x0000'0000}), 0x0000'00FE); // 255 steps: 0..254
    EXPECT_EQ(send(encoder, {0x2021'0001}), 0xA000'00FE);
    EXPECT_EQ(send(encoder, {0x0000'0000, 0x0200'0000, 0x8000'0000}), 0x0000'0000); // one step
    EXPECT_EQ(send(encoder, {0x03FF'FFFF}), 0x8200'0000);
}

// FRABA manual 10.2: 202100xDh, register x
TEST(FrabaPlates, TheRegistersOfTheBusChipAreReadOneByOne)
{
    FrabaPlate plate;
    plate.opcRegisters[3] = 0x1234;
    plate.opcRegisters[15] = 0xFFFF;
    FrabaK3 encoder(thirteenPlusTwelve, 12'345, plate);
    expectReadOuts(encoder, {
                                {0x2021'000D, 0xA000'0237},
                                {0x2021'001D, 0xA000'0000},
                                {0x2021'003D, 0xA000'1234},
                                {0x2021'00ED, 0xA000'0000},
                                {0x2021'00FD, 0xA000'FFFF},
                                {0x2021'010D, 0xA400'010D},
                            });
}

TEST(FrabaPlates, TemperatureIsSignedAndMayBeMissing)
{
    FrabaK3 cold(thirteenPlusTwelve, 0, {.temperature = -50});
    EXPECT_EQ(send(cold, {0x2021'000C}), 0xA000'FFCE);
    FrabaK3 without(thirteenPlusTwelve, 0, {.temperature = std::nullopt});
    EXPECT_EQ(send(without, {0x2021'000C}), 0xA400'000C);
}

TEST_F(FrabaFunctions, ParametersLostAreLeftByDefault)
{
    m_encoder.loseParameters();
    play(m_encoder, {{0x0000'0000, 0x8600'0000, 3}, {0x8000'0000, 0x8600'0000, 3}});
    EXPECT_EQ(send(m_encoder, {0x0000'0000, 0x0E00'0000}), 0xCE00'0000);
    EXPECT_EQ(send(m_encoder, {0x8000'0000}), pos);
}

TEST_F(FrabaFunctions, ParametersLostAreLeftByParametersOneToFour)
{
    m_encoder.loseParameters();
    EXPECT_EQ(send(m_encoder, {0x0200'00FF, 0x0400'0001, 0x0600'0003, 0x8000'0000}), 0x8600'0000);
    EXPECT_EQ(send(m_encoder, {0x0800'0000, 0x8000'0000}), 0x0000'0180);
}

} // namespace
} // namespace codewheel
