// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/value_notes.h"
#include "tests/kinds/interbus/words/driver_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Id = ValueNote::Id;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> textsOf(QStringView device, const ParameterValues &written,
                                 const ParameterValues &known = {}, PositionIsSet set = PositionIsSet::yes)
{
    std::vector<std::string> texts;
    for (const ValueNote &note : valueNotes(describe(device), written, known, set))
        texts.push_back(noteText(note).toStdString());
    return texts;
}

std::vector<Id> idsOf(QStringView device, const ParameterValues &written, const ParameterValues &known,
                      PositionIsSet set = PositionIsSet::no)
{
    std::vector<Id> ids;
    for (const ValueNote &note : valueNotes(describe(device), written, known, set))
        ids.push_back(note.id);
    return ids;
}

// Baumer manual 5: 200 steps, 5 turns give 0..999. 4096 turns are 819 200 steps, with 200 in the last round.
TEST(ValueNotes, AMeasuringRangeThatDoesNotDivideTheTurnsJumps)
{
    const ParameterValues scale{{Parameter::steps, 200}, {Parameter::revolutions, 1}};
    EXPECT_THAT(
        textsOf(u"baumer-gxp6w", {{Parameter::measuringRange, 5}}, scale),
        ElementsAre("The measuring range of 5 turns does not divide the 4096 turns of the encoder: the "
                    "position jumps by 200 steps after turn 4096."));
    EXPECT_THAT(
        textsOf(u"baumer-gxp6w", {{Parameter::measuringRange, 5}}),
        ElementsAre("The measuring range of 5 turns does not divide the 4096 turns of the encoder: the "
                    "position jumps after turn 4096."))
        << "nothing is known of the steps";
    EXPECT_THAT(textsOf(u"baumer-gxp6w", {{Parameter::measuringRange, 8}}, scale), IsEmpty());
    EXPECT_THAT(textsOf(u"baumer-gxp6w", {{Parameter::measuringRange, 8}}), IsEmpty());
}

TEST(ValueNotes, StepsThatGiveNoWholeRangeJumpToo)
{
    const ParameterValues thirds{{Parameter::steps, 1000}, {Parameter::revolutions, 3}};
    EXPECT_THAT(textsOf(u"fraba-ocd-ib", thirds),
                ElementsAre("1000 steps in 3 revolutions give no whole number of steps over 4096 turns: the "
                            "position jumps by a fraction of a step after turn 4096."));
    EXPECT_THAT(textsOf(u"baumer-gxp6w", thirds, {{Parameter::measuringRange, 8}}),
                ElementsAre("1000 steps in 3 revolutions give no whole number of steps over 8 turns: the "
                            "position jumps by 341 steps after turn 4096."));
}

// 100 of 4096 turns: 40 rounds and 96 turns of 1000 steps, 4000 before the end of the range.
TEST(ValueNotes, RevolutionsOfASerialEncoderThatDoNotDivideItsTurnsJump)
{
    const QStringView device = u"kuebler-esc-rs485";
    const ParameterValues written{{Parameter::steps, 1000}, {Parameter::revolutions, 100}};
    const ParameterValues on{{Parameter::scaling, 1}};
    const ParameterValues off{{Parameter::scaling, 0}};
    EXPECT_THAT(textsOf(device, written, on),
                ElementsAre("The 100 revolutions do not divide the 4096 turns of the encoder: the position "
                            "jumps by 4000 steps after turn 4096."));
    EXPECT_THAT(idsOf(device, written, off), ElementsAre(Id::scalingOff)) << "nothing is scaled";
    EXPECT_THAT(idsOf(device, written, {}, PositionIsSet::yes),
                ElementsAre(Id::scalingUnknown, Id::revolutionsJump))
        << "nothing, perhaps";
    EXPECT_THAT(textsOf(device, {{Parameter::steps, 1000}, {Parameter::revolutions, 128}}, on), IsEmpty());
    const ParameterValues kept{
        {Parameter::scaling, 0}, {Parameter::revolutions, 100}, {Parameter::measuringRange, 100'000}};
    EXPECT_THAT(idsOf(device, on, kept, PositionIsSet::yes), ElementsAre(Id::revolutionsJump))
        << "once it is switched on";
}

// Manual, GS: "Scaling enabled 1 = enabled 0 = disabled".
TEST(ValueNotes, StepsOfASerialEncoderDoNotActWhileScalingIsOff)
{
    const QStringView device = u"kuebler-esc-rs485";
    const ParameterValues off{{Parameter::revolutions, 4096}, {Parameter::scaling, 0}};
    EXPECT_THAT(textsOf(device, {{Parameter::steps, 1000}}, off, PositionIsSet::no),
                ElementsAre("Scaling is off: the encoder keeps the values that scale its position, but "
                            "counts its own steps until scaling is on."))
        << "and the position stays what it is";
    EXPECT_THAT(textsOf(device, {{Parameter::steps, 1000}}, {{Parameter::revolutions, 4096}}),
                ElementsAre("It is not known whether scaling is on: while it is off, the encoder keeps the "
                            "values that scale its position, but counts its own steps."));
    for (const Parameter parameter : {Parameter::measuringRange, Parameter::scalingFactor})
        EXPECT_THAT(idsOf(device, {{parameter, 16'384}}, off), ElementsAre(Id::scalingOff));
    EXPECT_THAT(idsOf(device, {{Parameter::steps, 1000}, {Parameter::scaling, 1}}, off),
                ElementsAre(Id::presetNeeded))
        << "it is switched on along with them";
    EXPECT_THAT(idsOf(device, {{Parameter::scaling, 1}}, off), ElementsAre(Id::presetNeeded))
        << "what it keeps acts from then on";
    EXPECT_THAT(idsOf(device, {{Parameter::direction, 1}}, off), IsEmpty());
}

// Manual, GR: "Number of revolutions is 4096".
TEST(ValueNotes, StepsOfASerialEncoderSetItsRevolutions)
{
    const QStringView device = u"kuebler-esc-rs485";
    const ParameterValue on{Parameter::scaling, 1};
    EXPECT_THAT(textsOf(device, {{Parameter::steps, 864}}, {{Parameter::revolutions, 16}, on}),
                ElementsAre("With the steps, the encoder sets its revolutions to 4096: now they are 16. To "
                            "keep them, write them along with the steps."));
    EXPECT_THAT(textsOf(device, {{Parameter::steps, 864}}, {on}),
                ElementsAre("With the steps, the encoder sets its revolutions to 4096. To have others, write "
                            "them along with the steps."));
    EXPECT_THAT(textsOf(device, {{Parameter::steps, 864}}, {{Parameter::revolutions, 4096}, on}), IsEmpty());
    EXPECT_THAT(textsOf(u"fraba-ocd-ib", {{Parameter::steps, 864}}, {{Parameter::revolutions, 16}}),
                IsEmpty())
        << "a K3 encoder keeps them";
}

// The zero offset is kept when the scaling changes.
TEST(ValueNotes, AnotherScalingNeedsThePresetAgain)
{
    const ParameterValues steps{{Parameter::steps, 4096}};
    const ParameterValues known{
        {Parameter::revolutions, 4096}, {Parameter::steps, 8192}, {Parameter::scaling, 1}};
    for (const QStringView device : {u"fraba-ocd-ib", u"kuebler-esc-rs485"}) {
        EXPECT_THAT(idsOf(device, steps, known), ElementsAre(Id::presetNeeded));
        EXPECT_THAT(idsOf(device, steps, known, PositionIsSet::yes), IsEmpty());
        EXPECT_THAT(idsOf(device, {{Parameter::steps, 8192}}, known), IsEmpty()) << "unchanged";
        EXPECT_THAT(idsOf(device, {{Parameter::preset, 1}}, known), IsEmpty());
    }
    ParameterValues withoutOffset = known;
    withoutOffset.push_back({Parameter::zeroOffset, 0});
    EXPECT_THAT(idsOf(u"fraba-ocd-ib", steps, withoutOffset), IsEmpty()) << "none was ever set";
}

TEST(ValueNotes, EachHasItsKey)
{
    EXPECT_EQ(noteKey(Id::rangeJumps), QStringLiteral("rangeJumps"));
    EXPECT_EQ(noteKey(Id::presetNeeded), QStringLiteral("presetNeeded"));
    EXPECT_EQ(noteKey(Id::scalingOff), QStringLiteral("scalingOff"));
    EXPECT_EQ(noteKey(Id::scalingUnknown), QStringLiteral("scalingUnknown"));
    EXPECT_EQ(noteKey(Id::offsetLeftOut), QStringLiteral("offsetLeftOut"));
    EXPECT_EQ(noteKey(Id::positionShifts), QStringLiteral("positionShifts"));
    EXPECT_EQ(noteKey(Id::positionShiftsAbout), QStringLiteral("positionShiftsAbout"));
}

TEST(ValueNotes, ThePositionThenIsToldAsFarAsItIsKnown)
{
    const auto text = [](Id id, std::vector<RefusalArgument> arguments) {
        return noteText({id, std::move(arguments)}).toStdString();
    };
    const std::int64_t now = 10;
    const std::int64_t then = 414;
    EXPECT_EQ(text(Id::positionShifts, {now, then}), "This shifts the position: now 10, then 414.");
    EXPECT_EQ(text(Id::positionShiftsAbout, {now, then}),
              "This shifts the position: now 10, then about 414.");
    EXPECT_EQ(text(Id::positionShifts, {QString(), QString()}),
              "This shifts the position, by how much is not known.");
}

} // namespace
} // namespace codewheel
