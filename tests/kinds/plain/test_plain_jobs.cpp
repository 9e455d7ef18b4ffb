// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs of encoders that the program does not know: negative numbers and texts, several values a line, and
// what is in force and what is stored.
#include "jobs/protocol.h"
#include "jobs/step_text.h"
#include "jobs/write_plan.h"
#include "journal/known_keeper.h"
#include "tests/kinds/plain/plain_bus.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::plainFilter;
using test::plainHoist;
using test::plainName;
using testing::ElementsAre;

class PlainJobs : public testing::Test
{
protected:
    PlainJobs() { bus.setOperate(true); }

    Outcome finish(const Job &job)
    {
        std::optional<Outcome> outcome;
        const auto ended = QObject::connect(&encoder, &EncoderSession::finished, &bus,
                                            [&](const Outcome &how) { outcome = how; });
        EXPECT_TRUE(encoder.start(job));
        bus.advance(100ms);
        QObject::disconnect(ended);
        EXPECT_TRUE(outcome);
        return outcome.value_or(Outcome{});
    }
    // And does not store it.
    void putInForce(const ParameterValues &values)
    {
        EXPECT_TRUE(encoder.start(WriteParameters{.values = values, .previous = {}}, Pace::byHand));
        for (int step = 0; step < 2; ++step) { // set, go
            bus.advance(5ms);
            encoder.proceed();
        }
        bus.advance(5ms);
        encoder.cancel(OnCancel::leaveAsIs);
        bus.advance(5ms);
        EXPECT_FALSE(encoder.runningJob());
    }
    std::optional<Kept> keptOf(Parameter parameter) const
    {
        const auto known = encoder.known(parameter);
        return known ? std::optional(known->kept) : std::nullopt;
    }
    RefusalCode whyNot(const ParameterValues &values)
    {
        const auto steps = encoder.planned({WriteParameters{.values = values, .previous = {}}});
        return steps ? RefusalId::nothingToDo : steps.error().id;
    }

    const Catalog catalog = Catalog::builtIn();
    test::PlainBus bus{catalog};
    EncoderSession &encoder = *bus.encoder(plainHoist);
    test::PlainNode &node = bus.node(plainHoist);
};

const ParameterValues fourValues{{Parameter::steps, 100},
                                 {Parameter::direction, 1},
                                 {Parameter::of(u"2000:1"), -5},
                                 {Parameter::of(u"1008"), Value(QStringLiteral("Hoist 2"))}};

TEST_F(PlainJobs, ALineCarriesThreeValuesAndOneStepStoresThemAll)
{
    const Outcome outcome = finish(WriteParameters{.values = fourValues, .previous = {}});
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(outcome.written, fourValues);
    EXPECT_EQ(outcome.eepromWrites, 1);
    EXPECT_EQ(node.writes(), 1);
    EXPECT_THAT(node.heard(), ElementsAre("set steps=100 direction=1 2000:1=-5", "set 1008=Hoist%202", "go",
                                          "keep", "get steps", "get direction", "get 2000:1", "get 1008"));
    for (const ParameterValue &value : fourValues) {
        const auto known = encoder.known(value.parameter);
        ASSERT_TRUE(known);
        EXPECT_EQ(known->value, value.value);
        EXPECT_EQ(known->evidence, Evidence::read);
    }
}

TEST_F(PlainJobs, AReviewNamesTheLineOfEachValueAndWhatItCosts)
{
    const WritePlan plan = planWrite(encoder, {.wanted = fourValues, .writeAll = true});
    ASSERT_FALSE(plan.refusal);
    ASSERT_EQ(plan.rows.size(), 4u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(sentText(*plan.rows[i].step), QStringLiteral("set steps=100 direction=1 2000:1=-5"));
    EXPECT_EQ(sentText(*plan.rows[3].step), QStringLiteral("set 1008=Hoist%202"));
    EXPECT_EQ(eepromWritesOf(plan.steps, encoder.device()), 1);
}

TEST_F(PlainJobs, WhatIsThereAlreadyIsLeftOut)
{
    const Outcome outcome = finish(WriteParameters{
        .values = {{Parameter::steps, 4096}, {plainName(), Value(QStringLiteral("P1"))}, {plainFilter(), 7}},
        .onlyWhatDiffers = true,
        .previous = {}});
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(outcome.written, (ParameterValues{{plainFilter(), 7}}));
    EXPECT_EQ(outcome.stored.size(), 2u) << "they were read, and perhaps not stored";
    EXPECT_TRUE(outcome.alreadyThere.empty());
    EXPECT_EQ(node.writes(), 1);
    const Outcome again = finish(
        WriteParameters{.values = {{Parameter::steps, 4096}}, .onlyWhatDiffers = true, .previous = {}});
    EXPECT_EQ(again.alreadyThere.size(), 1u);
    EXPECT_EQ(node.writes(), 1);
}

TEST_F(PlainJobs, WhatWasNotStoredIsOnlyStoredWhenItIsWrittenAgain)
{
    putInForce({{Parameter::steps, 100}});
    EXPECT_EQ(keptOf(Parameter::steps), Kept::untilPowerOff);
    const WriteWish wish{.wanted = {{Parameter::steps, 100}}};
    const WritePlan plan = planWrite(encoder, wish);
    ASSERT_EQ(plan.rows.size(), 1u);
    EXPECT_TRUE(plan.rows.front().isOnlyStored);
    EXPECT_EQ(sentText(*plan.rows.front().step), QStringLiteral("keep"));
    EXPECT_EQ(eepromWritesOf(plan.steps, encoder.device()), 1);
    const auto before = static_cast<std::ptrdiff_t>(node.heard().size());
    const Outcome outcome = finish(plan.job);
    EXPECT_TRUE(outcome.result);
    EXPECT_THAT(std::vector(node.heard().begin() + before, node.heard().end()),
                ElementsAre("get steps", "keep"));
    EXPECT_EQ(outcome.stored, wish.wanted);
    EXPECT_TRUE(outcome.written.empty());
    EXPECT_TRUE(outcome.alreadyThere.empty());
    EXPECT_EQ(outcome.eepromWrites, 1);
    EXPECT_EQ(keptOf(Parameter::steps), Kept::stored);
    EXPECT_TRUE(planWrite(encoder, wish).jobs.empty());
}

TEST_F(PlainJobs, OfAValueThatWasOnlyReadNobodyKnowsWhetherItIsStored)
{
    EXPECT_TRUE(finish(ReadParameters{{Parameter::steps, Parameter::serialNumber}}).result);
    EXPECT_EQ(keptOf(Parameter::steps), Kept::notKnown);
    EXPECT_EQ(keptOf(Parameter::serialNumber), Kept::byItself) << "nobody writes it";
    EXPECT_TRUE(finish(WriteParameters{.values = {{plainFilter(), 7}}, .previous = {}}).result);
    EXPECT_EQ(keptOf(Parameter::steps), Kept::stored) << "with all that is in force";
    EXPECT_TRUE(finish(ReadParameters{{Parameter::steps}}).result);
    EXPECT_EQ(keptOf(Parameter::steps), Kept::stored) << "it is the same value";
}

TEST_F(PlainJobs, WithoutTheAnswerToTheStoreItIsNotKnown)
{
    node.loseAnswerTo("keep");
    const Outcome outcome = finish(WriteParameters{.values = {{Parameter::steps, 100}}, .previous = {}});
    EXPECT_FALSE(outcome.result);
    EXPECT_EQ(outcome.eepromWrites, 0);
    EXPECT_EQ(outcome.inDoubt.eepromWrites, 1);
    EXPECT_EQ(keptOf(Parameter::steps), Kept::notKnown);
}

TEST_F(PlainJobs, AfterARestartOnlyWhatWasStoredIsKnown)
{
    EXPECT_TRUE(finish(WriteParameters{.values = {{Parameter::steps, 100}}, .previous = {}}).result);
    putInForce({{plainFilter(), 7}});
    bus.switchOffAndOn(plainHoist);
    EXPECT_EQ(node.inForce("steps"), "100");
    EXPECT_EQ(encoder.known(Parameter::steps)->value, 100);
    EXPECT_FALSE(encoder.known(plainFilter()));
}

TEST_F(PlainJobs, AfterALossOfSightOnlyWhatMayBeStoredIsKnownOfBefore)
{
    bus.passForReal();
    KnownKeeper keeper;
    keeper.watch(bus);
    putInForce({{Parameter::steps, 100}});
    Q_EMIT bus.meetsAgain();
    EXPECT_FALSE(encoder.knownBefore()) << "it may have been without supply meanwhile";
    EXPECT_TRUE(finish(WriteParameters{.values = {{Parameter::steps, 100}}, .previous = {}}).result);
    Q_EMIT bus.meetsAgain();
    ASSERT_TRUE(encoder.knownBefore());
    encoder.tell(Parameter::steps, std::nullopt);
    encoder.takeKnownBefore();
    EXPECT_EQ(keptOf(Parameter::steps), Kept::stored);
}

TEST_F(PlainJobs, WhatWasNotStoredIsGoneWithTheSupply)
{
    ASSERT_TRUE(
        encoder.start(WriteParameters{.values = {{Parameter::steps, 100}}, .previous = {}}, Pace::byHand));
    bus.advance(5ms);
    encoder.proceed(); // set
    bus.advance(5ms);
    EXPECT_EQ(encoder.latest().state, EncoderState::parameterization);
    EXPECT_TRUE(encoder.showsPosition());
    encoder.proceed(); // go
    bus.advance(5ms);
    EXPECT_EQ(node.inForce("steps"), "100");
    encoder.cancel(OnCancel::leaveAsIs);
    bus.advance(5ms);
    EXPECT_FALSE(encoder.runningJob());
    EXPECT_EQ(encoder.eepromWrites(), 0);
    bus.switchOffAndOn(plainHoist);
    EXPECT_EQ(node.inForce("steps"), "4096");
    EXPECT_FALSE(encoder.known(Parameter::steps));
}

TEST_F(PlainJobs, WhatDoesNotFitIsRefusedBeforeAnythingIsSent)
{
    EXPECT_EQ(whyNot({{plainFilter(), -1001}}), RefusalId::valueOutOfRange);
    EXPECT_EQ(whyNot({{plainName(), Value(QStringLiteral("seventeen letters"))}}),
              RefusalId::valueNotAllowed);
    EXPECT_EQ(whyNot({{plainName(), 5}}), RefusalId::valueNotAllowed);
    EXPECT_EQ(whyNot({{Parameter::steps, Value(QStringLiteral("many"))}}), RefusalId::valueNotAllowed);
    EXPECT_EQ(whyNot({{Parameter::coding, 1}}), RefusalId::parameterNotSupported);
    EXPECT_TRUE(node.heard().empty());
}

TEST_F(PlainJobs, ATextWhoseAnswerNobodySawIsInDoubtToo)
{
    Outcome cut;
    cut.inDoubt.values = {{plainName(), Value(QStringLiteral("Hoist"))}};
    const Protocol &protocol = protocolOf(encoder.device());
    EXPECT_TRUE(protocol.isFateUnknown(encoder, plainName(), cut, {}));
    EXPECT_FALSE(protocol.isFateUnknown(encoder, plainFilter(), cut, {}));
}

TEST_F(PlainJobs, ThePositionIsSetByItsCommand)
{
    const Outcome outcome = finish(SetPreset{.value = 500});
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(outcome.positionAfter, 500);
    EXPECT_EQ(outcome.eepromWrites, 0);
    EXPECT_THAT(node.heard(), ElementsAre("to 500"));
}

TEST_F(PlainJobs, ACancelledWriteGivesBackWhatWasThere)
{
    ASSERT_TRUE(encoder.start(
        WriteParameters{.values = {{plainFilter(), -5}}, .previous = {{plainFilter(), 3}}}, Pace::byHand));
    for (int step = 0; step < 3; ++step) { // set, go, keep
        bus.advance(5ms);
        encoder.proceed();
    }
    bus.advance(1ms);
    encoder.cancel(OnCancel::restorePrevious);
    bus.advance(100ms);
    EXPECT_EQ(node.inForce("2000:1"), "3");
}

} // namespace
} // namespace codewheel
