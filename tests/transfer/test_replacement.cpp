// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/transfer/transfer_bus.h"
#include "transfer/project_places.h"
#include "transfer/replacement.h"
#include "transfer/transfer_words.h"
#include "vocabulary/refusal_text.h"

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class Replacing : public test::TransferBus
{
protected:
    ProjectDevice planned(Place place, const char *key)
    {
        ProjectDevice device;
        device.participant = *std::ranges::find(bus.structure(), place.node, &RingDevice::number);
        device.participant.deviceKey = QString::fromLatin1(key);
        device.label.serialNumber = QStringLiteral("20417");
        device.wanted = {{Parameter::steps, 4096}, {Parameter::revolutions, 1}, {Parameter::preset, 100}};
        device.stored = {{Parameter::steps, 8192, Evidence::read, {}},
                         {Parameter::direction, 4, Evidence::read, {}},
                         {Parameter::zeroOffset, 12, Evidence::read, {}}};
        return device;
    }
    // Error 3; and what the project wants of its replacement.
    ProjectDevice frabaThatLosesItsParameters(const ParameterValues &wanted = {{Parameter::steps, 4096},
                                                                               {Parameter::revolutions, 1},
                                                                               {Parameter::direction, 3},
                                                                               {Parameter::preset, 100}})
    {
        training.controls->setFault(TrainingFault::parametersLost, fraba.node, 1);
        bus.advance(50);
        ProjectDevice device = planned(fraba, "fraba-ocd-ib");
        device.wanted = wanted;
        device.stored.clear();
        return device;
    }
    Replacement with(const char *key) const
    {
        return {catalog.find(QString::fromLatin1(key)), 0, 0, QStringLiteral("4711")};
    }

    const ProjectPlaces anywhere{{}, buses}; // a project without devices
};

TEST_F(Replacing, TheNewEncoderGetsTheValuesAndThePositionOfTheOneBefore)
{
    const ProjectDevice device = planned(fraba, "fraba-ocd-ib");
    ASSERT_TRUE(bus.name(fraba, QStringLiteral("fraba-ocd-ib"))); // nothing is known of it
    QString sent;
    QObject::connect(&encoder(fraba), &EncoderSession::exchanged, &bus,
                     [&](const Exchange &row) { sent += hexWord(row.out) + u' '; });
    bus.advance(2);
    const TransferPlan plan =
        planTransfer(buses, {wishToReplace(device, with("fraba-ocd-ib"), 3000, anywhere)});
    ASSERT_FALSE(plan[0].hindrance);
    EXPECT_THAT(transfer_words::notes(plan[0]),
                testing::Contains(QStringLiteral(
                    "Setting the position makes a new zero offset: the wanted one, 12, is left out.")));
    const TransferAccount account = carryOut(plan);
    EXPECT_TRUE(account.isDone());
    EXPECT_EQ(encoder(fraba).latest().position, 3000);
    EXPECT_EQ(encoder(fraba).known(Parameter::preset)->value, 100); // as the project wants it
    EXPECT_EQ(encoder(fraba).known(Parameter::direction)->value, 4);
    EXPECT_EQ(encoder(fraba).known(Parameter::steps)->value, 4096);
    EXPECT_TRUE(sent.contains(QStringLiteral("20800000 ")));          // position mode first
    EXPECT_TRUE(sent.contains(QStringLiteral("08000BB8 ")));          // preset 3000,
    EXPECT_TRUE(sent.contains(QStringLiteral("40000000 ")));          // acts,
    EXPECT_LT(sent.indexOf(u"40000000"), sent.indexOf(u"08000064 ")); // and is 100 again
    EXPECT_FALSE(sent.contains(QStringLiteral("0A00000C")));          // the old zero offset
}

// Error 3: what can be read is not what it works with.
TEST_F(Replacing, AnEncoderThatHasLostItsParametersGetsAllOfThem)
{
    const ProjectDevice device = frabaThatLosesItsParameters();
    ASSERT_EQ(encoder(fraba).latest().in, 0x8600'0000u);
    for (const ParameterValue &value : device.wanted) // as if it had been read
        encoder(fraba).tell(value.parameter, value.value);
    bus.advance(50);
    const TransferAccount account =
        carryOut(planTransfer(buses, {wishToReplace(device, with("fraba-ocd-ib"), std::nullopt, anywhere)}));
    EXPECT_TRUE(account.isDone());
    EXPECT_EQ(encoder(fraba).latest().state, EncoderState::operation);
    EXPECT_THAT(words(fraba).toStdString(),
                testing::HasSubstr("02001000 04000001 06000003 08000064 80000000"));
}

// It may have been read before it went, and then it is another one now.
TEST_F(Replacing, WhatWasKnownOfTheOneBeforeIsNotTakenForTheNewOnes)
{
    ASSERT_TRUE(encoder(fraba).start(ReadParameters{{Parameter::steps, Parameter::revolutions}}));
    bus.advance(2000);
    const auto steps = encoder(fraba).known(Parameter::steps);
    ASSERT_TRUE(steps && steps->evidence == Evidence::read);
    ProjectDevice device = planned(fraba, "fraba-ocd-ib");
    device.wanted = {{Parameter::steps, steps->value}};
    device.stored.clear();
    const TransferPlan plan =
        planTransfer(buses, {wishToReplace(device, with("fraba-ocd-ib"), std::nullopt, anywhere)});
    ASSERT_FALSE(plan[0].hindrance);
    EXPECT_FALSE(plan[0].write.rows.front().isThere);
    EXPECT_FALSE(plan[0].write.rows.front().known);
    EXPECT_TRUE(plan[0].write.job.onlyWhatDiffers) << "it is read first";
    EXPECT_EQ(encoder(fraba).known(Parameter::steps), steps) << "a plan forgets nothing";
    EXPECT_EQ(encoder(fraba).latest().mode, Mode::position);
    const TransferAccount account = carryOut(plan);
    EXPECT_TRUE(account.isDone());
    EXPECT_EQ(account.encoders[0].rows[0].became, Became::alreadyThere) << "found by reading";
}

// The position is its parameter 4 then: without it the encoder would not work.
TEST_F(Replacing, AnEncoderThatHasLostItsParametersGetsThePositionAsItsPreset)
{
    const ProjectDevice device = frabaThatLosesItsParameters();
    const TransferPlan plan =
        planTransfer(buses, {wishToReplace(device, with("fraba-ocd-ib"), 3000, anywhere)});
    ASSERT_FALSE(plan[0].hindrance);
    EXPECT_TRUE(plan[0].write.lostAndNotWritten.empty());
    const TransferAccount account = carryOut(plan);
    EXPECT_TRUE(account.isDone());
    EXPECT_EQ(encoder(fraba).latest().position, 3000);
    EXPECT_THAT(words(fraba).toStdString(),
                testing::HasSubstr("02001000 04000001 06000003 08000BB8 80000000"));
}

// It is left in the encoder, and no wanted one is written after it.
TEST_F(Replacing, ThePresetThatAnEncoderInErrorNeededIsInTheAccount)
{
    const ProjectDevice device = frabaThatLosesItsParameters(
        {{Parameter::steps, 4096}, {Parameter::revolutions, 1}, {Parameter::direction, 3}});
    const TransferAccount account =
        carryOut(planTransfer(buses, {wishToReplace(device, with("fraba-ocd-ib"), 3000, anywhere)}));
    ASSERT_TRUE(account.isDone());
    const EncoderAccount &its = account.encoders[0];
    const auto preset =
        std::ranges::find(its.rows, ParameterValue{Parameter::preset, 3000}, &AccountRow::wanted);
    ASSERT_NE(preset, its.rows.end());
    EXPECT_EQ(preset->became, Became::written);
    EXPECT_FALSE(its.positionBefore) << "an error is no position";
    EXPECT_EQ(its.positionAfter, 3000);
}

TEST_F(Replacing, ThePlanSaysWhatAnEncoderLacksThatHasLostItsParameters)
{
    const ProjectDevice device =
        frabaThatLosesItsParameters({{Parameter::steps, 4096}, {Parameter::revolutions, 1}});
    const TransferPlan plan =
        planTransfer(buses, {wishToReplace(device, with("fraba-ocd-ib"), std::nullopt, anywhere)});
    EXPECT_EQ(plan[0].write.lostAndNotWritten,
              (std::vector<Parameter>{Parameter::direction, Parameter::preset}));
    ASSERT_TRUE(plan[0].hindrance);
    EXPECT_THAT(refusalText(*plan[0].hindrance).toStdString(),
                testing::HasSubstr("Without a value: direction, preset"));
    EXPECT_TRUE(plan[0].jobs.empty()) << "it would spend writes, and not work";
}

// It lost them after the plan was made.
TEST_F(Replacing, NothingIsLeftOutAsAlreadyThereIfTheParametersAreLostMeanwhile)
{
    ProjectDevice device = planned(fraba, "fraba-ocd-ib");
    device.wanted = {{Parameter::steps, 4096},
                     {Parameter::revolutions, 1},
                     {Parameter::direction, 3},
                     {Parameter::preset, 100}};
    device.stored.clear();
    TransferWish wish = wishToReplace(device, with("fraba-ocd-ib"), std::nullopt, anywhere);
    wish.toPositionMode = false; // it is in position mode
    const TransferPlan plan = planTransfer(buses, {wish});
    ASSERT_TRUE(plan[0].write.job.onlyWhatDiffers);
    training.controls->setFault(TrainingFault::parametersLost, fraba.node, 1);
    bus.advance(50);
    ASSERT_EQ(encoder(fraba).latest().in, 0x8600'0000u);
    const TransferAccount account = carryOut(plan);
    EXPECT_TRUE(account.isDone());
    EXPECT_EQ(account.count(Became::written), 4);
}

TEST_F(Replacing, WhatShowsNoPositionIsNotReplaced)
{
    EncoderAccount account{.place = fraba, .isBegun = true, .leftIn = EncoderState::operation};
    EXPECT_TRUE(account.isDone());
    for (const EncoderState left : {EncoderState::error, EncoderState::parameterization,
                                    EncoderState::readOut, EncoderState::silent, EncoderState::unknown}) {
        account.leftIn = left;
        EXPECT_FALSE(account.isDone());
    }
}

TEST_F(Replacing, ABaumerTakesTheDirectionOfAFrabaAsItsCoding)
{
    const ProjectDevice device = planned(baumer, "fraba-ocd-ib");
    const TransferWish wish = wishToReplace(device, with("baumer-gxp6w"), std::nullopt, anywhere);
    EXPECT_EQ(valueOf(wish.values, Parameter::coding), 4);
    EXPECT_EQ(valueOf(wish.values, Parameter::zeroOffset), 12);
    EXPECT_FALSE(valueOf(wish.values, Parameter::direction));
    EXPECT_FALSE(planTransfer(buses, {wish})[0].hindrance);
}

TEST_F(Replacing, TellsHowTheNewOneDiffers)
{
    ProjectDevice device = planned(fraba, "baumer-gxp6w");
    device.label.stepsPerTurn = 8192;
    device.wanted.push_back({Parameter::offset, 5});
    Replacement now = with("fraba-ocd-ib");
    now.stepsPerTurn = 4096;
    const auto differences = differencesOf(device, catalog.find(u"baumer-gxp6w"), now);
    EXPECT_EQ(transfer_words::differences(differences, now),
              (QStringList{QStringLiteral("A Baumer GXP6W K3 was planned; the new one is a FRABA OCD-IB K3."),
                           QStringLiteral("It has 4096 physical steps per turn, the previous one had 8192."),
                           QStringLiteral("It has no \"Offset\": the value 5 is not written.")}));
    EXPECT_TRUE(
        differencesOf(planned(fraba, "fraba-ocd-ib"), with("fraba-ocd-ib").device, with("fraba-ocd-ib"))
            .areNone());
}

TEST_F(Replacing, EachDifferenceAloneIsOne)
{
    EXPECT_TRUE(ReplacementDifferences().areNone());
    EXPECT_FALSE(ReplacementDifferences{.makeBefore = QStringLiteral("FRABA OCD-IB K3")}.areNone());
    EXPECT_FALSE(ReplacementDifferences{.stepsPerTurn = std::pair(4096, 8192)}.areNone());
    EXPECT_FALSE(ReplacementDifferences{.turns = std::pair(4096, 1)}.areNone());
    EXPECT_FALSE((ReplacementDifferences{.notTaken = {{Parameter::offset, 5}}}.areNone()));
    EXPECT_FALSE(ReplacementDifferences{.camsNotTaken = true}.areNone());

    ProjectDevice device = planned(baumer, "baumer-gxp6w");
    device.wanted.clear();
    device.stored.clear();
    const Replacement now = with("baumer-gxp6w");
    ASSERT_TRUE(differencesOf(device, now.device, now).areNone());
    device.wantedCams = {CamProgram{}};
    EXPECT_FALSE(differencesOf(device, now.device, now).areNone()) << "it has no cams";
}

TEST_F(Replacing, OnlyTheSameDeviceCodeFits)
{
    const TransferWish wish =
        wishToReplace(planned(fraba, "fraba-ocd-ib"), with("fraba-ocd-ib-loop2"), std::nullopt, anywhere);
    EXPECT_EQ(planTransfer(buses, {wish})[0].hindrance->id, RefusalId::ringDiffers);
}

TEST_F(Replacing, TheProjectKnowsTheNewOneByItsLabel)
{
    const ProjectDevice before = planned(fraba, "fraba-ocd-ib");
    const ProjectDevice after = replaced(before, with("baumer-gxp6w"), 3000);
    EXPECT_EQ(after.participant.deviceKey, QStringLiteral("baumer-gxp6w"));
    EXPECT_EQ(after.label.serialNumber, QStringLiteral("4711"));
    EXPECT_TRUE(after.stored.empty());
    EXPECT_EQ(after.wanted, (ParameterValues{{Parameter::steps, 4096},
                                             {Parameter::revolutions, 1},
                                             {Parameter::coding, 4}, // stored as the direction of a FRABA
                                             {Parameter::preset, 100}}));
    EXPECT_EQ(after.lastPosition, before.lastPosition); // until it is set
    EXPECT_EQ(messageText(encoderReplacedMessage(before, with("baumer-gxp6w"))),
              QStringLiteral("The encoder was replaced (serial number before: 20417, now: 4711)."));
}

// What was interrupted can be repeated: nothing meant for the encoder is lost.
TEST_F(Replacing, TheProjectWantsOfTheNewOneAllThatIsWritten)
{
    ProjectDevice before = planned(fraba, "fraba-ocd-ib");
    CamProgram second;
    second.number = 2;
    CamProgram secondStored = second;
    secondStored.shift = 3;
    before.wantedCams = {second};
    before.storedCams = {{{}, Evidence::read, {}}, {secondStored, Evidence::read, {}}};
    before.stored.push_back({Parameter::offset, 5, Evidence::read, {}}); // a FRABA has none
    const Replacement now = with("fraba-ocd-ib");
    for (const std::optional<std::int64_t> position : {std::optional<std::int64_t>(), {3000}}) {
        const TransferWish first = wishToReplace(before, now, position, anywhere);
        const ProjectDevice after = replaced(before, now, position);
        const TransferWish again = wishToReplace(after, now, position, anywhere);
        EXPECT_THAT(again.values, testing::UnorderedElementsAreArray(inTurn(
                                      *now.device, {.wanted = first.values, .setPositionTo = position})));
        EXPECT_THAT(again.cams, testing::UnorderedElementsAreArray(first.cams));
        EXPECT_EQ(after.wantedCams, (std::vector<CamProgram>{{}, second}));
        EXPECT_TRUE(after.storedCams.empty());
        EXPECT_EQ(valueOf(after.wanted, Parameter::zeroOffset).has_value(), !position.has_value());
        EXPECT_FALSE(valueOf(after.wanted, Parameter::offset));
        EXPECT_EQ(replaced(after, now, 3000).wanted.size(), 4u); // never the zero offset
        EXPECT_TRUE(std::ranges::is_sorted(after.wanted, {}, &ParameterValue::parameter));
    }
}

} // namespace
} // namespace codewheel
