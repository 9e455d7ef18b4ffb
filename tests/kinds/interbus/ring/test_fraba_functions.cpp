// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of a FRABA encoder besides its parameters, with driver and simulated encoder together.
#include "driven_encoder.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class FrabaFunctionsDriven : public testing::Test
{
protected:
    DrivenEncoder m_driven{u"fraba-ocd-ib", frabaK3()};

    void run(const Job &job)
    {
        m_driven.begin(job);
        ASSERT_TRUE(m_driven.finish());
        EXPECT_TRUE(m_driven.outcome()->result);
        m_driven.expectTruth();
        EXPECT_EQ(m_driven.countedWrites(), m_driven.encoder().eepromWrites());
    }
    const Reading &reading() { return m_driven.driver().reading(); }
};

TEST_F(FrabaFunctionsDriven, VelocityIsShownAndKeptOverPowerOff)
{
    m_driven.encoder().setSpeed(-150);
    run(SwitchMode{Mode::velocity});
    EXPECT_EQ(reading().velocity, -150);
    m_driven.encoder().powerCycle();
    m_driven.cycles(100);
    EXPECT_EQ(reading().velocity, -150);
    run(SwitchMode{Mode::position});
    EXPECT_TRUE(reading().position);
    EXPECT_EQ(m_driven.countedWrites(), 0);
}

TEST_F(FrabaFunctionsDriven, ThePresetIsSetAgainAndAgainForOneWriteEach)
{
    run(SetPreset{1000, PresetCommand::manufacturer});
    EXPECT_EQ(m_driven.outcome()->positionAfter, 1000);
    EXPECT_EQ(m_driven.countedWrites(), 2);
    for (int writes = 3; writes <= 5; ++writes) {
        m_driven.encoder().turnBy(70);
        run(SetPreset{{}, PresetCommand::manufacturer});
        EXPECT_EQ(m_driven.outcome()->positionBefore, 1070);
        EXPECT_EQ(m_driven.outcome()->positionAfter, 1000);
        EXPECT_EQ(m_driven.countedWrites(), writes);
    }
}

TEST_F(FrabaFunctionsDriven, AResetIsReadBackAndCostsOneWrite)
{
    run(WriteParameters{.values = {{Parameter::steps, 255}, {Parameter::direction, 4}}, .previous = {}});
    run(SwitchMode{Mode::velocity});
    const int before = m_driven.countedWrites();
    run(ResetToDefault{});
    EXPECT_EQ(m_driven.countedWrites(), before + 1);
    EXPECT_EQ(m_driven.actual(Parameter::steps), 8192);
    EXPECT_EQ(valueOf(m_driven.outcome()->read, Parameter::steps), 8192);
    EXPECT_EQ(valueOf(m_driven.outcome()->read, Parameter::direction), 3);
    EXPECT_EQ(reading().mode, Mode::position);
    EXPECT_EQ(reading().position, 12'345);
}

TEST_F(FrabaFunctionsDriven, ACamProgramIsLeftForAReset)
{
    run(SendWords{.words = {0x2080'0001, 0x2040'0001, 0x8000'0000, 0x0000'0000}});
    EXPECT_EQ(reading().mode, Mode::cam);
    m_driven.begin(ResetToDefault{});
    ASSERT_TRUE(m_driven.finish());
    EXPECT_TRUE(m_driven.outcome()->result);
    EXPECT_EQ(m_driven.encoder().eepromWrites(), 2) << "the cam program, and the reset";
    EXPECT_EQ(reading().position, 12'345);
}

TEST(BaumerDriven, AResetBaumerIsKnownByItsConfirmation)
{
    DrivenEncoder driven(u"baumer-gxp6w", baumerK3());
    driven.begin(
        WriteParameters{.values = {{Parameter::coding, 5}, {Parameter::preset, 17}}, .previous = {}});
    ASSERT_TRUE(driven.finish());
    driven.begin(ResetToDefault{});
    ASSERT_TRUE(driven.finish());
    EXPECT_TRUE(driven.outcome()->result);
    driven.expectTruth();
    EXPECT_EQ(driven.actual(Parameter::coding), 3);
    EXPECT_EQ(driven.driver().reading().position, 12'345);
    EXPECT_EQ(driven.countedWrites(), driven.encoder().eepromWrites());
}

} // namespace
} // namespace codewheel
