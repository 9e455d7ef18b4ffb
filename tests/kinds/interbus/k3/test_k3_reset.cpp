// SPDX-License-Identifier: GPL-3.0-or-later
// "Set encoder to default" (FRABA manual 10.1), "reset to factory settings" (Baumer manual 5): 0E000000, run.
#include "kinds/interbus/words/word_refusals.h"
#include "tests/kinds/interbus/words/driver_table.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

// A read-out between two 00000000.
void playReadOut(DriverTable &table, Word request, Word answer)
{
    table.play({{request, pos}, {request, answer}, {0x0000'0000, pos}});
}

TEST(K3Reset, FrabaIsReadBackAfterwards)
{
    DriverTable table(u"fraba-ocd-ib");
    table.tell(Parameter::startUpMode, 1);
    ASSERT_TRUE(table.begin(ResetToDefault{}));
    table.play({{0x0000'0000, pos},
                {0x0E00'0000, pos},
                {0x0E00'0000, 0xCE00'0000},
                {0x8000'0000, 0xCE00'0000},
                {0x8000'0000, pos},
                {0x0000'0000, pos}});
    playReadOut(table, 0x2021'000A, 0xA000'0003); // steps minus 1
    playReadOut(table, 0x2021'0001, 0xA000'1FFF);
    playReadOut(table, 0x2021'0002, 0xA000'0001);
    playReadOut(table, 0x2021'0003, 0xA000'0003);
    playReadOut(table, 0x2021'0004, 0xA000'0007); // not the 0 that is assumed
    playReadOut(table, 0x2021'0005, 0xA000'0000);
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->eepromWrites, 1);
    EXPECT_EQ(table.known(Parameter::steps), 8192);
    EXPECT_EQ(table.known(Parameter::preset), 7);
    EXPECT_EQ(table.evidence(Parameter::preset), Evidence::read);
    EXPECT_EQ(table.driver().reading().mode, Mode::position);
}

// Cam mode refuses parameter words (FRABA manual 10.6).
TEST(K3Reset, FrabaIsBroughtToPositionModeFirst)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(ResetToDefault{}));
    table.play({{0x0000'0000, pos}});
    table.repeat(3, {0x2080'0000, pos});
    table.repeat(3, {0x2040'0000, pos});
    table.play({{0x0000'0000, pos}, {0x0E00'0000, pos}});
    EXPECT_EQ(table.driver().reading().mode, Mode::position);
}

// Baumer shows the previous number, 0 at first, while it processes; it cannot be read
TEST(K3Reset, BaumerHasItsFactorySettingsAfterwards)
{
    DriverTable table(u"baumer-gxp6w");
    ASSERT_TRUE(table.begin(ResetToDefault{}));
    table.play({{0x0000'0000, pos},
                {0x0E00'0000, pos},
                {0x0E00'0000, 0xC000'0000},
                {0x0E00'0000, 0xCE00'0000},
                {0x8000'0000, 0xCE00'0000},
                {0x8000'0000, pos},
                {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.known(Parameter::coding), 3);
    EXPECT_EQ(table.known(Parameter::offset), 0);
    EXPECT_EQ(table.evidence(Parameter::measuringRange), Evidence::echoed);
    EXPECT_EQ(table.outcome()->eepromWrites, 1);
    EXPECT_EQ(table.driver().reading().position, 12'345) << "the coding is known now";
}

// FRABA manual 10.3: 86000000, parameters lost, is cleared by the default
TEST(K3Reset, LeavesTheErrorOfLostParameters)
{
    DriverTable table(u"baumer-gxp6w");
    table.play({{0x0000'0000, 0x8600'0000}});
    ASSERT_TRUE(table.begin(ResetToDefault{}));
    table.play({{0x0000'0000, 0x8600'0000},
                {0x0E00'0000, 0x8600'0000},
                {0x0E00'0000, 0xCE00'0000},
                {0x8000'0000, pos},
                {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
}

void confirmByHand(DriverTable &table)
{
    ASSERT_TRUE(table.begin(ResetToDefault{}, Pace::byHand));
    table.play({{0x0000'0000, pos}});
    table.driver().proceed();
    table.play({{0x0000'0000, pos}, {0x0E00'0000, 0xC000'0000}});
    table.repeat(3, {0x0E00'0000, 0xCE00'0000});
    EXPECT_TRUE(table.progress().waitsForUser);
}

class K3ResetCancelled : public testing::TestWithParam<OnCancel>
{};

// Restoring begins with run, which would carry out the reset
TEST_P(K3ResetCancelled, AfterTheConfirmationIsNotRun)
{
    DriverTable table(u"baumer-gxp6w");
    confirmByHand(table);
    EXPECT_FALSE(table.progress().canRestore);
    table.driver().cancel(GetParam(), {});
    table.play({{0x0E00'0000, 0xCE00'0000}});
    table.repeat(2, {0x0000'0000, 0xCE00'0000});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->leftIn, EncoderState::parameterization);
    EXPECT_TRUE(table.outcome()->resetWaits);
    EXPECT_FALSE(table.outcome()->foundInParameterization);
    table.repeat(5, {0x0000'0000, 0xCE00'0000});
    EXPECT_EQ(table.known(Parameter::steps), std::nullopt);
}

INSTANTIATE_TEST_SUITE_P(Baumer, K3ResetCancelled,
                         testing::Values(OnCancel::leaveAsIs, OnCancel::restorePrevious));

TEST(K3Reset, IsNotDoneByAnEncoderThatRestartedBeforeRun)
{
    DriverTable table(u"baumer-gxp6w");
    confirmByHand(table);
    table.play({{0x0E00'0000, pos}});
    table.repeat(2, {0x0000'0000, pos});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->result.error().id, WordRefusalId::restarted);
    EXPECT_EQ(table.known(Parameter::steps), std::nullopt);
}

} // namespace
} // namespace codewheel
