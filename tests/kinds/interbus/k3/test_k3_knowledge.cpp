// SPDX-License-Identifier: GPL-3.0-or-later
// Words that no job has sent teach just as much: what is known follows the wire.
#include "kinds/interbus/k3/k3_knowledge.h"
#include "tests/kinds/interbus/words/driver_table.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class Wire : public testing::Test
{
protected:
    Catalog catalog = Catalog::builtIn();
    K3Knowledge fraba{*catalog.find(u"fraba-ocd-ib")};
    K3Knowledge baumer{*catalog.find(u"baumer-gxp6w")};

    static void play(K3Knowledge &knowledge, const std::vector<Row> &rows)
    {
        for (const Row &row : rows)
            knowledge.observe(row.in, row.out, Instant{1});
    }
};

TEST_F(Wire, AConfirmedValueIsKnownOnceRunIsAnswered)
{
    play(baumer, {{0, pos}, {0x0200'00FF, 0xC000'00FF}, {0x0200'00FF, 0xC200'00FF}});
    EXPECT_EQ(baumer.value(Parameter::steps), std::nullopt);
    play(baumer, {{0x8000'0000, 0xC200'00FF}, {0x8000'0000, pos}});
    EXPECT_EQ(baumer.value(Parameter::steps), 255);
    EXPECT_EQ(baumer.eepromWrites(), 1);
}

// As in Watch, where this program sends nothing.
TEST_F(Wire, WhatOthersWriteIsKnownAndNotCounted)
{
    baumer.setOthersWrite(true);
    play(baumer, {{0, pos}, {0x0200'00FF, 0xC200'00FF}, {0x0400'0001, 0xC400'0001}, {0x8000'0000, pos}});
    EXPECT_EQ(baumer.value(Parameter::steps), 255);
    EXPECT_EQ(baumer.eepromWrites(), 0);
    baumer.setOthersWrite(false);
    play(baumer, {{0, pos}, {0x0200'0100, 0xC200'0100}, {0x8000'0000, pos}});
    EXPECT_EQ(baumer.eepromWrites(), 1);

    fraba.setOthersWrite(true);
    play(fraba, {{0, pos}, {0x4000'0000, pos}, {0x4000'0000, pos}, {0, pos}});
    EXPECT_EQ(fraba.eepromWrites(), 0) << "a preset";
}

TEST_F(Wire, AWordThatWasSentBeforeIsCountedWhoeverOverwritesIt)
{
    play(baumer, {{0, pos}, {0x0200'00FF, 0xC200'00FF}});
    baumer.setOthersWrite(true);
    play(baumer, {{0x0200'00FF, 0xC200'00FF}, {0x0400'0001, 0xC400'0001}, {0x8000'0000, pos}});
    EXPECT_EQ(baumer.eepromWrites(), 1);
}

TEST_F(Wire, WhatStandsConfirmedIsCountedOnce)
{
    play(baumer, {{0, pos}, {0x0200'00FF, 0xC200'00FF}});
    baumer.countStanding();
    EXPECT_EQ(baumer.eepromWrites(), 1);
    play(baumer, {{0x0200'00FF, 0xC200'00FF}, {0, 0xC200'00FF}, {0x8000'0000, pos}});
    EXPECT_EQ(baumer.eepromWrites(), 1);
}

// Behind a gateway, in Watch: IN is seen before the OUT that caused it.
TEST_F(Wire, RunOfAnotherMasterThatIsSeenTooLateLeavesNothingKnown)
{
    fraba.expectTornWords();
    fraba.set({{Parameter::steps, 4096, Evidence::read, {}}, {Parameter::direction, 3, Evidence::read, {}}});
    play(fraba,
         {{0, pos}, {0, 0xC200'0800}, {0x0200'0800, 0xC200'0800}, {0x0200'0800, 384}, {0x8000'0000, 384}});
    EXPECT_EQ(fraba.value(Parameter::steps), std::nullopt);
    fraba.set({{Parameter::steps, 4096, Evidence::read, {}}, {Parameter::direction, 3, Evidence::read, {}}});
    play(fraba, {{0, 384}, {0, 0xC600'0004}, {0, 385}});
    EXPECT_EQ(fraba.value(Parameter::direction), std::nullopt);
}

// The link was lost behind the confirmation, and what was known came back by the serial number.
TEST_F(Wire, WhatWasTakenUnseenBecomesValidWithRun)
{
    for (K3Knowledge *encoder : {&fraba, &baumer}) {
        play(*encoder, {{0, pos}, {0x0200'0262, 0xC200'0262}});
        encoder->forget();
        encoder->set(
            {{Parameter::direction, 3, Evidence::read, {}}, {Parameter::preset, 0, Evidence::read, {}}});
        play(*encoder, {{0, 0xC600'0004}, {0x8000'0000, 0xC600'0004}, {0x8000'0000, pos}});
        EXPECT_EQ(encoder->value(Parameter::preset), std::nullopt) << "it may have been taken before";
    }
    EXPECT_EQ(baumer.value(Parameter::coding), 4) << "it stood in IN";
    EXPECT_EQ(fraba.value(Parameter::direction), std::nullopt) << "or a cam did, in cam mode";
}

// 20400000 has no effect there, so that nothing is in doubt where it leaves OUT early.
TEST_F(Wire, AWordThatLeadsToTheModeItIsInLeavesNoProgram)
{
    play(fraba, {{0, pos}, {0x4600'0023, pos}, {0, pos}}); // perhaps a cam, in a mode that is not known
    fraba.set({{Parameter::startUpMode, 1, Evidence::told, {}}});
    const int before = fraba.eepromWrites();
    play(fraba, {{0, pos}, {0x2040'0000, pos}, {0, pos}});
    EXPECT_EQ(fraba.mode(), Mode::position);
    EXPECT_EQ(fraba.eepromWrites(), before);
}

TEST_F(Wire, WhatStoodInInInCamModeWasACam)
{
    play(fraba, {{0, 0xC600'0023}}); // the acknowledgement of 46000023, in a mode that is not known yet
    fraba.set(
        {{Parameter::direction, 3, Evidence::read, {}}, {Parameter::startUpMode, 3, Evidence::told, {}}});
    play(fraba, {{0x8000'0000, 0xC600'0023}, {0x8000'0000, pos}});
    EXPECT_EQ(fraba.value(Parameter::direction), std::nullopt);
}

TEST_F(Wire, APowerCycleDropsWhatWasOnlyConfirmed)
{
    play(baumer, {{0, pos}, {0x0200'00FF, 0xC200'00FF}, {0, pos}, {0x8000'0000, pos}});
    EXPECT_EQ(baumer.value(Parameter::steps), std::nullopt);
    EXPECT_EQ(baumer.eepromWrites(), 1) << "counted once confirmed, whatever comes after";
}

TEST_F(Wire, ARefusedValueIsNotKnown)
{
    play(fraba, {{0, pos},
                 {0x0600'0004, 0xC600'0004},
                 {0x0400'1000, 0xC400'1000},
                 {0x0400'1000, 0x8200'0000},
                 {0x0000'0000, 0x8200'0000},
                 {0x8000'0000, pos}});
    EXPECT_EQ(fraba.value(Parameter::direction), 4);
    EXPECT_EQ(fraba.eepromWrites(), 1) << "a refused value is not stored";
    EXPECT_EQ(fraba.value(Parameter::revolutions), std::nullopt);
}

TEST_F(Wire, StepsOfAnEncoderThatMayCountMinusOneStayUnknown)
{
    play(fraba, {{0, pos}, {0x0200'00FF, 0xC200'00FF}, {0x8000'0000, pos}});
    EXPECT_EQ(fraba.value(Parameter::steps), std::nullopt);
}

TEST_F(Wire, AReadOutByHandIsKnowledgeButAnOldAnswerIsNot)
{
    play(fraba, {{0, pos}, {0x2021'0002, pos}, {0x2021'0002, 0xA000'0005}});
    EXPECT_EQ(fraba.value(Parameter::revolutions), 5);
    play(fraba, {{0x2021'0004, 0xA000'0005}, {0x2021'0004, 0xA000'0064}});
    EXPECT_EQ(fraba.value(Parameter::preset), std::nullopt) << "it cannot be told from the old answer";
}

// Baumer manual 4: the factory settings are those of the parameter table
TEST_F(Wire, AResetBaumerHasItsFactorySettings)
{
    play(baumer, {{0, pos}, {0x0600'0005, 0xC600'0005}, {0x8000'0000, pos}, {0, pos}});
    EXPECT_EQ(baumer.value(Parameter::coding), 5);
    play(baumer, {{0x0E00'0000, 0xC600'0000}, {0x0E00'0000, 0xCE00'0000}});
    EXPECT_EQ(baumer.value(Parameter::coding), 5) << "confirmed, but not run";
    play(baumer, {{0x8000'0000, 0xCE00'0000}, {0x8000'0000, pos}});
    EXPECT_EQ(baumer.value(Parameter::coding), 3);
    EXPECT_EQ(baumer.value(Parameter::steps), 8192);
    EXPECT_EQ(baumer.value(Parameter::measuringRange), 4096);
    EXPECT_EQ(baumer.eepromWrites(), 2);
}

TEST_F(Wire, AResetBaumerThatShowsZeroMayHaveLostItsPower)
{
    play(baumer, {{0, pos}, {0x0E00'0000, 0xCE00'0000}, {0x8000'0000, 0}, {0, 0}});
    EXPECT_EQ(baumer.value(Parameter::steps), std::nullopt);
    play(baumer, {{0, 1}});
    EXPECT_EQ(baumer.value(Parameter::steps), 8192) << "a position proves that it runs";
}

TEST_F(Wire, AResetFrabaIsNotTakenForItsAssumedSettings)
{
    fraba.set({{Parameter::steps, 255, Evidence::read, {}},
               {Parameter::presetFlag, 1, Evidence::read, {}},
               {Parameter::serialNumber, 4711, Evidence::read, {}}});
    play(fraba, {{0, pos}, {0x0E00'0000, 0xCE00'0000}, {0x8000'0000, pos}});
    EXPECT_EQ(fraba.value(Parameter::steps), std::nullopt);
    EXPECT_EQ(fraba.value(Parameter::presetFlag), std::nullopt);
    EXPECT_EQ(fraba.value(Parameter::serialNumber), 4711) << "no reset changes that";
}

TEST_F(Wire, AFrabaPresetCostsAWriteInEachCycleInWhichItStands)
{
    play(fraba, {{0, pos}, {0x6000'0000, pos}, {0x6000'0000, 100}, {0x6000'0000, 100}, {0, 100}});
    EXPECT_EQ(fraba.eepromWrites(), 3);
}

TEST_F(Wire, InCamModeTheWordOfTheFrabaPresetIsAStopPosition)
{
    play(fraba, {{0, pos}, {0x2080'0001, pos}, {0x2080'0001, pos}, {0x2080'0001, 0}, {0x6000'0000, 0}});
    EXPECT_EQ(fraba.eepromWrites(), 0);
}

TEST_F(Wire, APresetOnTheWireChangesTheZeroOffset)
{
    fraba.set(
        {{Parameter::zeroOffset, 800, Evidence::read, {}}, {Parameter::startUpMode, 1, Evidence::told, {}}});
    play(fraba, {{0, pos}, {0x4000'0000, pos}, {0x4000'0000, 0}, {0, 0}});
    EXPECT_EQ(fraba.value(Parameter::zeroOffset), std::nullopt);
    EXPECT_EQ(fraba.eepromWrites(), 1);
    play(fraba, {{0x4000'0000, 0}, {0, 0}});
    EXPECT_EQ(fraba.eepromWrites(), 1) << "a programmed preset is activated once";
}

// It may be a FRABA, which stores the zero offset.
TEST_F(Wire, APresetOfAnUnnamedK3IsCountedAsOneWriteAtMost)
{
    for (const QStringView key : {u"generic-k3", u"generic-k3-loop2"}) {
        K3Knowledge unnamed{*catalog.find(key)};
        unnamed.set({{Parameter::startUpMode, 1, Evidence::told, {}}});
        play(unnamed, {{0, pos}, {0x4000'0000, pos}, {0x4000'0000, 0}, {0, 0}});
        EXPECT_EQ(unnamed.eepromWrites(), 1);
        play(unnamed, {{0x4000'0000, 0}, {0, 0}});
        EXPECT_EQ(unnamed.eepromWrites(), 1) << "a programmed preset is activated once";
    }
    play(baumer, {{0, pos}, {0x4000'0000, pos}, {0, 0}});
    K3Knowledge twk{*catalog.find(u"twk-k3")};
    play(twk, {{0, pos}, {0x4000'0000, pos}, {0, 0}});
    EXPECT_EQ(baumer.eepromWrites() + twk.eepromWrites(), 0) << "these makes do not store it";
}

TEST_F(Wire, ModeIsUnknownUntilToldOrSwitched)
{
    EXPECT_EQ(fraba.mode(), std::nullopt);
    play(fraba, {{0, pos}, {0x2040'0001, pos}, {0x2040'0001, pos}, {0x2040'0001, pos}});
    EXPECT_EQ(fraba.mode(), std::nullopt) << "in cam mode this sets the cam configuration";
    play(fraba, {{0x2080'0000, pos}, {0x2080'0000, pos}, {0x2080'0000, pos}});
    EXPECT_EQ(fraba.mode(), Mode::position);
    play(fraba, {{0x2040'0001, pos}, {0x2040'0001, pos}, {0x2040'0001, pos}});
    EXPECT_EQ(fraba.mode(), Mode::velocity);
}

TEST_F(Wire, WhatWasToldOfTheModeBeforeItWasSwitchedDoesNotComeBack)
{
    const Known told{Parameter::startUpMode, 1, Evidence::told, {}};
    fraba.set({told});
    play(fraba, {{0, pos}, {0x2040'0001, pos}, {0x2040'0001, pos}, {0x2040'0001, 0}});
    EXPECT_EQ(fraba.mode(), Mode::velocity);
    EXPECT_EQ(fraba.value(Parameter::startUpMode), std::nullopt) << "it will start in velocity mode now";
    fraba.set({told, {Parameter::steps, 8192, Evidence::told, Instant{1}}}); // something else is told
    EXPECT_EQ(fraba.mode(), Mode::velocity);
    fraba.set({{Parameter::startUpMode, 1, Evidence::told, Instant{2}}}); // another tool has switched it
    EXPECT_EQ(fraba.mode(), Mode::position);
}

TEST_F(Wire, AResetInVelocityModeLeavesTheModeUnknown)
{
    fraba.set({{Parameter::startUpMode, 2, Evidence::told, {}}});
    EXPECT_EQ(fraba.mode(), Mode::velocity);
    play(fraba, {{0, 0}, {0x0E00'0000, 0xCE00'0000}, {0x8000'0000, pos}});
    EXPECT_EQ(fraba.mode(), std::nullopt);
}

TEST_F(Wire, AStartUpModeThatWasReadSaysNothingAboutNow)
{
    fraba.set({{Parameter::startUpMode, 1, Evidence::read, {}}});
    EXPECT_EQ(fraba.mode(), std::nullopt);
}

} // namespace
} // namespace codewheel
