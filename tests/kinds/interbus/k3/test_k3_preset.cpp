// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/interbus/words/driver_table.h"

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
        {0x4000'0000, pos},
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
        {0x4000'0000, pos},
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
        {0x4000'0000, pos},
        {0x4000'0000, 0x0000'0064},
        {0x0000'0000, 0x0000'0064},
        {0x0000'0000, 0x0000'0064},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->alreadyThere, (ParameterValues{{Parameter::preset, 100}}));
}

DriverTable baumerWith(const ParameterValues &values)
{
    DriverTable table(u"baumer-gxp6w");
    for (const ParameterValue &value : values)
        table.tell(value.parameter, value.value.number());
    return table;
}

const ParameterValues unsignedWithOffset{
    {Parameter::steps, 8192}, {Parameter::revolutions, 1}, {Parameter::measuringRange, 4096},
    {Parameter::preset, 100}, {Parameter::coding, 3},      {Parameter::offset, 20}};

// Baumer manual 5: right after the initialisation the position is preset + offset
TEST(K3Preset, BaumerInitialisesWhatItHas)
{
    DriverTable table = baumerWith(unsignedWithOffset);
    ASSERT_TRUE(table.begin(SetPreset{}));
    table.play(
        {{0x0000'0000, pos}, {0x4000'0000, pos}, {0x4000'0000, 120}, {0x0000'0000, 120}, {0x0000'0000, 120}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->eepromWrites, 0) << "the zero offset is not stored";
    EXPECT_EQ(table.outcome()->positionAfter, 120);
}

TEST(K3Preset, BaumerShowsItInItsCoding)
{
    DriverTable table = baumerWith({{Parameter::steps, 200},
                                    {Parameter::revolutions, 1},
                                    {Parameter::measuringRange, 5},
                                    {Parameter::coding, 1},
                                    {Parameter::preset, 700},
                                    {Parameter::offset, 0}});
    ASSERT_TRUE(table.begin(SetPreset{}));
    const Word minus300 = 0x01FF'FED4;
    table.play({{0x0000'0000, 300},
                {0x4000'0000, 300},
                {0x4000'0000, minus300},
                {0x0000'0000, minus300},
                {0x0000'0000, minus300}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->positionAfter, -300);
}

class PresetOfUnknown : public testing::TestWithParam<Parameter>
{};

TEST_P(PresetOfUnknown, IsNotKnownWhateverThePositionDoes)
{
    ParameterValues told = unsignedWithOffset;
    std::erase_if(told, [](const ParameterValue &value) { return value.parameter == GetParam(); });
    DriverTable table = baumerWith(told);
    ASSERT_TRUE(table.begin(SetPreset{}));
    table.play(
        {{0x0000'0000, pos}, {0x4000'0000, pos}, {0x4000'0000, 120}, {0x0000'0000, 120}, {0x0000'0000, 120}});
    ASSERT_TRUE(table.outcome());
    const bool isShown = GetParam() != Parameter::coding;
    const RefusalArgument shown = isShown ? RefusalArgument(std::int64_t{120}) : RefusalArgument(Word{120});
    EXPECT_EQ(table.outcome()->result.error(),
              (Refusal{RefusalKind::device, RefusalId::presetNotKnownWithout, {GetParam(), shown}}));
}

INSTANTIATE_TEST_SUITE_P(Values, PresetOfUnknown,
                         testing::Values(Parameter::preset, Parameter::coding, Parameter::offset,
                                         Parameter::steps, Parameter::measuringRange));

// 40000000 stands for the whole time-out, then it is judged.
void playUntilJudged(DriverTable &table, Word shown)
{
    table.repeat(2'000, {0x4000'0000, shown});
}

TEST(K3Preset, OneThatWasNotTakenIsAFailure)
{
    DriverTable table = baumerWith(unsignedWithOffset);
    ASSERT_TRUE(table.begin(SetPreset{}));
    table.play({{0x0000'0000, pos}});
    playUntilJudged(table, pos);
    table.play({{0x0000'0000, pos}, {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(
        table.outcome()->result.error(),
        (Refusal{RefusalKind::device, RefusalId::presetNotTaken, {std::int64_t{120}, std::int64_t{pos}}}));
    EXPECT_EQ(table.outcome()->positionAfter, pos);
}

DriverTable frabaSwitchedToPositionMode()
{
    DriverTable table(u"fraba-ocd-ib");
    table.repeat(3, {0x0000'0000, pos});
    EXPECT_TRUE(table.begin(SendWords{.words = {0x2080'0000, 0x2040'0000, 0x0000'0000}}));
    table.play({{0x0000'0000, pos}});
    table.repeat(3, {0x2080'0000, pos});
    table.repeat(3, {0x2040'0000, pos});
    table.repeat(4, {0x0000'0000, pos});
    EXPECT_EQ(table.driver().reading().mode, Mode::position);
    return table;
}

class UsedUpPreset : public testing::TestWithParam<std::pair<Word, RefusalCode>>
{};

// FRABA manual 5.4.1: by its flag
TEST_P(UsedUpPreset, IsNamedAsTheCause)
{
    DriverTable table = frabaSwitchedToPositionMode();
    table.tell(Parameter::preset, 100);
    ASSERT_TRUE(table.begin(WriteParameters{.values = {{Parameter::steps, 4096}},
                                            .onlyWhatDiffers = false,
                                            .previous = {},
                                            .initialisePreset = true}));
    table.play({{0x0000'0000, pos},
                {0x2021'000A, pos},
                {0x2021'000A, 0xA000'0000},
                {0x0000'0000, pos},
                {0x0200'1000, 0xC200'1000},
                {0x8000'0000, pos},
                {0x0000'0000, pos}});
    playUntilJudged(table, pos);
    table.play({{0x0000'0000, pos},
                {0x2021'0001, 0xA000'1000},
                {0x0000'0000, pos},
                {0x2021'0006, GetParam().first},
                {0x0000'0000, pos},
                {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error(),
              (Refusal{RefusalKind::device, GetParam().second, {std::int64_t{100}, std::int64_t{pos}}}));
    EXPECT_EQ(table.outcome()->written, (ParameterValues{{Parameter::steps, 4096}})) << "that was read back";
}

INSTANTIATE_TEST_SUITE_P(Flags, UsedUpPreset,
                         testing::Values(std::pair(Word{0xA000'0000}, RefusalId::presetUsedUp),
                                         std::pair(Word{0xA000'0001}, RefusalId::presetNotTaken)));

constexpr Word usedUp = 0xA000'0000;
constexpr Word stillArmed = 0xA000'0001;

// What is read of an armed preset before it is initialised.
void playReadOfArmed(DriverTable &table, Word shown, Word preset)
{
    table.play({{0x0000'0000, shown},
                {0x2021'0006, shown},
                {0x2021'0006, stillArmed},
                {0x0000'0000, shown},
                {0x2021'0004, shown},
                {0x2021'0004, 0xA000'0000 | preset},
                {0x0000'0000, shown}});
}

void playFlag(DriverTable &table, Word shown, Word flag)
{
    table.play({{0x0000'0000, shown},
                {0x2021'0006, flag},
                {0x0000'0000, shown},
                {0x0000'0000, shown},
                {0x0000'0000, shown}});
}

// An armed preset of 100 that shows nothing, and its flag afterwards.
Outcome presetThatShowsNothing(DriverTable table, Word shown, Word flag)
{
    EXPECT_TRUE(table.begin(SetPreset{100}));
    playReadOfArmed(table, shown, 100);
    playUntilJudged(table, shown);
    playFlag(table, shown, flag);
    return table.outcome().value_or(Outcome{});
}

// In velocity mode a preset acts, and IN goes on showing the speed.
TEST(K3Preset, WhereTheModeWasOnlyToldWhatIsShownMayBeASpeed)
{
    const Outcome outcome = presetThatShowsNothing(frabaInPositionMode(), pos, usedUp);
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error(),
              (Refusal{RefusalKind::device, RefusalId::presetNotKnown, {std::int64_t{100}, pos}}));
    EXPECT_EQ(outcome.positionBefore, std::nullopt);
    EXPECT_EQ(outcome.positionAfter, std::nullopt);
    EXPECT_EQ(outcome.leftInMode, LeftMode()) << "it is not known any more";
}

// A turning shaft at 12 345 rpm, or one that stands at the preset: the position is set, whatever it was.
TEST(K3Preset, WhereTheModeWasOnlyToldNoSpeedIsGivenAsThePosition)
{
    DriverTable table = frabaInPositionMode();
    ASSERT_TRUE(table.begin(SetPreset{}));
    playReadOfArmed(table, pos, pos);
    table.repeat(200, {0x4000'0000, pos});
    table.play({{0x0000'0000, pos}, {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->positionBefore, std::nullopt);
    EXPECT_EQ(table.outcome()->positionAfter, std::nullopt);
}

TEST(K3Preset, WhatNoShaftReachesIsNoSpeed)
{
    constexpr Word far = 0x0010'0000; // 1 048 576
    const Outcome outcome = presetThatShowsNothing(frabaInPositionMode(), far, stillArmed);
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error().id, RefusalId::presetNotTaken);
    EXPECT_EQ(outcome.positionBefore, far);
}

TEST(K3Preset, AFlagThatIsStillSetProvesInAnyModeThatItWasNotTaken)
{
    const Outcome outcome = presetThatShowsNothing(frabaInPositionMode(), pos, stillArmed);
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(
        outcome.result.error(),
        (Refusal{RefusalKind::device, RefusalId::presetNotTaken, {std::int64_t{100}, std::int64_t{pos}}}));
    EXPECT_EQ(outcome.positionBefore, pos);
    EXPECT_EQ(outcome.positionAfter, pos);
    EXPECT_EQ(outcome.leftInMode, std::nullopt);
}

TEST(K3Preset, AnArmedOneThatIsUsedUpWasPerhapsCarriedOut)
{
    const Outcome outcome = presetThatShowsNothing(frabaSwitchedToPositionMode(), pos, usedUp);
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error(),
              (Refusal{RefusalKind::device, RefusalId::presetNotKnown, {std::int64_t{pos}}}));
}

// A shaft that turns 50 steps in each cycle
TEST(K3Preset, OfATurningShaftIsProvedByTheJump)
{
    DriverTable table = baumerWith(unsignedWithOffset);
    ASSERT_TRUE(table.begin(SetPreset{}));
    table.play({{0x0000'0000, 9'000},
                {0x4000'0000, 9'050},
                {0x4000'0000, 9'100},
                {0x4000'0000, 150},
                {0x0000'0000, 200},
                {0x0000'0000, 250}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
}

// It comes by the preset, as it would without one.
TEST(K3Preset, OfAShaftThatTurnsThroughItIsNotKnown)
{
    DriverTable table = baumerWith(unsignedWithOffset);
    ASSERT_TRUE(table.begin(SetPreset{}));
    table.play({{0x0000'0000, 0}});
    for (Word position = 1; position <= 2'000; ++position)
        table.play({{0x4000'0000, position}});
    table.play({{0x0000'0000, 2'001}, {0x0000'0000, 2'002}});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error().id, RefusalId::presetNotKnown);
}

TEST(K3Preset, OfAShaftThatIsThereAlreadyStandsUntilItMustHaveActed)
{
    DriverTable table = baumerWith(unsignedWithOffset);
    ASSERT_TRUE(table.begin(SetPreset{}));
    table.play({{0x0000'0000, 120}});
    table.repeat(200, {0x4000'0000, 120});
    table.repeat(2, {0x0000'0000, 120});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
}

// IN is 0 where an encoder has lost its power, or its place on the bus.
TEST(K3Preset, AZeroThatDoesNotLastIsNoPosition)
{
    DriverTable table = baumerWith({{Parameter::preset, 0}, {Parameter::coding, 3}, {Parameter::offset, 0}});
    ASSERT_TRUE(table.begin(SetPreset{}));
    table.play({{0x0000'0000, pos}, {0x4000'0000, pos}});
    table.repeat(400, {0x4000'0000, 0});
    table.repeat(1'599, {0x4000'0000, pos});
    table.repeat(2, {0x0000'0000, pos});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error().id, RefusalId::presetNotKnown);
}

TEST(K3Preset, AZeroThatLastsIsThePosition)
{
    DriverTable table = baumerWith({{Parameter::preset, 0}, {Parameter::coding, 3}, {Parameter::offset, 0}});
    ASSERT_TRUE(table.begin(SetPreset{}));
    table.play({{0x0000'0000, pos}, {0x4000'0000, pos}});
    table.repeat(1 + 500, {0x4000'0000, 0});
    table.repeat(2, {0x0000'0000, 0});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
}

// The range is not known, and 0 follows its last step.
TEST(K3Preset, TheEndOfAnUnknownRangeIsNoJump)
{
    DriverTable table = baumerWith({{Parameter::preset, 10}, {Parameter::coding, 3}, {Parameter::offset, 0}});
    ASSERT_TRUE(table.begin(SetPreset{}));
    table.play({{0x0000'0000, 9'000}});
    for (Word cycle = 1; cycle <= 2'000; ++cycle)
        table.play({{0x4000'0000, (9'000 + cycle * 10) % 10'000}});
    table.repeat(2, {0x0000'0000, 9'010});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error().id, RefusalId::presetNotKnown);
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
        {0x4000'0000, pos},
        {0x4000'0000, 0x0000'0064},
        {0x0000'0000, 0x0000'0064},
        {0x0000'0000, 0x0000'0064},
    });
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error().id, RefusalId::presetNotKnownWithout)
        << "it may have an offset";
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
