// SPDX-License-Identifier: GPL-3.0-or-later
// FRABA manual 5.4.1: "it is to be noted that due to the nature of the INTERBUS [..] after transmitting the
// command FRABA Preset another command should be sent". 60000000 acts in every cycle in which it is seen.
#include "tests/kinds/interbus/words/driver_table.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class FrabaPreset : public testing::Test
{
protected:
    DriverTable m_table{u"fraba-ocd-ib"};

    void SetUp() override
    {
        m_table.tell(Parameter::startUpMode, 1);
        m_table.tell(Parameter::preset, 100);
    }
};

TEST_F(FrabaPreset, StandsForExactlyOneCycle)
{
    ASSERT_TRUE(m_table.begin(SetPreset{{}, PresetCommand::manufacturer}));
    m_table.play({{0x0000'0000, pos}, {0x6000'0000, pos}, {0x0000'0000, 0x64}, {0x0000'0000, 0x64}});
    ASSERT_TRUE(m_table.outcome());
    EXPECT_TRUE(m_table.outcome()->result);
    EXPECT_EQ(m_table.outcome()->positionBefore, 0x3039);
    EXPECT_EQ(m_table.outcome()->positionAfter, 100);
    EXPECT_EQ(m_table.outcome()->eepromWrites, 1);
}

TEST_F(FrabaPreset, IsActivatedAgainWithoutProgramming)
{
    for (int times = 1; times <= 3; ++times) {
        ASSERT_TRUE(m_table.begin(SetPreset{{}, PresetCommand::manufacturer}));
        m_table.play({{0x0000'0000, pos}, {0x6000'0000, pos}, {0x0000'0000, 0x64}, {0x0000'0000, 0x64}});
        EXPECT_EQ(m_table.eepromWrites(), times);
    }
}

// The position proves that it was taken.
TEST_F(FrabaPreset, AValueThatIsNotKnownIsReadFirst)
{
    DriverTable table(u"fraba-ocd-ib");
    table.tell(Parameter::startUpMode, 1);
    ASSERT_TRUE(table.begin(SetPreset{{}, PresetCommand::manufacturer}));
    table.play({{0x0000'0000, pos},
                {0x2021'0004, pos},
                {0x2021'0004, 0xA000'0064},
                {0x0000'0000, pos},
                {0x6000'0000, pos},
                {0x0000'0000, 0x64},
                {0x0000'0000, 0x64}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
}

TEST_F(FrabaPreset, ThatWasNotTakenIsAFailure)
{
    ASSERT_TRUE(m_table.begin(SetPreset{{}, PresetCommand::manufacturer}));
    m_table.play({{0x0000'0000, pos}, {0x6000'0000, pos}});
    m_table.repeat(1'999, {0x0000'0000, pos});
    m_table.play({{0x2021'0006, 0xA000'0001}, {0x0000'0000, pos}, {0x0000'0000, pos}});
    ASSERT_TRUE(m_table.outcome());
    EXPECT_EQ(m_table.outcome()->result.error().id, RefusalId::presetNotTaken);
}

TEST_F(FrabaPreset, AValueIsProgrammedAndReadBackBefore)
{
    ASSERT_TRUE(m_table.begin(SetPreset{100, PresetCommand::manufacturer}));
    m_table.play({
        {0x0000'0000, pos},
        {0x2021'0004, pos},
        {0x2021'0004, 0xA000'0000},
        {0x0000'0000, pos},
        {0x0800'0064, 0xC800'0064},
        {0x8000'0000, pos},
        {0x0000'0000, pos},
        {0x2021'0004, pos},
        {0x2021'0004, 0xA000'0064},
        {0x0000'0000, pos},
        {0x6000'0000, pos},
        {0x0000'0000, 0x0000'0064},
        {0x0000'0000, 0x0000'0064},
    });
    ASSERT_TRUE(m_table.outcome());
    EXPECT_TRUE(m_table.outcome()->result);
    EXPECT_EQ(m_table.outcome()->written, (ParameterValues{{Parameter::preset, 100}}));
    EXPECT_EQ(m_table.outcome()->eepromWrites, 2);
}

// 40000000 would need it: the preset flag does not matter here
TEST_F(FrabaPreset, AValueThatIsThereIsNotProgrammedAgain)
{
    ASSERT_TRUE(m_table.begin(SetPreset{100, PresetCommand::manufacturer}));
    m_table.play({
        {0x0000'0000, pos},
        {0x2021'0004, pos},
        {0x2021'0004, 0xA000'0064},
        {0x0000'0000, pos},
        {0x6000'0000, pos},
        {0x0000'0000, 0x0000'0064},
        {0x0000'0000, 0x0000'0064},
    });
    ASSERT_TRUE(m_table.outcome());
    EXPECT_EQ(m_table.outcome()->alreadyThere, (ParameterValues{{Parameter::preset, 100}}));
    EXPECT_EQ(m_table.outcome()->eepromWrites, 1);
}

TEST_F(FrabaPreset, ByHandTheNextWordWaitsForNobody)
{
    ASSERT_TRUE(m_table.begin(SetPreset{{}, PresetCommand::manufacturer}, Pace::byHand));
    m_table.repeat(5, {0x0000'0000, pos});
    EXPECT_TRUE(m_table.progress().waitsForUser);
    m_table.driver().proceed();
    m_table.play({{0x0000'0000, pos}, {0x6000'0000, pos}, {0x0000'0000, 0x64}, {0x0000'0000, 0x64}});
    EXPECT_TRUE(m_table.outcome());
}

TEST_F(FrabaPreset, CancelledWhileItStandsItIsNotRepeated)
{
    ASSERT_TRUE(m_table.begin(SetPreset{{}, PresetCommand::manufacturer}));
    m_table.play({{0x0000'0000, pos}});
    m_table.driver().cancel(OnCancel::leaveAsIs, {}); // as 60000000 goes out
    m_table.play({{0x6000'0000, pos}, {0x0000'0000, 0x64}, {0x0000'0000, 0x64}});
    ASSERT_TRUE(m_table.outcome());
    EXPECT_EQ(m_table.outcome()->result.error().id, RefusalId::cancelled);
    EXPECT_EQ(m_table.outcome()->eepromWrites, 1);
}

TEST_F(FrabaPreset, AmongWordsOfTheUserItStandsForOneCycleToo)
{
    ASSERT_TRUE(m_table.begin(SendWords{.words = {0x6000'0000, 0x0000'0000, 0x6000'0000}, .holdCycles = 3}));
    m_table.play({{0x0000'0000, pos}, {0x6000'0000, pos}});
    m_table.repeat(3, {0x0000'0000, 0x64});
    m_table.play({{0x6000'0000, 0x64}});
    m_table.repeat(3, {0x0000'0000, 0x64});
    ASSERT_TRUE(m_table.outcome());
    EXPECT_TRUE(m_table.outcome()->result);
    EXPECT_EQ(m_table.outcome()->eepromWrites, 2);
}

TEST_F(FrabaPreset, BehindTheLastWordNormalRunningFollows)
{
    ASSERT_TRUE(m_table.begin(SendWords{.words = {0x6000'0000}, .holdCycles = 2}));
    m_table.play({{0x0000'0000, pos}, {0x6000'0000, pos}});
    EXPECT_FALSE(m_table.outcome());
    m_table.play({{0x0000'0000, 0x64}, {0x0000'0000, 0x64}});
    ASSERT_TRUE(m_table.outcome());
    EXPECT_TRUE(m_table.outcome()->result);
    EXPECT_EQ(m_table.outcome()->eepromWrites, 1);
}

// FRABA manual 10.3: above 800 kHz the encoder shows 80000000, no valid position
constexpr Word tooFast = 0x8000'0000;

class PresetTooFast : public testing::TestWithParam<Job>
{
protected:
    DriverTable m_table{u"fraba-ocd-ib"};

    void SetUp() override { m_table.tell(Parameter::startUpMode, 1); }
};

TEST_P(PresetTooFast, IsRefusedAndNothingIsSent)
{
    m_table.play({{0x0000'0000, tooFast}});
    EXPECT_EQ(m_table.begin(GetParam()).error(),
              (Refusal{RefusalKind::device, RefusalId::noValidPosition, {tooFast}}));
    m_table.repeat(3, {0x0000'0000, tooFast});
    EXPECT_EQ(m_table.eepromWrites(), 0);
}

INSTANTIATE_TEST_SUITE_P(EachWay, PresetTooFast,
                         testing::Values(SetPreset{}, SetPreset{100, PresetCommand::profile},
                                         SetPreset{{}, PresetCommand::manufacturer},
                                         WriteParameters{.values = {{Parameter::preset, 100}},
                                                         .onlyWhatDiffers = false,
                                                         .previous = {},
                                                         .initialisePreset = true}));

TEST_F(FrabaPreset, AShaftThatTurnsTooFastMeanwhileEndsTheJobBeforeThePreset)
{
    ASSERT_TRUE(m_table.begin(SetPreset{{}, PresetCommand::manufacturer}, Pace::byHand));
    m_table.repeat(2, {0x0000'0000, pos});
    m_table.driver().proceed();
    m_table.repeat(3, {0x0000'0000, tooFast});
    ASSERT_TRUE(m_table.outcome());
    EXPECT_EQ(m_table.outcome()->result.error().id, RefusalId::noValidPosition);
}

TEST_F(FrabaPreset, WordsThatSetThePositionOfAFastShaftAreCounted)
{
    m_table.play({{0x0000'0000, tooFast}});
    ASSERT_TRUE(m_table.begin(SendWords{.words = {0x6000'0000, 0x0000'0000}, .holdCycles = 1}));
    m_table.play({{0x0000'0000, tooFast}, {0x6000'0000, tooFast}});
    EXPECT_EQ(m_table.eepromWrites(), 1);
}

TEST(Preset40000000, OfAFastShaftIsCountedWhereItIsStored)
{
    DriverTable table(u"fraba-ocd-ib");
    table.tell(Parameter::startUpMode, 1);
    table.play({{0x0000'0000, tooFast}});
    ASSERT_TRUE(table.begin(SendWords{.words = {0x4000'0000}, .holdCycles = 2}));
    table.play({{0x0000'0000, tooFast}, {0x4000'0000, tooFast}, {0x4000'0000, tooFast}});
    EXPECT_EQ(table.eepromWrites(), 1);
}

// A word from a monitor, which nobody takes back
TEST(FrabaPresetByHand, IsTakenAwayWhateverTheMode)
{
    DriverTable table(u"fraba-ocd-ib");
    EXPECT_EQ(table.driver().cycle(pos, 0x6000'0000, Instant{1}), Word{0});
    EXPECT_FALSE(table.driver().mayStand(0x6000'0000));
    EXPECT_TRUE(table.driver().mayStand(0x4000'0000));
}

TEST(FrabaPresetByHand, StandsInCamModeWhereItIsAStopPosition)
{
    DriverTable table(u"fraba-ocd-ib");
    table.tell(Parameter::startUpMode, 3);
    EXPECT_EQ(table.driver().cycle(pos, 0x6000'0000, Instant{1}), Word{0x6000'0000});
}

TEST(FrabaPresetByHand, MeansNothingToABaumer)
{
    DriverTable table(u"baumer-gxp6w");
    EXPECT_TRUE(table.driver().mayStand(0x6000'0000));
    EXPECT_EQ(table.begin(SetPreset{{}, PresetCommand::manufacturer}).error().id,
              RefusalId::manufacturerPresetNotSupported);
}

TEST(FrabaPresetOfUnknownMode, IsRefused)
{
    DriverTable table(u"fraba-ocd-ib");
    EXPECT_EQ(table.begin(SetPreset{{}, PresetCommand::manufacturer}).error(),
              (Refusal{RefusalKind::notSupported, RefusalId::modeNotKnown, {Word{0x6000'0000}}}));
}

} // namespace
} // namespace codewheel
