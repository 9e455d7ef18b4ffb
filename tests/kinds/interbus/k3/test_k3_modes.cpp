// SPDX-License-Identifier: GPL-3.0-or-later
// Velocity mode (FRABA manual 5.4.2, 10.2): 20400001 on, 20400000 off, at once, without acknowledgement or
// run.
#include "tests/kinds/interbus/words/driver_table.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr Word minus150 = 0x01FF'FF6A; // rpm

class K3Modes : public testing::Test
{
protected:
    DriverTable m_table{u"fraba-ocd-ib"};

    void isInPositionMode() { m_table.tell(Parameter::startUpMode, 1); }
    void isInVelocityMode() { m_table.tell(Parameter::startUpMode, 2); }
    void isInCamMode() { m_table.tell(Parameter::startUpMode, 3); }
    void expectSuccess()
    {
        ASSERT_TRUE(m_table.outcome());
        EXPECT_TRUE(m_table.outcome()->result);
        EXPECT_EQ(m_table.outcome()->eepromWrites, 0);
    }
    void expectRefusal(const Job &job, RefusalCode id, Word out)
    {
        const Result<void> taken = m_table.begin(job);
        ASSERT_FALSE(taken);
        EXPECT_EQ(taken.error(), (Refusal{RefusalKind::notSupported, id, {out}}));
        m_table.repeat(5, {0x0000'0000, pos});
    }
};

TEST_F(K3Modes, VelocityOnStandsUntilItIsTaken)
{
    isInPositionMode();
    ASSERT_TRUE(m_table.begin(SwitchMode{Mode::velocity}));
    m_table.play({{0x0000'0000, pos},
                  {0x2040'0001, pos},
                  {0x2040'0001, pos},
                  {0x2040'0001, minus150},
                  {0x0000'0000, minus150},
                  {0x0000'0000, minus150}});
    expectSuccess();
    EXPECT_EQ(m_table.driver().reading().velocity, -150);
    EXPECT_EQ(m_table.driver().reading().mode, Mode::velocity);
    EXPECT_EQ(m_table.driver().reading().position, std::nullopt);
}

TEST_F(K3Modes, VelocityOff)
{
    isInVelocityMode();
    ASSERT_TRUE(m_table.begin(SwitchMode{Mode::position}));
    m_table.play({{0x0000'0000, minus150},
                  {0x2040'0000, minus150},
                  {0x2040'0000, minus150},
                  {0x2040'0000, pos},
                  {0x0000'0000, pos},
                  {0x0000'0000, pos}});
    expectSuccess();
    EXPECT_EQ(m_table.driver().reading().position, 12'345);
    EXPECT_EQ(m_table.driver().reading().velocity, std::nullopt);
}

// 20800000 ends cam mode, and is the only word that means the same in every mode
TEST_F(K3Modes, PositionModeCanBeReachedFromAModeThatIsNotKnown)
{
    ASSERT_TRUE(m_table.begin(SwitchMode{Mode::position}));
    m_table.play({{0x0000'0000, 0x0000'0101}});
    m_table.repeat(3, {0x2080'0000, 0x0000'0101});
    m_table.repeat(3, {0x2040'0000, pos});
    m_table.repeat(2, {0x0000'0000, pos});
    expectSuccess();
    EXPECT_EQ(m_table.driver().reading().mode, Mode::position);
}

// It was perhaps in a cam program that was changed, which is stored when it is left (FRABA manual 5.4.4).
TEST_F(K3Modes, LeavingAModeThatIsNotKnownPerhapsCostsAWriteOnce)
{
    for (const int perhaps : {1, 0}) {
        ASSERT_TRUE(m_table.begin(SwitchMode{Mode::cam, 2}));
        m_table.play({{0x0000'0000, pos}});
        m_table.repeat(3, {0x2080'0002, posInCamMode});
        m_table.repeat(2, {0x0000'0000, posInCamMode});
        expectSuccess();
        EXPECT_EQ(m_table.outcome()->inDoubt.eepromWrites, perhaps);
    }
}

TEST_F(K3Modes, LeavingPositionModeCostsNoWrite)
{
    isInPositionMode();
    ASSERT_TRUE(m_table.begin(SwitchMode{Mode::cam, 2}));
    m_table.play({{0x0000'0000, pos}});
    m_table.repeat(3, {0x2080'0002, posInCamMode});
    m_table.repeat(2, {0x0000'0000, posInCamMode});
    expectSuccess();
    EXPECT_EQ(m_table.outcome()->inDoubt.eepromWrites, 0);
}

TEST_F(K3Modes, AModeThatIsLeftOutOfSightPerhapsCostsAWrite)
{
    for (const int cycles : {0, 1, 5}) {
        DriverTable table{u"fraba-ocd-ib"};
        ASSERT_TRUE(table.begin(SwitchMode{Mode::cam, 2}));
        table.play({{0x0000'0000, pos}});
        table.repeat(std::min(cycles, 3), {0x2080'0002, posInCamMode});
        table.repeat(std::max(cycles - 3, 0), {0x0000'0000, posInCamMode});
        table.driver().stop({RefusalKind::link, RefusalId::connectionClosed, {}}, {});
        ASSERT_TRUE(table.outcome()) << cycles;
        EXPECT_EQ(table.outcome()->eepromWrites, 0) << cycles;
        EXPECT_EQ(table.outcome()->inDoubt.eepromWrites, 1) << cycles;
    }
}

TEST_F(K3Modes, CamModeIsLeftBeforeTheWordOfVelocityMode)
{
    isInCamMode();
    ASSERT_TRUE(m_table.begin(SwitchMode{Mode::velocity}));
    m_table.play({{0x0000'0000, 0x0000'0101}});
    m_table.repeat(3, {0x2080'0000, 0x0000'0101});
    m_table.repeat(3, {0x2040'0001, pos});
    m_table.repeat(2, {0x0000'0000, minus150});
    expectSuccess();
    EXPECT_EQ(m_table.driver().reading().velocity, -150);
}

TEST_F(K3Modes, VelocityIsRefusedWhileTheModeIsNotKnown)
{
    expectRefusal(SwitchMode{Mode::velocity}, RefusalId::modeNotKnown, 0x2040'0001);
}

TEST_F(K3Modes, AWordOfTheManualIsRefusedWhereItWouldSetACam)
{
    isInCamMode();
    expectRefusal(SetPreset{}, RefusalId::inCamMode, 0x4000'0000);
    expectRefusal(SetPreset{{}, PresetCommand::manufacturer}, RefusalId::inCamMode, 0x6000'0000);
}

// 84000000 would be the answer (FRABA manual 10.6).
TEST_F(K3Modes, ParametersAreRefusedInCamModeBeforeAnythingIsSent)
{
    isInCamMode();
    const ParameterValues values{{Parameter::direction, 4}, {Parameter::preset, 7}};
    expectRefusal(WriteParameters{.values = values, .previous = {}}, RefusalId::inCamMode, 0x0600'0004);
    expectRefusal(EndParameterization{values}, RefusalId::inCamMode, 0x0600'0004);
    EXPECT_TRUE(m_table.begin(EndParameterization{})) << "run ends a cam parameterization, too";
}

TEST_F(K3Modes, ParametersCanBeReadInCamMode)
{
    isInCamMode();
    EXPECT_TRUE(m_table.begin(ReadParameters{{Parameter::direction}}));
}

TEST_F(K3Modes, TheErrorOfAnEncoderThatDoesNotKnowTheWordIsNamed)
{
    isInPositionMode();
    ASSERT_TRUE(m_table.begin(SwitchMode{Mode::velocity}));
    m_table.play({{0x0000'0000, pos},
                  {0x2040'0001, pos},
                  {0x2040'0001, pos},
                  {0x2040'0001, 0x8400'0000},
                  {0x0000'0000, 0x8400'0000},
                  {0x0000'0000, 0x8400'0000}});
    ASSERT_TRUE(m_table.outcome());
    ASSERT_FALSE(m_table.outcome()->result);
    EXPECT_EQ(m_table.outcome()->result.error(),
              (Refusal{RefusalKind::device, RefusalId::unknownParameterNumber, {Word{0x8400'0000}}}));
}

TEST_F(K3Modes, AnEncoderInParameterizationIsNotSwitched)
{
    isInPositionMode();
    m_table.play({{0x0000'0000, 0xC200'00FF}});
    const Result<void> taken = m_table.begin(SwitchMode{Mode::velocity});
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().id, RefusalId::inParameterization);
}

// It was told to be in position mode: the words of velocity mode set the active cams instead.
TEST_F(K3Modes, AWordThatIsAcknowledgedWasACamWord)
{
    struct
    {
        Mode to;
        Word out;
        Word in;
    } const rows[] = {{Mode::velocity, 0x2040'0001, 0xE040'0001}, {Mode::position, 0x2040'0000, 0xE040'0000}};
    for (const auto &row : rows) {
        DriverTable table(u"fraba-ocd-ib");
        table.tell(Parameter::startUpMode, row.to == Mode::velocity ? 1 : 2);
        ASSERT_TRUE(table.begin(SwitchMode{row.to}));
        table.play({{0x0000'0000, pos}, {row.out, pos}, {row.out, pos}, {row.out, row.in}});
        table.repeat(2, {0x0000'0000, row.in});
        ASSERT_TRUE(table.outcome());
        ASSERT_FALSE(table.outcome()->result);
        EXPECT_EQ(table.outcome()->result.error(),
                  (Refusal{RefusalKind::device, RefusalId::takenAsCamWord, {row.out, row.in}}));
        EXPECT_EQ(table.driver().reading().mode, Mode::cam);
    }
}

TEST_F(K3Modes, AnEncoderThatStaysInParameterizationIsInNoMode)
{
    isInVelocityMode();
    m_table.play({{0x0000'0000, 0xC200'00FF}});
    ASSERT_TRUE(m_table.begin(SwitchMode{Mode::position}));
    m_table.play({{0x0000'0000, 0xC200'00FF}});
    m_table.repeat(3, {0x2040'0000, 0xC200'00FF});
    m_table.repeat(2, {0x0000'0000, 0xC200'00FF});
    ASSERT_TRUE(m_table.outcome());
    ASSERT_FALSE(m_table.outcome()->result);
    EXPECT_EQ(m_table.outcome()->result.error().id, RefusalId::modeNotSwitched);
    EXPECT_TRUE(m_table.outcome()->foundInParameterization);
}

TEST(K3ModesOfOthers, AreRefused)
{
    DriverTable table(u"baumer-gxp6w");
    EXPECT_EQ(table.begin(SwitchMode{Mode::velocity}).error().id, RefusalId::velocityNotSupported);
    EXPECT_EQ(table.begin(SwitchMode{Mode::position}).error().id, RefusalId::velocityNotSupported);
}

class K3ModesOfAnUnnamedEncoder : public testing::Test
{
protected:
    DriverTable m_table{u"generic-k3"};

    void send(Word word)
    {
        ASSERT_TRUE(m_table.begin(SendWords{.words = {word, 0x0000'0000}}));
        m_table.play({{0x0000'0000, pos}});
        m_table.repeat(3, {word, pos});
        m_table.repeat(4, {0x0000'0000, pos});
        ASSERT_TRUE(m_table.outcome());
    }
    std::optional<Mode> mode() { return m_table.driver().reading().mode; }
};

// A FRABA would then be in cam or velocity mode, another make not.
TEST_F(K3ModesOfAnUnnamedEncoder, AWordThatWouldSwitchAFrabaLeavesTheModeUnknown)
{
    for (const Word word : {0x2080'0001u, 0x2040'0001u}) {
        m_table = DriverTable{u"generic-k3"};
        m_table.tell(Parameter::startUpMode, 1);
        m_table.repeat(2, {0x0000'0000, pos});
        EXPECT_EQ(mode(), Mode::position);
        send(word);
        EXPECT_EQ(mode(), std::nullopt) << std::hex << word;
        EXPECT_EQ(m_table.begin(SetPreset{}).error().id, RefusalId::modeNotKnown);
    }
}

TEST_F(K3ModesOfAnUnnamedEncoder, TheWordThatEndsCamModeLeavesItInPositionMode)
{
    send(0x2080'0000);
    EXPECT_EQ(mode(), Mode::position);
    EXPECT_TRUE(m_table.begin(SetPreset{}));
}

TEST_F(K3ModesOfAnUnnamedEncoder, TheProgramDoesNotSwitchItOfItself)
{
    EXPECT_EQ(m_table.begin(SwitchMode{Mode::position}).error().id, RefusalId::velocityNotSupported);
}

// FRABA manual 10.2: 0 K2, 1 K3, 2 velocity, 3 to 10 cam programs
TEST(StartUpMode, TellsTheModeAndTheModeTellsIt)
{
    EXPECT_EQ(startUpModeFor(Mode::position, {}), 1);
    EXPECT_EQ(startUpModeFor(Mode::velocity, {}), 2);
    EXPECT_EQ(startUpModeFor(Mode::cam, 1), 3);
    EXPECT_EQ(startUpModeFor(Mode::cam, 8), 10);
    EXPECT_EQ(startUpModeFor(Mode::cam, {}), std::nullopt);
    for (std::int64_t startUp = 1; startUp <= 10; ++startUp) {
        const auto mode = modeAfterStartUp(startUp);
        ASSERT_TRUE(mode) << startUp;
        EXPECT_EQ(startUpModeFor(*mode, camProgramAfterStartUp(startUp)), startUp);
    }
    EXPECT_EQ(modeAfterStartUp(11), std::nullopt);
}

} // namespace
} // namespace codewheel
