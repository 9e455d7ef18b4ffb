// SPDX-License-Identifier: GPL-3.0-or-later
#include "handshake_rows.h"
#include "kinds/interbus/simulator/baumer_k3.h"
#include "kinds/interbus/simulator/fraba_k3.h"

// Power and EEPROM of both makes.
namespace codewheel {
namespace {

class Power : public testing::Test
{
protected:
    FrabaK3 m_fraba{thirteenPlusTwelve, 12'345, {}};
    BaumerK3 m_baumer{thirteenPlusTwelve, 12'345};
};

TEST_F(Power, OffThereIsNothingInTheWord)
{
    m_fraba.setPower(false);
    play(m_fraba,
         {{0x0000'0000, 0x0000'0000, 3}, {0x0200'00FF, 0x0000'0000, 10}, {0x0000'0000, 0x0000'0000}});
    EXPECT_FALSE(m_fraba.isPowered());
    m_fraba.setPower(true);
    play(m_fraba, {{0x0000'0000, pos, 2}});
}

TEST_F(Power, PowerOffEndsTheReadOut)
{
    EXPECT_EQ(send(m_fraba, {0x2021'0001}), 0xA000'2000);
    m_fraba.powerCycle();
    play(m_fraba, {{0x2021'0001, 0x0000'0000, 50}, {0x2021'0001, pos, 2}, {0x2021'0001, 0xA000'2000}});
}

TEST_F(Power, APowerCycleComesBackByItself)
{
    m_fraba.powerCycle();
    play(m_fraba, {{0x0000'0000, 0x0000'0000, 50}, {0x0000'0000, pos, 2}});
}

TEST_F(Power, ThePendingSetIsDroppedAndTheActiveSetKept)
{
    send(m_fraba, {0x0200'00FF, 0x8000'0000, 0x0000'0000, 0x0600'0004});
    m_fraba.setPower(false);
    m_fraba.setPower(true);
    play(m_fraba, {{0x0000'0000, pos255, 3}});
}

TEST_F(Power, TheShaftTurnsOnWhileThePowerIsOff)
{
    m_fraba.setPower(false);
    m_fraba.turnBy(1);
    m_fraba.setPower(true);
    play(m_fraba, {{0x0000'0000, 0x0000'303A}});
}

TEST_F(Power, EveryConfirmedParameterIsOneWrite)
{
    send(m_fraba, {0x0200'00FF, 0x0400'0001, 0x0600'0003, 0x0800'0000});
    EXPECT_EQ(m_fraba.eepromWrites(), 4);
    send(m_fraba, {0x8000'0000, 0x0000'0000});
    EXPECT_EQ(m_fraba.eepromWrites(), 4);
    send(m_fraba, {0x4000'0000, 0x0000'0000, 0x4000'0000}); // the second does nothing
    EXPECT_EQ(m_fraba.eepromWrites(), 5);
    send(m_fraba, {0x0000'0000, 0x2021'0001, 0x0000'0000, 0x2040'0001, 0x2040'0000});
    EXPECT_EQ(m_fraba.eepromWrites(), 5);
    send(m_fraba, {0x0E00'0000, 0x8000'0000});
    EXPECT_EQ(m_fraba.eepromWrites(), 6);

    send(m_baumer, {0x0200'00FF, 0x0400'0001, 0x8000'0000, 0x0000'0000, 0x4000'0000});
    EXPECT_EQ(m_baumer.eepromWrites(), 2); // NPV is not stored
}

TEST_F(Power, FrabaKeepsThePresetAndItsFlag)
{
    send(m_fraba, {0x0800'0064, 0x8000'0000, 0x0000'0000, 0x4000'0000, 0x0000'0000});
    m_fraba.setPower(false);
    m_fraba.setPower(true);
    play(m_fraba, {{0x0000'0000, 0x0000'0064, 3}});
    EXPECT_EQ(send(m_fraba, {0x2021'0006}), 0xA000'0000);
}

TEST_F(Power, BaumerLosesAZeroOffsetThatWasNotStored)
{
    send(m_baumer, {0x0800'0064, 0x8000'0000, 0x0000'0000, 0x4000'0000});
    EXPECT_EQ(send(m_baumer, {0x0000'0000}), 0x0000'0064);
    m_baumer.powerCycle();
    for (int i = 0; i < 100; ++i)
        m_baumer.cycle(0);
    EXPECT_EQ(m_baumer.cycle(0), pos);
}

TEST_F(Power, BaumerStoresTheZeroOffsetWithTheNextParameter)
{
    send(m_baumer, {0x0800'0064, 0x8000'0000, 0x0000'0000, 0x4000'0000});
    send(m_baumer, {0x0000'0000, 0x0600'0003, 0x8000'0000, 0x0000'0000});
    m_baumer.powerCycle();
    for (int i = 0; i < 100; ++i)
        m_baumer.cycle(0);
    EXPECT_EQ(m_baumer.cycle(0), 0x0000'0064);
}

TEST_F(Power, BaumerDoesNotStoreTheZeroOffsetWithARunThatWroteNothing)
{
    send(m_baumer, {0x0800'0064, 0x8000'0000, 0x0000'0000, 0x4000'0000});
    EXPECT_EQ(send(m_baumer, {0x0000'0000, 0x1000'0000, 0x8000'0000}), 0x8400'0000); // no such number
    EXPECT_EQ(send(m_baumer, {0x0000'0000, 0x8000'0000}), 0x0000'0064);
    m_baumer.powerCycle();
    for (int i = 0; i < 100; ++i)
        m_baumer.cycle(0);
    EXPECT_EQ(m_baumer.cycle(0), pos);
}

TEST_F(Power, BaumerTestsLoadsAndChecksBeforeItOperates)
{
    m_baumer.powerCycle();
    play(m_baumer, {{0x0000'0000, 0x0000'0000, 50}, {0x0000'0000, 0xC000'0000, 20}, {0x0000'0000, pos, 2}});
}

TEST_F(Power, BaumerShowsALowBatteryAtPowerUpAndRunsNevertheless)
{
    m_baumer.setBatteryLow(true);
    play(m_baumer, {{0x0000'0000, pos, 5}});
    m_baumer.powerCycle();
    play(m_baumer, {
                       {0x0000'0000, 0x0000'0000, 50},
                       {0x0000'0000, 0xC000'0000, 20},
                       {0x0000'0000, 0x9C00'0000, 5},
                       {0x8000'0000, 0x9C00'0000},
                       {0x8000'0000, pos, 3},
                   });
    EXPECT_TRUE(m_baumer.isBatteryLow());
    EXPECT_FALSE(m_fraba.hasBattery());
    m_fraba.setBatteryLow(true);
    EXPECT_FALSE(m_fraba.isBatteryLow());
}

TEST_F(Power, BaumerWithLowBatteryAndLostParametersShowsBothInTurn)
{
    m_baumer.setBatteryLow(true);
    m_baumer.setPower(false);
    m_baumer.loseParameters();
    m_baumer.setPower(true);
    play(m_baumer, {
                       {0x0000'0000, 0xC000'0000, 20},
                       {0x0000'0000, 0x9C00'0000, 2},
                       {0x8000'0000, 0x9C00'0000},
                       {0x8000'0000, 0x8600'0000, 3},
                   });
    EXPECT_EQ(send(m_baumer, {0x0E00'0000, 0x8000'0000}), pos);
}

TEST_F(Power, LostParametersStayLostOverPowerOff)
{
    m_fraba.loseParameters();
    m_fraba.setPower(false);
    m_fraba.setPower(true);
    play(m_fraba, {{0x0000'0000, 0x8600'0000, 3}});
}

TEST_F(Power, LostParametersAreLostAllOfThem)
{
    send(m_fraba, {0x0A00'0007, 0x8000'0000, 0x0000'0000});
    m_fraba.loseParameters();
    EXPECT_EQ(send(m_fraba, {0x0200'2000, 0x0400'0001, 0x0600'0003, 0x0800'0000, 0x8000'0000}), pos);
}

TEST_F(Power, AnUnknownNumberIsForgottenAtPowerOff)
{
    send(m_baumer, {0x1000'0000});
    m_baumer.setBatteryLow(true);
    m_baumer.setPower(false);
    m_baumer.setPower(true);
    play(m_baumer, {{0x0000'0000, 0xC000'0000, 20},
                    {0x0000'0000, 0x9C00'0000},
                    {0x8000'0000, 0x9C00'0000},
                    {0x8000'0000, pos}});
}

// Power returns while OUT is not 0.
TEST_F(Power, RunNeedsAnEdgeThatTheEncoderHasSeen)
{
    m_fraba.loseParameters();
    m_fraba.setPower(false);
    m_fraba.setPower(true);
    send(m_fraba, {0x8000'0000, 0x0000'0000, 0x0E00'0000}); // CE
    m_fraba.setPower(false);
    m_fraba.setPower(true);
    play(m_fraba, {{0x8000'0000, 0x8600'0000, 5}}); // no edge: the pending default was dropped anyway
    m_baumer.setBatteryLow(true);
    m_baumer.powerCycle();
    play(m_baumer, {{0x8000'0000, 0x0000'0000, 50},
                    {0x8000'0000, 0xC000'0000, 20},
                    {0x8000'0000, 0x9C00'0000, 5},
                    {0x0000'0000, 0x9C00'0000, 2},
                    {0x8000'0000, 0x9C00'0000},
                    {0x8000'0000, pos}});
}

TEST_F(Power, APresetBitThatStandsAtPowerUpIsNoEdge)
{
    send(m_fraba, {0x0800'0064, 0x8000'0000, 0x0000'0000});
    m_fraba.powerCycle();
    play(m_fraba, {{0x4000'0000, 0x0000'0000, 50}, {0x4000'0000, pos, 5}});
    play(m_fraba, {{0x0000'0000, pos}, {0x4000'0000, pos, 2}, {0x4000'0000, 0x0000'0064}});
}

TEST_F(Power, AParameterNumberThatStandsAtPowerUpStartsTheParameterization)
{
    m_fraba.powerCycle();
    play(m_fraba, {{0x0200'00FF, 0x0000'0000, 50}, {0x0200'00FF, pos, 2}, {0x0200'00FF, 0xC200'00FF, 3}});
    m_baumer.powerCycle();
    play(m_baumer, {{0x0200'00FF, 0x0000'0000, 50},
                    {0x0200'00FF, 0xC000'0000, 20},
                    {0x0200'00FF, pos},
                    {0x0200'00FF, 0xC000'00FF, 2},
                    {0x0200'00FF, 0xC200'00FF}});
}

} // namespace
} // namespace codewheel
