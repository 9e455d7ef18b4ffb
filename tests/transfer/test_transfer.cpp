// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/word_refusals.h"
#include "tests/transfer/transfer_bus.h"
#include "vocabulary/refusal_text.h"

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;
using test::onLoop;
using test::rod;

using Transfer = test::TransferBus;

// A parameter set for 255 steps per turn.
const ParameterValues setOf255 = {
    {Parameter::steps, 255}, {Parameter::revolutions, 1}, {Parameter::direction, 4}, {Parameter::preset, 7}};

TEST_F(Transfer, WritesOneEncoderAfterTheOtherAndTellsWhatBecameOfEachValue)
{
    const TransferPlan plan = planTransfer(
        buses, {{.place = fraba, .values = setOf255},
                {.place = baumer, .values = {{Parameter::steps, 4096}, {Parameter::coding, 6}}}});
    EXPECT_EQ(eepromWritesOf(plan), 6);
    const TransferAccount account = carryOut(plan);

    EXPECT_EQ(words(baumer), QStringLiteral("02001000 06000006 80000000"));
    // Read first (2021000A: steps minus 1?), written in order, read back.
    EXPECT_EQ(words(fraba), QStringLiteral("2021000A 20210001 20210002 20210003 20210004 "
                                           "020000FF 06000004 08000007 80000000 "
                                           "20210001 20210003 20210004"));
    ASSERT_EQ(account.encoders.size(), 2u);
    EXPECT_TRUE(account.isDone());
    EXPECT_EQ(account.count(Became::written), 5);
    EXPECT_EQ(account.count(Became::alreadyThere), 1); // FRABA: one revolution
    EXPECT_EQ(account.eepromWrites(), 5);
    EXPECT_EQ(account.encoders[0].rows[0].after->evidence, Evidence::read);
    EXPECT_EQ(account.encoders[1].rows[0].after->evidence, Evidence::echoed);
    EXPECT_EQ(account.encoders[1].leftIn, EncoderState::operation);
    EXPECT_LT(account.encoders[0].ended, account.encoders[1].ended);
    EXPECT_EQ(messageOf(account).arguments, (std::vector<RefusalArgument>{std::int64_t{2}, std::int64_t{5},
                                                                          std::int64_t{1}, std::int64_t{5}}));
}

TEST_F(Transfer, NothingIsWrittenThatIsAlreadyThere)
{
    const std::vector<TransferWish> wishes = {
        {.place = fraba, .values = setOf255},
        {.place = baumer, .values = {{Parameter::steps, 4096}, {Parameter::coding, 6}}}};
    carryOut(planTransfer(buses, wishes));
    const QString sent = words(fraba) + words(baumer);

    const TransferPlan again = planTransfer(buses, wishes);
    EXPECT_EQ(eepromWritesOf(again), 0);
    EXPECT_TRUE(jobsOf(again).empty());
    const TransferAccount account = carryOut(again);
    EXPECT_EQ(words(fraba) + words(baumer), sent);
    EXPECT_TRUE(account.isDone());
    EXPECT_EQ(account.count(Became::alreadyThere), 6);
    EXPECT_FALSE(account.encoders[0].isBegun);
}

TEST_F(Transfer, WhatAnEncoderThatCanBeReadWasToldIsReadFirst)
{
    encoder(rod).tell(Parameter::measuringLength, 50'000); // unchanged
    const TransferPlan plan = planTransfer(
        buses, {{.place = rod, .values = {{Parameter::measuringLength, 50'000}, {Parameter::direction, 1}}}});
    EXPECT_TRUE(plan[0].write.job.onlyWhatDiffers);
    EXPECT_FALSE(plan[0].write.rows[0].isThere);
    const TransferAccount account = carryOut(plan);
    EXPECT_EQ(account.count(Became::alreadyThere), 1);
    EXPECT_EQ(account.count(Became::written), 1);
    EXPECT_EQ(account.eepromWrites(), 1);
}

TEST_F(Transfer, TheValueBeforeIsTheOneThatWasReadFirst)
{
    carryOut(planTransfer(buses, {{.place = fraba, .values = {{Parameter::steps, 300}}}}));
    encoder(fraba).tell(Parameter::steps, 8192); // wrongly
    const TransferAccount account =
        carryOut(planTransfer(buses, {{.place = fraba, .values = {{Parameter::steps, 255}}}}));
    const auto &before = account.encoders[0].rows[0].before;
    ASSERT_TRUE(before);
    EXPECT_EQ(before->value, 300);
    EXPECT_EQ(before->evidence, Evidence::read);
    EXPECT_EQ(account.encoders[0].rows[0].became, Became::written);
}

TEST_F(Transfer, AnEncoderThatRefusesDoesNotKeepTheOthersFromTheirs)
{
    const ParameterValues tooMany = {{Parameter::steps, 8193}, {Parameter::revolutions, 1}};
    const TransferPlan plan = planTransfer(buses, {{.place = baumer, .values = tooMany},
                                                   {.place = onLoop, .values = {{Parameter::steps, 100}}}});
    const TransferAccount account = carryOut(plan);
    EXPECT_EQ(account.encoders[0].why->id, RefusalId::wrongParameterData);
    EXPECT_EQ(account.encoders[0].leftIn, EncoderState::error);
    EXPECT_EQ(account.encoders[0].rows[0].became, Became::notActive); // acknowledged, then refused
    EXPECT_FALSE(account.encoders[0].isDone());
    EXPECT_EQ(account.encoders[1].rows[0].became, Became::written);
}

// What run refused is pending still, also where the value that was valid before is wanted again.
TEST_F(Transfer, AfterErrorOneNothingCountsAsAlreadyThere)
{
    encoder(baumer).tell(Parameter::steps, 8192);
    encoder(baumer).tell(Parameter::coding, 3);
    const auto transfer = [&](std::int64_t steps, std::int64_t coding) {
        const TransferPlan plan = planTransfer(
            buses, {{.place = baumer, .values = {{Parameter::steps, steps}, {Parameter::coding, coding}}}});
        return carryOut(plan).encoders[0];
    };
    EXPECT_EQ(transfer(8193, 3).why->id, RefusalId::wrongParameterData);
    const EncoderAccount right = transfer(8192, 4);
    EXPECT_TRUE(right.isDone()) << refusalText(right.why.value_or(Refusal{})).toStdString();
    EXPECT_EQ(right.rows[0].became, Became::written);
    EXPECT_EQ(encoder(baumer).latest().state, EncoderState::operation);
}

TEST_F(Transfer, AnErrorThatWasThereBeforeIsNotBlamedOnWhatIsWritten)
{
    const auto transfer = [&](ParameterValue value) {
        return *carryOut(planTransfer(buses, {{.place = baumer, .values = {value}}})).encoders[0].why;
    };
    EXPECT_THAT(refusalText(transfer({Parameter::steps, 8193})).toStdString(),
                testing::HasSubstr("value of Steps"));
    EXPECT_EQ(refusalText(transfer({Parameter::coding, 3})),
              QStringLiteral("Error 1: the encoder refused a value (IN 82000000). Check the values and write "
                             "them again."));
}

TEST_F(Transfer, AfterARefusalTheRestIsNotBegunIfSoChosen)
{
    const TransferPlan plan = planTransfer(
        buses, {{.place = baumer, .values = {{Parameter::steps, 8193}, {Parameter::revolutions, 1}}},
                {.place = onLoop, .values = {{Parameter::steps, 100}}}});
    const TransferAccount account = carryOut(plan, JobRound::AfterRefusal::stop);
    EXPECT_TRUE(account.encoders[0].isBegun);
    EXPECT_FALSE(account.encoders[1].isBegun);
    EXPECT_EQ(account.encoders[1].rows[0].became, Became::notDone);
    EXPECT_EQ(words(onLoop), QString());
}

TEST_F(Transfer, CancelInTheMiddleRestoresAndBeginsNoOther)
{
    encoder(baumer).tell(Parameter::steps, 8192);
    encoder(baumer).tell(Parameter::coding, 3);
    const TransferPlan plan =
        planTransfer(buses, {{.place = baumer, .values = {{Parameter::steps, 4096}, {Parameter::coding, 6}}},
                             {.place = onLoop, .values = {{Parameter::steps, 100}}}});
    round.start(jobsOf(plan), JobRound::AfterRefusal::goOn);
    for (int i = 0; i < 1000 && round.jobProgress().confirmed.empty(); ++i)
        bus.advance(1);
    ASSERT_TRUE(round.jobProgress().canRestore);
    round.cancel(OnCancel::restorePrevious);
    advance();
    const TransferAccount account = accountOf(buses, TransferKind::write, plan, round.results());
    EXPECT_EQ(words(baumer), QStringLiteral("02001000 06000006 80000000 02002000 80000000"));
    EXPECT_EQ(account.encoders[0].why->id, RefusalId::cancelled);
    EXPECT_EQ(account.encoders[0].rows[0].became, Became::restored);
    EXPECT_EQ(account.encoders[0].rows[1].became, Became::notDone);
    EXPECT_EQ(account.encoders[0].leftIn, EncoderState::operation);
    EXPECT_FALSE(account.encoders[1].isBegun);
    EXPECT_EQ(words(onLoop), QString());
}

TEST_F(Transfer, CancelAtTheVeryEndOfAnEncoderBeginsNoOther)
{
    const TransferPlan plan = planTransfer(buses, {{.place = baumer, .values = {{Parameter::steps, 4096}}},
                                                   {.place = onLoop, .values = {{Parameter::steps, 100}}}});
    QObject::connect(&encoder(baumer), &EncoderSession::finished, &bus,
                     [this] { round.cancel(OnCancel::leaveAsIs); });
    const TransferAccount account = carryOut(plan);
    EXPECT_TRUE(account.encoders[0].isDone());
    EXPECT_FALSE(account.encoders[1].isBegun);
    EXPECT_EQ(words(onLoop), QString());
}

TEST_F(Transfer, BeginningNothingElseLeavesTheRunningJobAloneAndTheRestUndone)
{
    const TransferPlan plan =
        planTransfer(buses, {{.place = baumer, .values = {{Parameter::steps, 4096}}, .position = 100},
                             {.place = onLoop, .values = {{Parameter::steps, 100}}}});
    ASSERT_EQ(plan[0].jobs.size(), 2u);
    round.start(jobsOf(plan), JobRound::AfterRefusal::goOn);
    bus.advance(3);
    round.beginNothingElse();
    advance();
    const TransferAccount account = accountOf(buses, TransferKind::write, plan, round.results());
    EXPECT_EQ(account.encoders[0].rows[0].became, Became::written);
    EXPECT_FALSE(account.encoders[0].positionSet);
    EXPECT_EQ(account.encoders[0].why->id, RefusalId::cancelled);
    EXPECT_FALSE(account.encoders[1].isBegun);
}

TEST_F(Transfer, FinishingThisEncoderGivesItAllItsJobsAndTheOthersNone)
{
    const TransferPlan plan =
        planTransfer(buses, {{.place = baumer, .values = {{Parameter::steps, 4096}}, .position = 100},
                             {.place = onLoop, .values = {{Parameter::steps, 100}}}});
    round.start(jobsOf(plan), JobRound::AfterRefusal::goOn);
    bus.advance(3);
    round.beginNothingElse();
    round.finishThisEncoder();
    advance();
    const TransferAccount account = accountOf(buses, TransferKind::write, plan, round.results());
    EXPECT_EQ(account.encoders[0].rows[0].became, Became::written);
    EXPECT_EQ(account.encoders[0].why->id, RefusalId::presetNotKnownWithout) << "the preset was sent, too";
    EXPECT_FALSE(account.encoders[1].isBegun);
}

TEST_F(Transfer, WhatWasTakenAndNotMadeValidIsAccountedForSo)
{
    const TransferPlan plan = planTransfer(
        buses, {{.place = baumer, .values = {{Parameter::steps, 4096}, {Parameter::coding, 6}}}});
    round.start(jobsOf(plan), JobRound::AfterRefusal::goOn);
    for (int i = 0; i < 1000 && round.jobProgress().confirmed.empty(); ++i)
        bus.advance(1);
    round.cancel(OnCancel::leaveAsIs);
    advance();
    const TransferAccount account = accountOf(buses, TransferKind::write, plan, round.results());
    EXPECT_EQ(account.encoders[0].leftIn, EncoderState::parameterization);
    EXPECT_EQ(account.encoders[0].rows[0].became, Became::confirmed);
    EXPECT_FALSE(account.encoders[0].isDone());
}

TEST_F(Transfer, AnEncoderThatLosesPowerInTheMiddleIsNamedAndTheNextOneIsWritten)
{
    const TransferPlan plan =
        planTransfer(buses, {{.place = baumer, .values = {{Parameter::steps, 4096}, {Parameter::coding, 6}}},
                             {.place = onLoop, .values = {{Parameter::steps, 100}}}});
    round.start(jobsOf(plan), JobRound::AfterRefusal::goOn);
    for (int i = 0; i < 1000 && round.jobProgress().confirmed.empty(); ++i)
        bus.advance(1);
    training.controls->powerCycle(baumer.node);
    advance();
    const TransferAccount account = accountOf(buses, TransferKind::write, plan, round.results());
    EXPECT_EQ(account.encoders[0].why->id, WordRefusalId::restarted);
    EXPECT_EQ(account.encoders[0].rows[0].became, Became::notDone);
    EXPECT_EQ(account.encoders[0].eepromWrites, 1); // it had confirmed one
    EXPECT_EQ(account.encoders[1].rows[0].became, Became::written);
}

TEST_F(Transfer, AlarmStopEndsItAll)
{
    const TransferPlan plan = planTransfer(buses, {{.place = baumer, .values = {{Parameter::steps, 4096}}},
                                                   {.place = onLoop, .values = {{Parameter::steps, 100}}}});
    round.start(jobsOf(plan), JobRound::AfterRefusal::goOn);
    bus.advance(3);
    bus.alarmStop();
    bus.advance(2);
    EXPECT_FALSE(round.isRunning());
    const TransferAccount account = accountOf(buses, TransferKind::write, plan, round.results());
    EXPECT_EQ(account.encoders[0].why->id, RefusalId::alarmStop);
    EXPECT_FALSE(account.encoders[1].isBegun);
}

TEST_F(Transfer, CamProgramsAreWrittenAndTheModeIsAsBefore)
{
    CamProgram program;
    program.cam[3] = {0x15, 0x213, true};
    const TransferPlan plan = planTransfer(buses, {{.place = fraba, .cams = {program}}});
    EXPECT_EQ(plan[0].eepromWrites, 1);
    const TransferAccount account = carryOut(plan);
    EXPECT_EQ(account.encoders[0].cams[0].became, Became::written);
    EXPECT_EQ(account.eepromWrites(), 1);
    EXPECT_EQ(encoder(fraba).latest().mode, Mode::position);

    const TransferPlan again = planTransfer(buses, {{.place = fraba, .cams = {program}}});
    EXPECT_TRUE(again[0].cams[0].isThere);
    EXPECT_TRUE(jobsOf(again).empty());
}

TEST_F(Transfer, ACamProgramThatIsFoundThereAndOneThatIsNotFinishedAreToldApart)
{
    CamProgram first;
    first.cam[3] = {0x15, 0x213, true};
    CamProgram second;
    second.number = 2;
    second.cam[0] = {0x10, 0x20, true};
    ASSERT_TRUE(carryOut(planTransfer(buses, {{.place = fraba, .cams = {first}}})).isDone());
    ASSERT_TRUE(bus.name(fraba, QStringLiteral("fraba-ocd-ib"))); // nothing is known of it
    encoder(fraba).tell(Parameter::startUpMode, 1);
    bus.advance(10);

    const TransferPlan plan = planTransfer(buses, {{.place = fraba, .cams = {first, second}}});
    ASSERT_FALSE(plan[0].cams[0].isThere);
    round.start(jobsOf(plan), JobRound::AfterRefusal::goOn);
    for (int i = 0; i < 10'000 && !round.jobProgress().hasTaken; ++i)
        bus.advance(1);
    ASSERT_TRUE(round.jobProgress().hasTaken);
    round.cancel(OnCancel::leaveAsIs);
    advance();
    const TransferAccount account = accountOf(buses, TransferKind::write, plan, round.results());
    ASSERT_EQ(account.encoders[0].cams.size(), 2u);
    EXPECT_EQ(account.encoders[0].cams[0].became, Became::alreadyThere);
    EXPECT_EQ(account.encoders[0].cams[1].became, Became::notDone);
    EXPECT_FALSE(account.isDone());
}

TEST_F(Transfer, TellsWhichEncoderRunsAndHowFarItIs)
{
    EXPECT_EQ(round.progress().encoders, 0);
    const TransferPlan plan = planTransfer(buses, {{.place = baumer, .values = {{Parameter::steps, 4096}}},
                                                   {.place = onLoop, .values = {{Parameter::steps, 100}}}});
    std::map<Place, RoundProgress> last;
    QObject::connect(&round, &JobRound::progressed, &bus, [&] {
        if (!round.isRunning())
            return;
        const RoundProgress now = round.progress();
        EXPECT_EQ(now.encoders, 2);
        EXPECT_EQ(now.encoder, now.place == onLoop ? 1 : 0);
        EXPECT_EQ(now.place, plan[static_cast<std::size_t>(now.encoder)].place);
        EXPECT_LE(now.step, now.steps);
        last[now.place] = now;
    });
    ASSERT_TRUE(carryOut(plan).isDone());
    for (const Place place : {baumer, onLoop}) {
        EXPECT_GT(last[place].steps, 0) << place.toString().toStdString();
        EXPECT_EQ(last[place].step, last[place].steps - 1);
    }
    EXPECT_EQ(round.progress().place, onLoop) << "the last one, when it is over";
    EXPECT_EQ(round.progress().encoder, 1);
}

// Naming it replaces its session: the outcome of the round stays.
TEST_F(Transfer, AnEncoderIsNamedAfterItsRound)
{
    int finished = 0;
    QObject::connect(&round, &JobRound::finished, &bus, [&] { ++finished; });
    ASSERT_TRUE(carryOut(planTransfer(buses, {{.place = fraba, .values = setOf255},
                                              {.place = baumer, .values = {{Parameter::steps, 4096}}}}))
                    .isDone());
    for (const Place place : {fraba, baumer})
        ASSERT_TRUE(bus.name(place, encoder(place).device().key));
    bus.advance(100);
    EXPECT_EQ(finished, 1);
    EXPECT_FALSE(round.isRunning());
    ASSERT_EQ(round.results().size(), 2u);
    for (const EncoderResult &result : round.results()) {
        EXPECT_FALSE(result.why);
        EXPECT_EQ(result.outcomes.size(), 1u);
    }
}

} // namespace
} // namespace codewheel
