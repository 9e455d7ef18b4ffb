// SPDX-License-Identifier: GPL-3.0-or-later
// Encoders that are given all their values in one line, tell none of them, and keep none.
#include "bus/data_check.h"
#include "jobs/write_plan.h"
#include "journal/eeprom_cost.h"
#include "journal/known_keeper.h"
#include "tests/kinds/plain/plain_bus.h"
#include "transfer/transfer_words.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/state_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::plainFilter;
using test::plainName;
using test::telegramWinch;
using testing::ElementsAre;
using testing::HasSubstr;

class TelegramJobs : public testing::Test
{
protected:
    TelegramJobs() { bus.setOperate(true); }

    Outcome finish(const Job &job)
    {
        std::optional<Outcome> outcome;
        const auto ended = QObject::connect(&encoder, &EncoderSession::finished, &bus,
                                            [&](const Outcome &how) { outcome = how; });
        EXPECT_TRUE(encoder.start(job));
        bus.advance(20ms);
        QObject::disconnect(ended);
        EXPECT_TRUE(outcome);
        return outcome.value_or(Outcome{});
    }
    Outcome write(const ParameterValues &wanted) { return finish(jobForWish(encoder, {.wanted = wanted})); }

    const Catalog catalog = Catalog::builtIn();
    test::PlainBus bus{catalog, test::telegramStations()};
    EncoderSession &encoder = *bus.encoder(telegramWinch);
    test::TelegramNode &node = bus.telegram(telegramWinch);
};

TEST_F(TelegramJobs, OneWantedValueSendsAll)
{
    EXPECT_FALSE(encoder.showsPosition());
    const Outcome outcome = write({{plainFilter(), -5}});
    EXPECT_TRUE(outcome.result);
    EXPECT_THAT(node.heard(), ElementsAre("all steps=4096 direction=0 2000:1=-5 1008="));
    EXPECT_EQ(outcome.written.size(), 4u);
    EXPECT_EQ(outcome.eepromWrites, 0);
    EXPECT_EQ(encoder.known(Parameter::steps)->evidence, Evidence::echoed);
    EXPECT_EQ(encoder.latest().state, EncoderState::operation);
    EXPECT_EQ(encoder.latest().position, node.position());
}

TEST_F(TelegramJobs, WhatNobodyWantsGoesAlongAsItIsKnown)
{
    EXPECT_TRUE(write({{Parameter::steps, 100}, {plainName(), Value(QStringLiteral("Winch 1"))}}).result);
    EXPECT_TRUE(write({{Parameter::steps, 100}, {plainFilter(), 7}}).result);
    EXPECT_EQ(node.heard().back(), "all steps=100 direction=0 2000:1=7 1008=Winch%201");
}

TEST_F(TelegramJobs, NothingIsKeptAndNothingHasToBeStored)
{
    EXPECT_TRUE(write({{Parameter::steps, 100}}).result);
    EXPECT_EQ(encoder.known(Parameter::steps)->kept, Kept::untilPowerOff);
    const WritePlan plan = planWrite(encoder, {.wanted = {{Parameter::steps, 100}}});
    EXPECT_TRUE(plan.rows.front().isThere);
    EXPECT_TRUE(plan.jobs.empty());
}

TEST_F(TelegramJobs, AReviewShowsWhatGoesAlongAndThatItCostsNothing)
{
    const WritePlan plan = planWrite(encoder, {.wanted = {{plainFilter(), -5}}});
    ASSERT_FALSE(plan.refusal);
    ASSERT_EQ(plan.rows.size(), 4u);
    for (const WriteRow &row : plan.rows)
        EXPECT_EQ(row.isInStepOfOthers(), row.wanted.parameter != plainFilter());
    EXPECT_EQ(plan.rows.front().wanted, (ParameterValue{Parameter::steps, 4'096}));
    EXPECT_THAT(howItIsWritten(plan).join(u' ').toStdString(), HasSubstr("steps, direction, Device name"));
    EXPECT_EQ(eepromWritesOf(plan.steps, encoder.device()), 0);
    EXPECT_EQ(mostEepromWrites(encoder, plan.job), 0);
    EXPECT_TRUE(node.heard().empty());
}

TEST_F(TelegramJobs, ARefusedTelegramNamesItsValueAndChangesNothing)
{
    node.refuse("2000:1");
    const Outcome outcome = write({{Parameter::steps, 100}, {plainFilter(), 7}});
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(refusalText(outcome.result.error()).toStdString(),
              "The encoder refused the value of Filter. Check it and write again.");
    EXPECT_TRUE(outcome.written.empty());
    EXPECT_EQ(node.inForce("steps"), "4096");
    EXPECT_FALSE(encoder.known(Parameter::steps));
}

TEST_F(TelegramJobs, AfterPowerOffItHasNothingAndNothingIsKnown)
{
    EXPECT_TRUE(write({{Parameter::steps, 100}}).result);
    bus.switchOffAndOn(telegramWinch);
    bus.advance(5ms);
    EXPECT_EQ(node.inForce("steps"), "4096");
    EXPECT_EQ(encoder.latest().state, EncoderState::waiting);
    EXPECT_FALSE(encoder.showsPosition());
    for (const ParameterDescription &its : encoder.device().parameters)
        EXPECT_FALSE(encoder.known(its.parameter));
    const WritePlan plan = planWrite(encoder, {.wanted = {{Parameter::steps, 100}}});
    EXPECT_FALSE(plan.rows.front().isThere);
    EXPECT_TRUE(write({{Parameter::steps, 100}}).result);
    EXPECT_TRUE(encoder.showsPosition());
}

TEST_F(TelegramJobs, WhileItWaitsTheCheckOfItsDataSaysSo)
{
    bus.advance(5ms);
    const DataChecks checks = bus.dataChecks(telegramWinch.node, {});
    const DataCheck *state = findCheck(checks, DataCheck::Id::state);
    ASSERT_NE(state, nullptr);
    EXPECT_EQ(state->came, QStringLiteral("waiting"));
    EXPECT_EQ(state->remedy, waitingText());
    EXPECT_TRUE(transfer_words::leftIn(encoder.latest().state).startsWith(QStringLiteral("waiting")));
}

TEST_F(TelegramJobs, ValuesThatAreNotKeptAreNotKnownOfAfterALossOfSight)
{
    bus.passForReal();
    KnownKeeper keeper;
    keeper.watch(bus);
    EXPECT_TRUE(write({{Parameter::steps, 100}}).result);
    Q_EMIT bus.meetsAgain();
    EXPECT_FALSE(encoder.knownBefore()) << "it may have been without supply meanwhile";
}

TEST_F(TelegramJobs, ReadingAndSettingThePositionAreRefused)
{
    EXPECT_EQ(finish(ReadParameters{{Parameter::steps}}).result.error().id, RefusalId::readingNotSupported);
    EXPECT_EQ(finish(SetPreset{.value = 5}).result.error().id, RefusalId::presetNotSupported);
    EXPECT_TRUE(node.heard().empty());
}

} // namespace
} // namespace codewheel
