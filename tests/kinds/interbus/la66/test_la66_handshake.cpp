// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/word_refusals.h"
#include "tests/kinds/interbus/words/driver_table.h"

#include <gtest/gtest.h>

// LA-66 manual 4: service and data for two cycles, the service bit until it is acknowledged, then the service
// bit cleared with the rest unchanged, and 0 when the encoder is in normal mode again.
namespace codewheel {
namespace {

DriverTable rod(La66Timing timing = {})
{
    return DriverTable(timing);
}

WriteParameters writeLa66(ParameterValues values, bool onlyWhatDiffers = false)
{
    return WriteParameters{.values = std::move(values), .onlyWhatDiffers = onlyWhatDiffers, .previous = {}};
}

TEST(La66Driver, AWriteIsAServiceAndIsReadBack)
{
    DriverTable table = rod();
    ASSERT_TRUE(table.begin(writeLa66({{Parameter::measuringLength, 50'000}})));
    table.play({
        {0x0000'0000, pos},
        {0x4200'C350, pos},         // service and data, D31 = 0
        {0x4200'C350, pos},         // for two cycles
        {0xC200'C350, pos},         // service bit
        {0xC200'C350, pos},         // the encoder processes
        {0xC200'C350, 0xC200'C350}, // done and acknowledged
        {0x4200'C350, 0xC200'C350}, // service bit cleared, the rest unchanged
        {0x4200'C350, pos},         // the encoder is in normal mode
        {0x0200'0000, pos},         // read it back
        {0x0200'0000, pos},
        {0x8200'0000, pos},
        {0x8200'0000, 0x8200'C350},
        {0x0200'0000, 0x8200'C350},
        {0x0200'0000, pos},
        {0x0000'0000, pos},
        {0x0000'0000, pos},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->written, (ParameterValues{{Parameter::measuringLength, 50'000}}));
    EXPECT_EQ(table.outcome()->eepromWrites, 1);
    EXPECT_EQ(table.outcome()->leftIn, EncoderState::operation);
    EXPECT_EQ(table.evidence(Parameter::measuringLength), Evidence::read);
}

struct ServiceRow
{
    const char *name;
    Job job;
    Word asked;  // with the service bit
    Word answer; // in IN
};

class La66Service : public testing::TestWithParam<ServiceRow>
{};

// LA-66 manual 3: C1/81, C2/82, C4/84, C6, 88
TEST_P(La66Service, GoesOutAsTheManualSays)
{
    const auto &[name, job, asked, answer] = GetParam();
    DriverTable table = rod();
    ASSERT_TRUE(table.begin(job));
    table.play({{0, pos}, {asked & 0x7FFF'FFFF, pos}, {asked & 0x7FFF'FFFF, pos}, {asked, pos}});
    table.play({{asked, answer}, {asked & 0x7FFF'FFFF, pos}});
}

INSTANTIATE_TEST_SUITE_P(
    OfTheManual, La66Service,
    testing::Values(
        ServiceRow{"writeDirection", writeLa66({{Parameter::direction, 1}}), 0xC100'0001, 0xC100'0001},
        ServiceRow{"writeLength", writeLa66({{Parameter::measuringLength, 5'000}}), 0xC200'1388, 0xC200'1388},
        ServiceRow{"writePreset", writeLa66({{Parameter::externalPreset, 0xFF'FFFF}}), 0xC4FF'FFFF,
                   0xC4FF'FFFF},
        ServiceRow{"adjustPreset", SetPreset{.value = 1'000}, 0xC600'03E8, 0xC600'03E8},
        ServiceRow{"readDirection", ReadParameters{{Parameter::direction}}, 0x8100'0000, 0x8100'0001},
        ServiceRow{"readLength", ReadParameters{{Parameter::measuringLength}}, 0x8200'0000, 0x8200'1388},
        ServiceRow{"readPreset", ReadParameters{{Parameter::externalPreset}}, 0x8400'0000, 0x84FF'FFFF},
        ServiceRow{"readErrorStatus", ReadParameters{{Parameter::errorStatus}}, 0x8800'0000, 0x8800'0020}),
    [](const auto &row) { return row.param.name; });

TEST(La66Driver, SeveralValuesAreReadOneAfterTheOther)
{
    DriverTable table = rod();
    ASSERT_TRUE(table.begin(ReadParameters{{Parameter::direction, Parameter::errorStatus}}));
    table.play({
        {0x0000'0000, pos},
        {0x0100'0000, pos},
        {0x0100'0000, pos},
        {0x8100'0000, 0x8100'0001},
        {0x0100'0000, pos},
        {0x0800'0000, pos},
        {0x0800'0000, pos},
        {0x8800'0000, 0x8800'0020},
        {0x0800'0000, pos},
        {0x0000'0000, pos},
        {0x0000'0000, pos},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->read,
              (ParameterValues{{Parameter::direction, 1}, {Parameter::errorStatus, 32}}));
    EXPECT_EQ(table.outcome()->eepromWrites, 0);
}

TEST(La66Driver, SettingThePositionIsOneServiceThatNothingReadsBack)
{
    DriverTable table = rod();
    ASSERT_TRUE(table.begin(SetPreset{.value = 1'000}));
    table.play({
        {0x0000'0000, pos},
        {0x4600'03E8, pos},
        {0x4600'03E8, pos},
        {0xC600'03E8, 0xC600'03E8},
        {0x4600'03E8, 0x0000'03E8},
        {0x0000'0000, 0x0000'03E8},
        {0x0000'0000, 0x0000'03E8},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->positionBefore, 12'345);
    EXPECT_EQ(table.outcome()->positionAfter, 1'000);
    EXPECT_EQ(table.outcome()->eepromWrites, 1);
}

// D29: the encoder shows the last position it knew, which is not where the magnet is.
TEST(La66Driver, ThePositionIsNotSetWhileTheMagnetIsOutsideTheRange)
{
    constexpr Word magnetLost = 0x2000'0000 | pos;
    DriverTable table = rod();
    table.play({{0x0000'0000, magnetLost}});
    ASSERT_TRUE(table.begin(SetPreset{.value = 1'000}));
    table.repeat(3, {0x0000'0000, magnetLost});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error(),
              (Refusal{RefusalKind::device, RefusalId::magnetOutOfRange, {magnetLost}}));
    EXPECT_EQ(table.outcome()->leftIn, EncoderState::error);
    EXPECT_EQ(table.outcome()->eepromWrites, 0);
}

TEST(La66Driver, WhatIsAlreadyThereIsNotWrittenAgain)
{
    DriverTable table = rod();
    ASSERT_TRUE(
        table.begin(writeLa66({{Parameter::measuringLength, 50'000}, {Parameter::direction, 1}}, true)));
    table.play({
        {0x0000'0000, pos}, {0x0200'0000, pos},         {0x0200'0000, pos}, {0x8200'0000, 0x8200'C350},
        {0x0200'0000, pos}, {0x0100'0000, pos},         {0x0100'0000, pos}, {0x8100'0000, 0x8100'0000},
        {0x0100'0000, pos}, {0x4100'0001, pos}, // only what differs
        {0x4100'0001, pos}, {0xC100'0001, 0xC100'0001}, {0x4100'0001, pos}, {0x0100'0000, pos},
        {0x0100'0000, pos}, {0x8100'0000, 0x8100'0001}, {0x0100'0000, pos}, {0x0000'0000, pos},
        {0x0000'0000, pos},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->alreadyThere, (ParameterValues{{Parameter::measuringLength, 50'000}}));
    EXPECT_EQ(table.outcome()->written, (ParameterValues{{Parameter::direction, 1}}));
    EXPECT_EQ(table.outcome()->eepromWrites, 1);
}

TEST(La66Driver, AReadBackThatDiffersIsAFailureAndEndsTheJob)
{
    DriverTable table = rod();
    ASSERT_TRUE(table.begin(writeLa66({{Parameter::measuringLength, 50'000}, {Parameter::direction, 1}})));
    table.play({{0, pos}, {0x4200'C350, pos}, {0x4200'C350, pos}, {0xC200'C350, 0xC200'C350}});
    table.play({{0x4200'C350, pos},
                {0x0200'0000, pos},
                {0x0200'0000, pos},
                {0x8200'0000, 0x8200'1388},
                {0x0200'0000, 0x8200'1388},
                {0x0200'0000, pos},
                {0x0000'0000, pos},
                {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->result.error(),
              (Refusal{RefusalKind::device,
                       RefusalId::verificationFailed,
                       {Parameter::measuringLength, std::int64_t{50'000}, std::int64_t{5'000}}}));
    EXPECT_TRUE(table.outcome()->written.empty());
    EXPECT_EQ(table.known(Parameter::measuringLength), 5'000) << "what was read is what is known";
}

TEST(La66Driver, ARefusedServiceIsNamedAndOutGoesBack)
{
    DriverTable table = rod();
    ASSERT_TRUE(table.begin(writeLa66({{Parameter::measuringLength, 50'000}})));
    table.play({{0, pos},
                {0x4200'C350, pos},
                {0x4200'C350, pos},
                {0xC200'C350, 0xE200'C350},
                {0x4200'C350, 0xE200'C350},
                {0x4200'C350, pos},
                {0x0000'0000, pos},
                {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    EXPECT_EQ(
        table.outcome()->result.error(),
        (Refusal{RefusalKind::device, WordRefusalId::serviceRefused, {std::int64_t{2}, Word{0xE200'C350}}}));
    EXPECT_EQ(table.outcome()->eepromWrites, 0);
    EXPECT_EQ(table.known(Parameter::measuringLength), std::nullopt);
}

TEST(La66Driver, AnEncoderThatDoesNotAnswerIsNamedWithItsWords)
{
    DriverTable table = rod({.timeOut = std::chrono::milliseconds(50)});
    ASSERT_TRUE(table.begin(ReadParameters{{Parameter::direction}}));
    table.play({{0, pos}, {0x0100'0000, pos}, {0x0100'0000, pos}});
    table.repeat(50, {0x8100'0000, pos});
    table.play({{0x0100'0000, pos}, {0x0000'0000, pos}, {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->result.error(),
              (Refusal{RefusalKind::device, RefusalId::noAnswer, {0.05, Word{0x8100'0000}, pos}}));
}

TEST(La66Driver, AnAnswerThatNeverEndsLeavesTheRestOfTheWordStanding)
{
    DriverTable table = rod({.timeOut = std::chrono::milliseconds(50)});
    ASSERT_TRUE(table.begin(ReadParameters{{Parameter::direction}}));
    table.play({{0, pos}, {0x0100'0000, pos}, {0x0100'0000, pos}, {0x8100'0000, 0x8100'0000}});
    table.repeat(102, {0x0100'0000, 0x8100'0000});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error().id, RefusalId::noAnswer);
    EXPECT_EQ(table.outcome()->leftIn, EncoderState::service);
}

// e.g. after an ALARM STOP: OUT was zeroed while the encoder still works on a service
TEST(La66Driver, TheAnswerToAnEarlierServiceIsWaitedFor)
{
    DriverTable table = rod();
    ASSERT_TRUE(table.begin(writeLa66({{Parameter::measuringLength, 5'000}})));
    table.play({{0, pos},
                {0x4200'1388, pos},
                {0x4200'1388, 0xC200'C350}, // late
                {0x4200'1388, pos},
                {0x4200'1388, pos},
                {0xC200'1388, pos}});

    DriverTable second = rod();
    ASSERT_TRUE(second.begin(writeLa66({{Parameter::measuringLength, 5'000}})));
    second.play({{0, pos}, {0x4200'1388, pos}, {0x4200'1388, pos}, {0xC200'1388, 0xC200'C350}});
    second.repeat(5, {0xC200'1388, 0xC200'C350}); // not what was written
}

TEST(La66Driver, AServiceBitThatSomebodyLeftIsTakenBackFirst)
{
    DriverTable table = rod();
    ASSERT_TRUE(table.begin(SendWords{{0xC200'1388}, 3}));
    table.play({{0, pos}, {0x4200'1388, pos}, {0x4200'1388, pos}, {0xC200'1388, 0xC200'1388}});
    ASSERT_TRUE(table.outcome());
    ASSERT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->leftIn, EncoderState::service);

    ASSERT_TRUE(table.begin(EndParameterization{}));
    table.play({{0xC200'1388, 0xC200'1388},
                {0x4200'1388, 0xC200'1388},
                {0x4200'1388, pos},
                {0x0000'0000, pos},
                {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->leftIn, EncoderState::operation);
}

TEST(La66Driver, WordsOfTheUserGetWhatTheHandshakeNeedsInBetween)
{
    DriverTable table = rod();
    ASSERT_TRUE(table.begin(SendWords{{0xC200'C350, 0x8100'0000, 0x0000'0000}, 3}));
    table.play({{0x0000'0000, pos},
                {0x4200'C350, pos}, // inserted
                {0x4200'C350, pos},
                {0xC200'C350, 0xC200'C350},
                {0x4200'C350, pos}, // inserted
                {0x0100'0000, pos}, // inserted
                {0x0100'0000, pos},
                {0x8100'0000, 0x8100'0000},
                {0x0100'0000, pos}, // inserted
                {0x0000'0000, pos},
                {0x0000'0000, pos},
                {0x0000'0000, pos},
                {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.known(Parameter::measuringLength), 50'000);
    EXPECT_EQ(table.evidence(Parameter::measuringLength), Evidence::echoed);
    EXPECT_EQ(table.known(Parameter::direction), 0);
}

TEST(La66Driver, WordsInTheFiveStepsGoOutAsTheyAre)
{
    DriverTable table = rod();
    ASSERT_TRUE(table.begin(SendWords{{0x4200'C350, 0xC200'C350, 0x4200'C350, 0x0000'0000}, 2}));
    table.play({{0x0000'0000, pos},
                {0x4200'C350, pos},
                {0x4200'C350, pos},
                {0xC200'C350, 0xC200'C350},
                {0x4200'C350, pos},
                {0x0000'0000, pos},
                {0x0000'0000, pos},
                {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
}

TEST(La66Driver, ARefusedWordOfTheUserEndsTheSequenceWhereItIs)
{
    DriverTable table = rod();
    ASSERT_TRUE(table.begin(SendWords{{0xC300'0001, 0x0000'0000}, 3}));
    table.play({{0, pos}, {0x4300'0001, pos}, {0x4300'0001, pos}, {0xC300'0001, 0xE300'0001}});
    table.repeat(5, {0xC300'0001, 0xE300'0001});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error().id, WordRefusalId::serviceRefused);
    EXPECT_EQ(table.outcome()->leftIn, EncoderState::service);
}

struct BadRodInput
{
    const char *name;
    Job job;
    RefusalCode id;
};

class La66BadInput : public testing::TestWithParam<BadRodInput>
{};

TEST_P(La66BadInput, IsRefusedAndNothingIsSent)
{
    DriverTable table = rod();
    const Result<void> taken = table.begin(GetParam().job);
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().id, GetParam().id);
    table.repeat(10, {0x0000'0000, pos});
}

INSTANTIATE_TEST_SUITE_P(
    Rod, La66BadInput,
    testing::Values(
        BadRodInput{"noLength", writeLa66({{Parameter::measuringLength, 0}}), RefusalId::valueOutOfRange},
        BadRodInput{"tooLong", writeLa66({{Parameter::measuringLength, 0x100'0000}}),
                    RefusalId::valueOutOfRange},
        BadRodInput{"direction", writeLa66({{Parameter::direction, 2}}), RefusalId::valueNotAllowed},
        BadRodInput{"rodLength", writeLa66({{Parameter::rodLength, 500'000}}), RefusalId::parameterReadOnly},
        BadRodInput{"errorStatus", writeLa66({{Parameter::errorStatus, 0}}), RefusalId::parameterReadOnly},
        BadRodInput{"steps", writeLa66({{Parameter::steps, 255}}), RefusalId::parameterNotSupported},
        BadRodInput{"twice", writeLa66({{Parameter::direction, 0}, {Parameter::direction, 1}}),
                    RefusalId::parameterGivenTwice},
        BadRodInput{"nothing", writeLa66({}), RefusalId::nothingToDo},
        BadRodInput{"noParameters", ReadParameters{}, RefusalId::nothingToDo},
        BadRodInput{"readRodLength", ReadParameters{{Parameter::rodLength}},
                    RefusalId::parameterNotSupported},
        BadRodInput{"noWords", SendWords{{}}, RefusalId::nothingToDo},
        BadRodInput{"presetWithoutValue", SetPreset{}, RefusalId::presetNeedsValue},
        BadRodInput{"presetTooLarge", SetPreset{.value = 0x100'0000}, RefusalId::valueOutOfRange},
        BadRodInput{"negativePreset", SetPreset{.value = -1}, RefusalId::valueOutOfRange},
        BadRodInput{"frabaPreset", SetPreset{.value = 1, .command = PresetCommand::manufacturer},
                    RefusalId::manufacturerPresetNotSupported},
        BadRodInput{
            "initialise",
            WriteParameters{.values = {{Parameter::direction, 0}}, .previous = {}, .initialisePreset = true},
            RefusalId::presetNeedsValue},
        BadRodInput{"mode", SwitchMode{}, RefusalId::velocityNotSupported},
        BadRodInput{"reset", ResetToDefault{}, RefusalId::resetNotSupported},
        BadRodInput{"cams", ReadCams{{1}, {}}, RefusalId::camsNotSupported},
        BadRodInput{"writeCams", WriteCams{}, RefusalId::camsNotSupported}),
    [](const auto &row) { return row.param.name; });

TEST(La66Driver, ByHandItWaitsBeforeEachChangeOfOut)
{
    DriverTable table = rod();
    ASSERT_TRUE(table.begin(ReadParameters{{Parameter::measuringLength}}, Pace::byHand));
    table.repeat(20, {0x0000'0000, pos});
    EXPECT_TRUE(table.progress().waitsForUser);
    table.driver().proceed();
    table.play({{0x0000'0000, pos}});
    table.repeat(20, {0x0200'0000, pos});
    table.driver().proceed();
    table.play({{0x0200'0000, pos}, {0x8200'0000, pos}});
    table.repeat(20, {0x8200'0000, 0x8200'C350});
    table.driver().proceed();
    table.play({{0x8200'0000, 0x8200'C350}, {0x0200'0000, 0x8200'C350}});
    table.repeat(20, {0x0200'0000, pos});
    table.driver().proceed();
    table.play({{0x0200'0000, pos}, {0x0000'0000, pos}, {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.progress().steps.size(), 4u);
}

// Writes of earlier jobs do not belong to this one.
TEST(La66Driver, EachJobTellsItsOwnEepromWrites)
{
    DriverTable table = rod();
    for (int job = 1; job <= 3; ++job) {
        ASSERT_TRUE(table.begin(SetPreset{.value = 1'000}));
        table.play({
            {0x0000'0000, pos},
            {0x4600'03E8, pos},
            {0x4600'03E8, pos},
            {0xC600'03E8, 0xC600'03E8},
            {0x4600'03E8, 0x0000'03E8},
            {0x0000'0000, 0x0000'03E8},
            {0x0000'0000, 0x0000'03E8},
        });
        ASSERT_TRUE(table.outcome());
        EXPECT_EQ(table.outcome()->eepromWrites, 1) << job;
        EXPECT_EQ(table.eepromWrites(), job);
    }
}

} // namespace
} // namespace codewheel
