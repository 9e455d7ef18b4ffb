// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/drivers/driver_table.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

DriverTable frabaInPositionMode()
{
    DriverTable table(u"fraba-ocd-ib");
    table.tell(Parameter::startUpMode, 1);
    return table;
}

TEST(K3Preset, FrabaActivatesAProgrammedPreset)
{
    DriverTable table = frabaInPositionMode();
    ASSERT_TRUE(table.begin(SetPreset{}));
    table.play({
        {0x0000'0000, pos},
        {0x2021'0006, pos},
        {0x2021'0006, 0xA000'0001},
        {0x0000'0000, pos},
        {0x2021'0004, pos},
        {0x2021'0004, 0xA000'0064},
        {0x0000'0000, pos},
        {0x4000'0000, 0x0000'0064},
        {0x0000'0000, 0x0000'0064},
        {0x0000'0000, 0x0000'0064},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->positionBefore, 0x3039);
    EXPECT_EQ(table.outcome()->positionAfter, 100);
    EXPECT_EQ(table.outcome()->eepromWrites, 1);
}

// FRABA manual 5.4.1: each preset value can be activated once; then it has to be programmed again
TEST(K3Preset, FrabaWithAUsedUpPresetIsProgrammedAgain)
{
    DriverTable table = frabaInPositionMode();
    ASSERT_TRUE(table.begin(SetPreset{}));
    table.play({
        {0x0000'0000, pos},
        {0x2021'0006, pos},
        {0x2021'0006, 0xA000'0000},
        {0x0000'0000, pos},
        {0x2021'0004, pos},
        {0x2021'0004, 0xA000'0064},
        {0x0000'0000, pos},
        {0x0800'0064, 0xC800'0064},
        {0x8000'0000, pos},
        {0x0000'0000, pos},
        {0x4000'0000, 0x0000'0064},
        {0x0000'0000, 0x0000'0064},
        {0x0000'0000, 0x0000'0064},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->eepromWrites, 2);
}

TEST(K3Preset, AValueThatIsThereAndProgrammedIsOnlyInitialised)
{
    DriverTable table = frabaInPositionMode();
    ASSERT_TRUE(table.begin(SetPreset{100}));
    table.play({
        {0x0000'0000, pos},
        {0x2021'0006, pos},
        {0x2021'0006, 0xA000'0001},
        {0x0000'0000, pos},
        {0x2021'0004, pos},
        {0x2021'0004, 0xA000'0064},
        {0x0000'0000, pos},
        {0x4000'0000, 0x0000'0064},
        {0x0000'0000, 0x0000'0064},
        {0x0000'0000, 0x0000'0064},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->alreadyThere, (ParameterValues{{Parameter::preset, 100}}));
}

TEST(K3Preset, BaumerInitialisesWhatItHas)
{
    DriverTable table(u"baumer-gxp6w");
    ASSERT_TRUE(table.begin(SetPreset{}));
    table.play({{0x0000'0000, pos}, {0x4000'0000, 0}, {0x0000'0000, 0}, {0x0000'0000, 0}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->eepromWrites, 0) << "the zero offset is not stored";
    EXPECT_EQ(table.outcome()->positionAfter, std::nullopt) << "the coding is not known";
}

// In cam mode 40000000 sets the start of cam 0 to 0
TEST(K3Preset, IsRefusedWhileTheModeIsNotKnown)
{
    DriverTable table(u"fraba-ocd-ib");
    const Result<void> taken = table.begin(SetPreset{});
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().id, RefusalId::modeNotKnown);
    table.repeat(5, {0x0000'0000, pos});
}

// It may be a FRABA in cam mode.
TEST(K3Preset, AnUnnamedK3IsNotSetWhileItsModeIsNotKnown)
{
    DriverTable table(u"generic-k3");
    for (const Job &job :
         {Job(SetPreset{}), Job(SetPreset{100}),
          Job(WriteParameters{
              .values = {{Parameter::preset, 100}}, .previous = {}, .initialisePreset = true})}) {
        const Result<void> taken = table.begin(job);
        ASSERT_FALSE(taken);
        EXPECT_EQ(taken.error(),
                  (Refusal{RefusalKind::notSupported, RefusalId::modeNotKnown, {Word{0x4000'0000}}}));
    }
    table.repeat(5, {0x0000'0000, pos});
}

TEST(K3Preset, AnUnnamedK3IsSetOnceItsModeIsTold)
{
    DriverTable table(u"generic-k3");
    table.tell(Parameter::startUpMode, 1);
    ASSERT_TRUE(table.begin(
        WriteParameters{.values = {{Parameter::preset, 100}}, .previous = {}, .initialisePreset = true}));
    table.play({
        {0x0000'0000, pos},
        {0x0800'0064, 0xC800'0064},
        {0x8000'0000, pos},
        {0x0000'0000, pos},
        {0x4000'0000, 0x0000'0064},
        {0x0000'0000, 0x0000'0064},
        {0x0000'0000, 0x0000'0064},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.driver().reading().mode, Mode::position);
    EXPECT_EQ(table.driver().reading().position, std::nullopt) << "the coding is not known";
}

TEST(K3Preset, IsRefusedInCamMode)
{
    DriverTable table = frabaInPositionMode();
    ASSERT_TRUE(table.begin(SendWords{.words = {0x2080'0001, 0x0000'0000}}));
    table.play({{0x0000'0000, pos}});
    table.repeat(3, {0x2080'0001, pos});
    table.repeat(4, {0x0000'0000, 0});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.driver().reading().mode, Mode::cam);
    EXPECT_FALSE(table.begin(SetPreset{}));
}

} // namespace
} // namespace codewheel
