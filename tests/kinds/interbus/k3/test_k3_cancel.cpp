// SPDX-License-Identifier: GPL-3.0-or-later
// Each choice of cancel, at every step of a write.
#include "tests/kinds/interbus/words/driver_table.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class K3Cancel : public testing::Test
{
protected:
    DriverTable table{u"fraba-ocd-ib"};

    void SetUp() override
    {
        table.tell(Parameter::multiTurnAndStepsMinusOne, 2);
        ASSERT_TRUE(table.begin(WriteParameters{
            .values = {{Parameter::steps, 255}, {Parameter::direction, 4}},
            .previous = {{Parameter::steps, 8192}, {Parameter::direction, 3}},
        }));
    }

    void cancel(OnCancel how) { table.driver().cancel(how, Instant{}); }

    void expectCancelled(EncoderState leftIn)
    {
        ASSERT_TRUE(table.outcome());
        ASSERT_FALSE(table.outcome()->result);
        EXPECT_EQ(table.outcome()->result.error(), (Refusal{RefusalKind::stopped, RefusalId::cancelled, {}}));
        EXPECT_EQ(table.outcome()->leftIn, leftIn);
    }
};

TEST_F(K3Cancel, BeforeTheFirstWordNothingIsSent)
{
    cancel(OnCancel::restorePrevious);
    table.repeat(3, {0x0000'0000, pos});
    expectCancelled(EncoderState::operation);
}

TEST_F(K3Cancel, BeforeAnythingWasConfirmedOutGoesBackToZero)
{
    table.play({{0x0000'0000, pos}, {0x0200'00FF, pos}});
    cancel(OnCancel::restorePrevious);
    table.play({{0x0200'00FF, pos}, {0x0000'0000, pos}, {0x0000'0000, pos}});
    expectCancelled(EncoderState::operation);
    EXPECT_EQ(table.outcome()->eepromWrites, 0);
}

TEST_F(K3Cancel, IfNothingWasTakenItEndsAndElseTheJobGoesOnAndTellsSo)
{
    table.play({{0x0000'0000, pos}, {0x0200'00FF, pos}}); // the word is in OUT: it may be taken
    EXPECT_TRUE(table.progress().hasTaken);
    cancel(OnCancel::ifNothingTaken);
    table.play({{0x0200'00FF, 0xC200'00FF}, {0x0600'0004, 0xC200'00FF}});
    EXPECT_FALSE(table.outcome());
    cancel(OnCancel::ifNothingTaken);
    EXPECT_TRUE(table.progress().hasTaken);
    cancel(OnCancel::leaveAsIs);
    table.repeat(1, {0x0600'0004, 0xC200'00FF});
    table.repeat(3, {0x0000'0000, 0xC200'00FF});
    expectCancelled(EncoderState::parameterization);
    EXPECT_EQ(table.outcome()->confirmed, (ParameterValues{{Parameter::steps, 255}}));
    EXPECT_TRUE(table.outcome()->written.empty());
}

TEST_F(K3Cancel, IfNothingWasTakenBeforeTheFirstWordNothingIsSent)
{
    cancel(OnCancel::ifNothingTaken);
    table.repeat(3, {0x0000'0000, pos});
    expectCancelled(EncoderState::operation);
}

TEST_F(K3Cancel, ARestartMeanwhileDropsWhatWasConfirmedAndIsNoFailure)
{
    table.play({{0x0000'0000, pos}, {0x0200'00FF, pos}, {0x0200'00FF, 0xC200'00FF}});
    cancel(OnCancel::restorePrevious);
    table.repeat(1, {0x0600'0004, 0xC200'00FF});
    table.repeat(3, {0x0000'0000, pos});
    expectCancelled(EncoderState::operation);
    EXPECT_TRUE(table.outcome()->confirmed.empty());
    EXPECT_TRUE(table.outcome()->written.empty());
}

// The controller sees no position by the values that were given up.
TEST_F(K3Cancel, RestoreWritesTheValuesFromBeforeWithoutARunBetween)
{
    table.play({{0x0000'0000, pos}, {0x0200'00FF, 0xC200'00FF}, {0x0600'0004, 0xC200'00FF}});
    EXPECT_TRUE(table.progress().canRestore);
    cancel(OnCancel::restorePrevious);
    table.play({
        {0x0600'0004, 0xC200'00FF},
        {0x0000'0000, 0xC200'00FF},
        {0x0200'2000, 0xC200'00FF}, // of the value before
        {0x0200'2000, 0xC200'2000},
        {0x8000'0000, pos},
        {0x0000'0000, pos},
        {0x2021'0001, 0xA000'2000}, // read back
        {0x0000'0000, pos},
        {0x0000'0000, pos},
    });
    expectCancelled(EncoderState::operation);
    EXPECT_EQ(table.outcome()->restored, Evidence::read);
    EXPECT_EQ(table.outcome()->written, (ParameterValues{{Parameter::steps, 8192}}));
    EXPECT_EQ(table.known(Parameter::steps), 8192);
    EXPECT_EQ(table.outcome()->eepromWrites, 2);
}

TEST_F(K3Cancel, ARestoredValueThatReadsBackDifferentlyIsNamed)
{
    table.play({{0x0000'0000, pos}, {0x0200'00FF, 0xC200'00FF}, {0x0600'0004, 0xC200'00FF}});
    cancel(OnCancel::restorePrevious);
    table.play({
        {0x0600'0004, 0xC200'00FF},
        {0x0000'0000, 0xC200'00FF},
        {0x0200'2000, 0xC200'00FF}, // of the value before
        {0x0200'2000, 0xC200'2000},
        {0x8000'0000, pos},
        {0x0000'0000, pos},
        {0x2021'0001, 0xA000'00FF},
        {0x0000'0000, pos},
        {0x0000'0000, pos},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error(),
              (Refusal{RefusalKind::device,
                       RefusalId::verificationFailed,
                       {Parameter::steps, std::int64_t{8192}, std::int64_t{255}}}));
    EXPECT_EQ(table.outcome()->restored, std::nullopt);
    EXPECT_TRUE(table.outcome()->written.empty());
}

// Taken from OUT before the cancel, confirmed after it
TEST_F(K3Cancel, RestoreIncludesWhatIsConfirmedAfterwards)
{
    table.play({{0x0000'0000, pos}, {0x0200'00FF, pos}});
    cancel(OnCancel::restorePrevious);
    table.play({
        {0x0200'00FF, pos},
        {0x0000'0000, 0xC200'00FF},
        {0x0200'2000, 0xC200'00FF}, // of the value before
        {0x0200'2000, 0xC200'2000},
        {0x8000'0000, pos},
        {0x0000'0000, pos},
        {0x2021'0001, 0xA000'2000},
        {0x0000'0000, pos},
        {0x0000'0000, pos},
    });
    expectCancelled(EncoderState::operation);
    EXPECT_EQ(table.known(Parameter::steps), 8192);
    EXPECT_EQ(table.outcome()->eepromWrites, 2);
}

// Where its data do not follow, the number has to be new: run comes between, whatever its answer.
TEST_F(K3Cancel, RestoreRunsFirstWhereTheNumberIsNotTakenAgain)
{
    table.play({{0x0000'0000, pos}, {0x0200'00FF, 0xC200'00FF}, {0x0600'0004, 0xC200'00FF}});
    cancel(OnCancel::restorePrevious);
    table.play({
        {0x0600'0004, 0xC200'00FF},
        {0x0000'0000, 0xC200'00FF},
    });
    table.repeat(2'000, {0x0200'2000, 0xC200'00FF});
    table.play({
        {0x8000'0000, 0x8200'0000},
        {0x0000'0000, 0x8200'0000},
        {0x0200'2000, 0xC200'2000},
        {0x8000'0000, pos},
        {0x0000'0000, pos},
        {0x2021'0001, 0xA000'2000},
        {0x0000'0000, pos},
        {0x0000'0000, pos},
    });
    expectCancelled(EncoderState::operation);
}

TEST_F(K3Cancel, RunWithWhatItHasActivatesWhatWasConfirmed)
{
    table.play({{0x0000'0000, pos}, {0x0200'00FF, 0xC200'00FF}, {0x0600'0004, 0xC200'00FF}});
    cancel(OnCancel::runWithWhatItHas);
    table.play({
        {0x0600'0004, 0xC200'00FF},
        {0x0000'0000, 0xC200'00FF},
        {0x8000'0000, 384},
        {0x0000'0000, 384},
        {0x0000'0000, 384},
    });
    expectCancelled(EncoderState::operation);
    EXPECT_EQ(table.outcome()->restored, std::nullopt);
    EXPECT_EQ(table.outcome()->written, (ParameterValues{{Parameter::steps, 255}}));
    EXPECT_EQ(table.known(Parameter::steps), 255);
}

TEST_F(K3Cancel, LeaveAsIsSendsNothingButZero)
{
    table.play({{0x0000'0000, pos}, {0x0200'00FF, 0xC200'00FF}, {0x0600'0004, 0xC200'00FF}});
    cancel(OnCancel::leaveAsIs);
    table.play({{0x0600'0004, 0xC200'00FF}, {0x0000'0000, 0xC200'00FF}, {0x0000'0000, 0xC200'00FF}});
    expectCancelled(EncoderState::parameterization);
}

TEST_F(K3Cancel, RunThatIsOnItsWayIsWaitedFor)
{
    table.play({{0x0000'0000, pos},
                {0x0200'00FF, 0xC200'00FF},
                {0x0600'0004, 0xC600'0004},
                {0x8000'0000, 0xC600'0004}});
    cancel(OnCancel::restorePrevious);
    table.play({{0x8000'0000, 384},
                {0x0000'0000, 384},
                {0x0200'2000, 0xC200'2000},
                {0x0600'0003, 0xC600'0003},
                {0x8000'0000, pos},
                {0x0000'0000, pos},
                {0x2021'0001, 0xA000'2000},
                {0x0000'0000, pos},
                {0x2021'0003, 0xA000'0003},
                {0x0000'0000, pos},
                {0x0000'0000, pos}});
    expectCancelled(EncoderState::operation);
    EXPECT_EQ(table.outcome()->restored, Evidence::read);
}

TEST_F(K3Cancel, DuringTheReadBackTheValuesStay)
{
    table.play({{0x0000'0000, pos},
                {0x0200'00FF, 0xC200'00FF},
                {0x0600'0004, 0xC600'0004},
                {0x8000'0000, 384},
                {0x0000'0000, 384},
                {0x2021'0001, 384}});
    cancel(OnCancel::leaveAsIs);
    table.play(
        {{0x2021'0001, 0xA000'00FF}, {0x0000'0000, 0xA000'00FF}, {0x0000'0000, 384}, {0x0000'0000, 384}});
    expectCancelled(EncoderState::operation);
    EXPECT_EQ(table.outcome()->written.size(), 2u);
}

// Too late to be restored, it is not reported as restored.
TEST_F(K3Cancel, WhatIsConfirmedWhileTheValuesGoBackIsNotRestored)
{
    table.play({{0x0000'0000, pos}, {0x0200'00FF, 0xC200'00FF}, {0x0600'0004, 0xC200'00FF}});
    cancel(OnCancel::restorePrevious);
    table.play({{0x0600'0004, 0xC200'00FF},
                {0x0000'0000, 0xC200'00FF},
                {0x0200'2000, 0xC600'0004},
                {0x0200'2000, 0xC200'2000},
                {0x8000'0000, pos},
                {0x0000'0000, pos},
                {0x2021'0001, 0xA000'2000},
                {0x0000'0000, pos},
                {0x0000'0000, pos}});
    expectCancelled(EncoderState::operation);
    EXPECT_EQ(table.outcome()->written, (ParameterValues{{Parameter::steps, 8192}}));
}

// What was read back before the cancel says nothing about the previous values.
TEST_F(K3Cancel, RestoreEndsWellAfterAReadBackThatDiffered)
{
    table.play({{0x0000'0000, pos},
                {0x0200'00FF, 0xC200'00FF},
                {0x0600'0004, 0xC600'0004},
                {0x8000'0000, 384},
                {0x0000'0000, 384},
                {0x2021'0001, 0xA000'2000}, // not 255
                {0x0000'0000, 384},
                {0x2021'0003, 384}});
    cancel(OnCancel::restorePrevious);
    table.play({{0x2021'0003, 0xA000'0004},
                {0x0000'0000, 384},
                {0x0600'0003, 0xC600'0003},
                {0x8000'0000, pos},
                {0x0000'0000, pos},
                {0x2021'0003, 0xA000'0003},
                {0x0000'0000, pos},
                {0x0000'0000, pos}});
    expectCancelled(EncoderState::operation);
    EXPECT_EQ(table.outcome()->restored, Evidence::read);
    EXPECT_EQ(table.outcome()->written, (ParameterValues{{Parameter::direction, 3}}));
}

TEST(K3CancelUnknown, RestoreIsNotOfferedWhereTheValuesFromBeforeAreNotKnown)
{
    DriverTable table(u"baumer-gxp6w");
    ASSERT_TRUE(table.begin(WriteParameters{.values = {{Parameter::steps, 255}, {Parameter::revolutions, 2}},
                                            .previous = {{Parameter::steps, 100}}}));
    table.play({{0x0000'0000, pos}, {0x0200'00FF, 0xC200'00FF}, {0x0400'0002, 0xC200'00FF}});
    EXPECT_TRUE(table.progress().canRestore);
    table.play({{0x0400'0002, 0xC400'0002}, {0x8000'0000, 0xC400'0002}});
    EXPECT_FALSE(table.progress().canRestore);
}

// Run would carry out the reset.
TEST(K3CancelWords, RestoreIsNotOfferedOnceAResetIsAmongThem)
{
    DriverTable table{u"fraba-ocd-ib"};
    table.tell(Parameter::multiTurnAndStepsMinusOne, 2);
    table.tell(Parameter::steps, 8192);
    ASSERT_TRUE(table.begin(SendWords{.words = {0x0E00'0000, 0x0200'00FF, 0x8000'0000}}, Pace::byHand));
    table.play({{0x0000'0000, pos}});
    table.driver().proceed();
    table.play({{0x0000'0000, pos}, {0x0E00'0000, 0xCE00'0000}});
    table.driver().proceed();
    table.play({{0x0E00'0000, 0xCE00'0000}, {0x0200'00FF, 0xC200'00FF}, {0x0200'00FF, 0xC200'00FF}});
    ASSERT_FALSE(table.progress().confirmed.empty());
    EXPECT_FALSE(table.progress().canRestore);
}

// Its old value is not known, so restoring would leave the new one.
TEST(K3CancelWords, AWordConfirmedAfterTheCancelCountsAsTaken)
{
    DriverTable table{u"fraba-ocd-ib"};
    table.tell(Parameter::multiTurnAndStepsMinusOne, 2);
    table.tell(Parameter::steps, 8192);
    ASSERT_TRUE(table.begin(SendWords{.words = {0x0200'00FF, 0x0400'0003, 0x8000'0000}}));
    table.play({{0x0000'0000, pos}, {0x0200'00FF, 0xC200'00FF}, {0x0400'0003, 0xC200'00FF}});
    table.driver().cancel(OnCancel::restorePrevious, Instant{});
    table.play({{0x0400'0003, 0xC400'0003}, {0x0000'0000, 0xC400'0003}});
    table.repeat(5, {0x0000'0000, 0xC400'0003}); // no run: it would activate revolutions = 3
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->leftIn, EncoderState::parameterization);
}

// It may be a FRABA, which sets its position in every cycle in which it sees the word.
TEST(K3MakeNotKnown, TheFrabaPresetMayNotStand)
{
    DriverTable table{u"generic-k3"};
    EXPECT_FALSE(table.driver().mayStand(0x6000'0000));
    EXPECT_TRUE(table.driver().mayStand(0x4000'0000));
}

TEST(K3EndParameterization, BringsBackAnEncoderThatWasLeftInError)
{
    DriverTable table(u"baumer-gxp6w");
    table.play({{0x0000'0000, 0x8200'0000}});
    ASSERT_TRUE(table.begin(EndParameterization{{{Parameter::revolutions, 1}}}));
    table.play({{0x0000'0000, 0x8200'0000},
                {0x0400'0001, 0xC400'0001},
                {0x8000'0000, pos},
                {0x0000'0000, pos},
                {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->restored, Evidence::echoed) << "it cannot be read";
}

TEST(K3EndParameterization, RunsAnEncoderThatWasLeftInParameterization)
{
    DriverTable table(u"fraba-ocd-ib");
    table.play({{0x0000'0000, 0xC200'00FF}});
    ASSERT_TRUE(table.begin(EndParameterization{}));
    table.play({{0x0000'0000, 0xC200'00FF}, {0x8000'0000, 384}, {0x0000'0000, 384}, {0x0000'0000, 384}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
}

} // namespace
} // namespace codewheel
