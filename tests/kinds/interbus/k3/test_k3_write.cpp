// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/word_refusals.h"
#include "tests/kinds/interbus/words/driver_table.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

WriteParameters write(ParameterValues values, bool onlyWhatDiffers = false)
{
    return WriteParameters{.values = std::move(values), .onlyWhatDiffers = onlyWhatDiffers, .previous = {}};
}

TEST(K3Write, FrabaIsWrittenRunAndReadBack)
{
    DriverTable table(u"fraba-ocd-ib");
    table.tell(Parameter::multiTurnAndStepsMinusOne, 2);
    ASSERT_TRUE(table.begin(write({{Parameter::steps, 255}, {Parameter::direction, 3}})));
    table.play({
        {0x0000'0000, pos},
        {0x0200'00FF, 0xC200'00FF},
        {0x0600'0003, 0xC200'00FF},
        {0x0600'0003, 0xC600'0003},
        {0x8000'0000, 0xC600'0003},
        {0x8000'0000, 384},
        {0x0000'0000, 384},
        {0x2021'0001, 384},
        {0x2021'0001, 0xA000'00FF},
        {0x0000'0000, 0xA000'00FF},
        {0x0000'0000, 384},
        {0x2021'0003, 384},
        {0x2021'0003, 0xA000'0003},
        {0x0000'0000, 384},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->written,
              (ParameterValues{{Parameter::steps, 255}, {Parameter::direction, 3}}));
    EXPECT_EQ(table.outcome()->eepromWrites, 2);
    EXPECT_EQ(table.known(Parameter::steps), 255);
    EXPECT_EQ(table.evidence(Parameter::steps), Evidence::read);
}

TEST(K3Write, BaumerIsEchoedAndMustStayInOperation)
{
    DriverTable table(u"baumer-gxp6w", {.settle = std::chrono::milliseconds(3)});
    ASSERT_TRUE(table.begin(write({{Parameter::coding, 4}})));
    table.play(
        {{0x0000'0000, pos}, {0x0600'0004, pos}, {0x0600'0004, 0xC000'0004}, {0x0600'0004, 0xC600'0004}});
    table.repeat(3, {0x0600'0004, 0xC600'0004});
    table.play({{0x8000'0000, 0xC600'0004}, {0x8000'0000, 100}});
    table.repeat(4, {0x0000'0000, 100});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.evidence(Parameter::coding), Evidence::echoed);
    EXPECT_EQ(table.driver().reading().position, 100)
        << "the coding is known now, so the position can be read";
}

TEST(K3Write, AnErrorSoonAfterRunIsStillAnError)
{
    DriverTable table(u"baumer-gxp6w", {.settle = std::chrono::milliseconds(3)});
    ASSERT_TRUE(table.begin(write({{Parameter::coding, 4}})));
    table.play({{0x0000'0000, pos}});
    table.repeat(4, {0x0600'0004, 0xC600'0004});
    table.play({{0x8000'0000, 100}, {0x0000'0000, 100}, {0x0000'0000, 0x9A00'0000}});
    table.repeat(5, {0x0000'0000, 0x9A00'0000});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->result.error().id, RefusalId::eepromStoreError);
}

TEST(K3Write, OldConfirmationIsNotTakenForTheNewParameter)
{
    DriverTable table(u"fraba-ocd-ib", {.settle = Instant{0}, .timeOut = std::chrono::milliseconds(50)});
    table.tell(Parameter::multiTurnAndStepsMinusOne, 2);
    ASSERT_TRUE(table.begin(write({{Parameter::steps, 255}, {Parameter::revolutions, 1}})));
    table.play({{0x0000'0000, pos}, {0x0200'00FF, 0xC200'00FF}});
    table.repeat(50, {0x0400'0001, 0xC200'0100}); // the manual prints C2000100 here
    table.repeat(3, {0x0000'0000, 0xC200'0100});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    const Refusal &refusal = table.outcome()->result.error();
    EXPECT_EQ(refusal.id, RefusalId::noAnswer);
    EXPECT_EQ(refusal.arguments, (std::vector<RefusalArgument>{0.05, Word{0x0400'0001}, Word{0xC200'0100}}));
    EXPECT_EQ(table.outcome()->leftIn, EncoderState::parameterization);
}

// FRABA confirms first and refuses later
TEST(K3Write, AConfirmationThatIsTakenBackWithinTheSettleTimeIsNone)
{
    DriverTable table(u"fraba-ocd-ib", {.settle = std::chrono::milliseconds(20)});
    table.tell(Parameter::multiTurnAndStepsMinusOne, 2);
    ASSERT_TRUE(table.begin(write({{Parameter::steps, 255}})));
    table.play({{0x0000'0000, pos}, {0x0200'00FF, pos}});
    table.repeat(20, {0x0200'00FF, 0xC200'00FF});
    table.play({{0x0200'00FF, 0x8200'0000}, {0x0000'0000, 0x8200'0000}});
    table.repeat(25, {0x0000'0000, 0x8200'0000});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->result.error().arguments,
              (std::vector<RefusalArgument>{Parameter::steps, Word{0x8200'0000}}));
    EXPECT_EQ(table.known(Parameter::steps), std::nullopt);
}

TEST(K3Write, ALateErrorNamesEveryParameterItMayBeAbout)
{
    DriverTable table(u"fraba-ocd-ib");
    table.tell(Parameter::multiTurnAndStepsMinusOne, 2);
    ASSERT_TRUE(table.begin(
        write({{Parameter::steps, 255}, {Parameter::revolutions, 1}, {Parameter::direction, 3}})));
    table.play({{0x0000'0000, pos},
                {0x0200'00FF, 0xC200'00FF},
                {0x0400'0001, 0xC400'0001},
                {0x0600'0003, 0x8200'0000},
                {0x0000'0000, 0x8200'0000},
                {0x0000'0000, 0x8200'0000}});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(
        table.outcome()->result.error().arguments,
        (std::vector<RefusalArgument>{Parameter::revolutions, Parameter::direction, Word{0x8200'0000}}));
}

TEST(K3Write, WhatIsAlreadyThereIsNotWrittenAgain)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(write({{Parameter::steps, 255}, {Parameter::revolutions, 1}}, true)));
    table.play({
        {0x0000'0000, pos},
        {0x2021'000A, pos},
        {0x2021'000A, 0xA000'0002},
        {0x0000'0000, pos},
        {0x2021'0001, 0xA000'2000},
        {0x0000'0000, 0xA000'2000},
        {0x0000'0000, pos},
        {0x2021'0002, 0xA000'0001},
        {0x0000'0000, pos},
        {0x0200'00FF, 0xC200'00FF},
        {0x8000'0000, 384},
        {0x0000'0000, 384},
        {0x2021'0001, 384},
        {0x2021'0001, 0xA000'00FF},
        {0x0000'0000, 384},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->written, (ParameterValues{{Parameter::steps, 255}}));
    EXPECT_EQ(table.outcome()->alreadyThere, (ParameterValues{{Parameter::revolutions, 1}}));
    EXPECT_EQ(table.outcome()->eepromWrites, 1);
}

TEST(K3Write, NothingIsSentButReadOutsWhereAllIsThere)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(write({{Parameter::revolutions, 1}}, true)));
    table.play({{0x0000'0000, pos},
                {0x2021'0002, pos},
                {0x2021'0002, 0xA000'0001},
                {0x0000'0000, pos},
                {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->eepromWrites, 0);
    EXPECT_EQ(table.known(Parameter::revolutions), 1);
}

// "steps minus 1" encoders expect and read out steps - 1
TEST(K3Write, AStepsMinusOneEncoderIsSentStepsMinusOne)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(write({{Parameter::steps, 4096}})));
    table.play({
        {0x0000'0000, pos},
        {0x2021'000A, pos},
        {0x2021'000A, 0xA000'0003},
        {0x0000'0000, pos},
        {0x0200'0FFF, 0xC200'0FFF},
        {0x8000'0000, pos},
        {0x0000'0000, pos},
        {0x2021'0001, pos},
        {0x2021'0001, 0xA000'0FFF},
        {0x0000'0000, pos},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.known(Parameter::steps), 4096);
}

TEST(K3Write, AReadBackThatDiffersIsAFailure)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(write({{Parameter::revolutions, 2}})));
    table.play({{0x0000'0000, pos},
                {0x0400'0002, 0xC400'0002},
                {0x8000'0000, pos},
                {0x0000'0000, pos},
                {0x2021'0002, pos},
                {0x2021'0002, 0xA000'0001},
                {0x0000'0000, pos},
                {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->result.error(),
              (Refusal{RefusalKind::device,
                       RefusalId::verificationFailed,
                       {Parameter::revolutions, std::int64_t{2}, std::int64_t{1}}}));
    EXPECT_EQ(table.known(Parameter::revolutions), 1) << "what was read is what is known";
}

struct BadInput
{
    const char *name;
    Job job;
    RefusalCode id;
};

class K3BadInput : public testing::TestWithParam<BadInput>
{};

TEST_P(K3BadInput, IsRefusedAndNothingIsSent)
{
    DriverTable table(u"baumer-gxp6w");
    const Result<void> taken = table.begin(GetParam().job);
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().id, GetParam().id);
    table.repeat(10, {0x0000'0000, pos});
}

INSTANTIATE_TEST_SUITE_P(
    Baumer, K3BadInput,
    testing::Values(
        BadInput{"tooManySteps", write({{Parameter::steps, 33'554'432}}), RefusalId::valueOutOfRange},
        BadInput{"noSteps", write({{Parameter::steps, 0}}), RefusalId::valueOutOfRange},
        BadInput{"negative", write({{Parameter::preset, -1}}), RefusalId::valueOutOfRange},
        BadInput{"coding", write({{Parameter::coding, 7}}), RefusalId::valueNotAllowed},
        BadInput{"lacksDirection", write({{Parameter::direction, 3}}), RefusalId::parameterNotSupported},
        BadInput{"twice", write({{Parameter::steps, 1}, {Parameter::steps, 2}}),
                 RefusalId::parameterGivenTwice},
        BadInput{"nothing", write({}), RefusalId::nothingToDo},
        BadInput{"noReadOut", ReadParameters{{Parameter::steps}}, RefusalId::readingNotSupported},
        BadInput{"noWords", SendWords{{}}, RefusalId::nothingToDo}),
    [](const auto &row) { return row.param.name; });

TEST(K3Write, ReadOnlyValuesAreNotWritten)
{
    DriverTable table(u"fraba-ocd-ib");
    const Result<void> taken = table.begin(write({{Parameter::serialNumber, 1}}));
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().id, RefusalId::parameterReadOnly);
}

TEST(K3Write, ASecondJobIsRefusedWhileOneRuns)
{
    DriverTable table(u"baumer-gxp6w");
    ASSERT_TRUE(table.begin(write({{Parameter::preset, 5}})));
    table.play({{0x0000'0000, pos}, {0x0800'0005, pos}});
    const Result<void> second = table.begin(write({{Parameter::preset, 6}}));
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().id, RefusalId::jobRunning);
    table.play({{0x0800'0005, pos}});
}

TEST(K3Write, AnEncoderFoundInParameterizationIsNotWritten)
{
    DriverTable table(u"fraba-ocd-ib");
    table.play({{0x0000'0000, 0xC200'0064}});
    const Result<void> taken = table.begin(write({{Parameter::direction, 3}}));
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error(),
              (Refusal{RefusalKind::busy, RefusalId::inParameterization, {Word{0xC200'0064}}}));
}

TEST(K3Write, OutIsClearedFirstWhereSomethingStandsThere)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(SendWords{.words = {0x2021'0000}}));
    table.play(
        {{0x0000'0000, pos}, {0x2021'0000, pos}, {0x2021'0000, 0xA000'04D2}, {0x2021'0000, 0xA000'04D2}});
    ASSERT_TRUE(table.begin(ReadParameters{{Parameter::preset}}));
    table.play({{0x2021'0000, 0xA000'04D2},
                {0x0000'0000, 0xA000'04D2},
                {0x0000'0000, pos},
                {0x2021'0004, pos},
                {0x2021'0004, 0xA000'0007},
                {0x0000'0000, pos}});
    EXPECT_EQ(table.known(Parameter::preset), 7);
    EXPECT_EQ(table.known(Parameter::serialNumber), 1234);
}

// Run would activate what others have sent.
TEST(K3Write, AParameterizationThatAReadOutHidIsSeenOnceOutIsCleared)
{
    DriverTable table(u"fraba-ocd-ib");
    table.play({{0x0000'0000, 0xC200'0064}});
    ASSERT_TRUE(table.begin(SendWords{.words = {0x2021'0000}}));
    table.play({{0x0000'0000, 0xC200'0064},
                {0x2021'0000, 0xC200'0064},
                {0x2021'0000, 0xA000'04D2},
                {0x2021'0000, 0xA000'04D2}});
    ASSERT_TRUE(table.begin(write({{Parameter::direction, 3}})));
    table.play({{0x2021'0000, 0xA000'04D2},
                {0x0000'0000, 0xA000'04D2},
                {0x0000'0000, 0xC200'0064},
                {0x0000'0000, 0xC200'0064}});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->result.error(),
              (Refusal{RefusalKind::busy, RefusalId::inParameterization, {Word{0xC200'0064}}}));
    EXPECT_EQ(table.outcome()->eepromWrites, 0);
}

TEST(K3Write, StopEndsTheJobWhereItStands)
{
    DriverTable table(u"baumer-gxp6w");
    ASSERT_TRUE(table.begin(write({{Parameter::preset, 5}})));
    table.play({{0x0000'0000, pos}, {0x0800'0005, pos}});
    table.driver().stop({RefusalKind::stopped, RefusalId::alarmStop, {}}, Instant{});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error(), (Refusal{RefusalKind::stopped, RefusalId::alarmStop, {}}));
    EXPECT_FALSE(table.driver().busy());
}

TEST(K3Write, AnEncoderThatRestartsMustConfirmAllAgain)
{
    DriverTable table(u"baumer-gxp6w");
    ASSERT_TRUE(table.begin(WriteParameters{.values = {{Parameter::steps, 255}, {Parameter::revolutions, 2}},
                                            .onlyWhatDiffers = false,
                                            .previous = {}}));
    table.play({{0x0000'0000, pos},
                {0x0200'00FF, 0xC200'00FF},
                {0x0400'0002, 0xC200'00FF},
                {0x0400'0002, 0x0000'0000},
                {0x0000'0000, 0x0000'0000},
                {0x0000'0000, 0xC000'0000}});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error(),
              (Refusal{RefusalKind::device, WordRefusalId::restarted, {Word{0x0000'0000}}}));
    EXPECT_TRUE(table.outcome()->written.empty());
}

// 00000000 after run is position 0, or an encoder that has lost its power.
TEST(K3Write, ChecksAtStartUpAfterRunAreNoOperation)
{
    DriverTable table(u"baumer-gxp6w");
    ASSERT_TRUE(table.begin(WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}));
    table.play({{0x0000'0000, pos}, {0x0200'00FF, 0xC200'00FF}, {0x8000'0000, 0x0000'0000}});
    table.repeat(50, {0x8000'0000, 0x0000'0000});
    EXPECT_FALSE(table.known(Parameter::steps));
    table.play({{0x8000'0000, 0xC000'0000}, {0x0000'0000, 0xC000'0000}, {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error().id, WordRefusalId::restarted);
    EXPECT_FALSE(table.known(Parameter::steps));
}

TEST(K3Write, PositionZeroAfterRunIsTakenWithANoteAndKnownOnceTheShaftTurns)
{
    DriverTable table(u"baumer-gxp6w");
    ASSERT_TRUE(table.begin(WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}));
    table.play({{0x0000'0000, pos}, {0x0200'00FF, 0xC200'00FF}});
    table.repeat(501, {0x8000'0000, 0x0000'0000});
    table.play({{0x0000'0000, 0x0000'0000}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_TRUE(table.outcome()->onlyZeroSinceRun);
    EXPECT_FALSE(table.known(Parameter::steps));
    table.play({{0x0000'0000, 0x0000'0001}});
    EXPECT_EQ(table.known(Parameter::steps), 255);
}

TEST(K3Write, TheStateIsLookedAtInTheFirstCycleOfTheBus)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(WriteParameters{.values = {{Parameter::direction, 4}}, .previous = {}}));
    table.repeat(3, {0x0000'0000, 0xC200'00FF});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->result.error().id, RefusalId::inParameterization);
}

TEST(K3Write, AReadBackThatDiffersDoesNotKeepTheOthersFromBeingRead)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(table.begin(
        WriteParameters{.values = {{Parameter::revolutions, 2}, {Parameter::direction, 4}}, .previous = {}}));
    table.play({{0x0000'0000, pos},
                {0x0400'0002, 0xC400'0002},
                {0x0600'0004, 0xC600'0004},
                {0x8000'0000, pos},
                {0x0000'0000, pos},
                {0x2021'0002, pos},
                {0x2021'0002, 0xA000'0001},
                {0x0000'0000, pos},
                {0x2021'0003, pos},
                {0x2021'0003, 0xA000'0003},
                {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error(),
              (Refusal{RefusalKind::device,
                       RefusalId::verificationFailed,
                       {Parameter::revolutions, std::int64_t{2}, std::int64_t{1}}}));
    EXPECT_TRUE(table.outcome()->written.empty());
    EXPECT_EQ(table.known(Parameter::direction), 3);
}

} // namespace
} // namespace codewheel
