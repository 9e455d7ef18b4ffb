// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/cli_run.h"
#include "tests/support/places.h"

#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// After which nothing is known, as for another call.
void connectAgain(SharedBus &shared)
{
    shared.bus().close();
    ASSERT_TRUE(shared.bus().open(RingSession::Start::operating));
}

TEST(CliPreset, PrintsThePositionBeforeAndAfter)
{
    const CliRun run = runLine(QStringLiteral("preset 1.0 1000"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.out, "Position before: 12345\n"
                       "Position after:  1000\n"
                       "EEPROM writes:   2\n");
}

TEST(CliPreset, OfAShaftThatTurnsTooFastIsNotSet)
{
    SharedBus shared;
    shared.controls().setSpeed(NodeId("1.0"), 6000);
    for (const char *line : {"preset 1.0", "preset 1.0 1000", "preset 1.0 --fraba"}) {
        const CliRun run = shared.runLine(QString::fromLatin1(line));
        EXPECT_EQ(run.exit, 1) << line;
        EXPECT_THAT(run.err, HasSubstr("The encoder gives no valid position (IN 80000000)")) << line;
    }
    EXPECT_EQ(shared.eepromWrites(), 0);
}

TEST(CliPreset, WithoutAValueThePresetOfTheEncoderIsUsed)
{
    const QJsonObject json = runLine(QStringLiteral("preset 1.0 --json")).json();
    EXPECT_EQ(json[u"positionBefore"], 12345);
    EXPECT_EQ(json[u"positionAfter"], 0);
}

TEST(CliPreset, ATraceShowsTheWords)
{
    const CliRun run = runLine(QStringLiteral("preset 1.0 3E8h --trace --json"));
    EXPECT_THAT(rowsOf(run.json()),
                testing::IsSupersetOf({"080003E8 C80003E8", "40000000 00003039", "00000000 000003E8"}));
    EXPECT_THAT(runLine(QStringLiteral("preset 1.0 --trace")).out, HasSubstr("40000000  00003039"));
}

// A Baumer cannot be read: neither its preset nor its coding nor its offset is known.
TEST(CliPreset, WhereTheCodingIsNotKnownTheRawWordIsTold)
{
    const CliRun run = runLine(QStringLiteral("preset 2.0"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("Position before: IN 000F4240, and how it is coded is not known\n"));
    EXPECT_THAT(run.err, HasSubstr("it is not known whether the position was set"));
    const CliRun json = runLine(QStringLiteral("preset 2.0 --json"));
    EXPECT_TRUE(json.json()[u"positionAfter"].isNull());
    EXPECT_EQ(errorKey(json), "presetNotKnownWithout");
}

TEST(CliPreset, IsProvedByPresetAndOffsetThatWereWritten)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("write 2.0 coding=unsigned-cw --yes"));
    EXPECT_EQ(errorKey(shared.runLine(QStringLiteral("preset 2.0 500 --json"))), "presetNotKnownWithout")
        << "its offset";
    shared.runLine(QStringLiteral("write 2.0 offset=0 --yes"));
    const QJsonObject json = shared.runLine(QStringLiteral("preset 2.0 600 --json")).json();
    EXPECT_EQ(json[u"exit"], 0);
    EXPECT_NEAR(json[u"positionAfter"].toInt(), 600, 50); // the shaft turns
}

TEST(CliPreset, RefusesValuesTheEncoderCannotHave)
{
    EXPECT_EQ(errorKey(runLine(QStringLiteral("preset 1.0 33554432 --json"))), "valueOutOfRange");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("preset 1.0 here --json"))), "valueNotAllowed");
    EXPECT_EQ(runLine(QStringLiteral("preset 1.0 33554432")).exit, 2);
    EXPECT_EQ(runLine(QStringLiteral("preset 9.9")).exit, 2);
}

TEST(CliPreset, IsRefusedByAnEncoderThatOnlyTellsItsPosition)
{
    for (const char *line : {"preset 3.0", "preset 3.0 100", "preset 4.0"}) {
        const CliRun run = runLine(QString::fromLatin1(line));
        EXPECT_EQ(run.exit, 1) << line;
        EXPECT_THAT(run.err, HasSubstr("cannot be set over the bus")) << line;
    }
}

// In cam mode, 40000000 would set the start of cam 0.
TEST(CliPreset, IsRefusedInCamMode)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("words 1.0 20800001 00000000"));
    const CliRun run = shared.runLine(QStringLiteral("preset 1.0 --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "inCamMode");
}

// FRABA manual 5.4.1: programmed once, activated as often as wanted; 60000000 is in OUT for one cycle
TEST(CliPreset, TheFrabaPresetNeedsNoProgrammingAgain)
{
    SharedBus shared;
    EXPECT_EQ(shared.runLine(QStringLiteral("preset 1.0 1000 --fraba")).out, "Position before: 12345\n"
                                                                             "Position after:  1000\n"
                                                                             "EEPROM writes:   2\n");
    const CliRun again = shared.runLine(QStringLiteral("preset 1.0 --fraba --trace --json"));
    EXPECT_THAT(rowsOf(again.json()),
                ElementsAre("00000000 000003E8", "60000000 000003E8", "00000000 000003E8"));
    EXPECT_EQ(again.json()[u"eepromWrites"], 1);
    EXPECT_EQ(shared.eepromWrites(), 3);
    EXPECT_EQ(errorKey(shared.runLine(QStringLiteral("preset 2.0 --fraba --json"))),
              "manufacturerPresetNotSupported");
}

TEST(CliPreset, InVelocityModeThereIsNoPositionToTell)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("velocity 1.0 on"));
    const CliRun run = shared.runLine(QStringLiteral("preset 1.0 1000"));
    EXPECT_EQ(run.exit, 1) << "nothing shows whether it was set";
    EXPECT_THAT(run.out, HasSubstr("Position after:  not shown in velocity mode\n"));
    EXPECT_EQ(shared.runLine(QStringLiteral("velocity 1.0 off")).out, "Position mode: 1000\n");
}

TEST(CliPreset, WhereTheModeIsNotKnownTheUserSaysIt)
{
    SharedBus shared;
    shared.bus().close();
    ASSERT_TRUE(shared.bus().open(RingSession::Start::operating)); // after which nothing is known
    const CliRun run = shared.runLine(QStringLiteral("preset 1.0 --json"));
    EXPECT_EQ(errorKey(run), "modeNotKnown");
    EXPECT_EQ(shared.runLine(QStringLiteral("preset 1.0 --in-position-mode")).exit, 0);
}

// Another call has switched it.
TEST(CliPreset, ASpeedIsNotTakenForThePositionThatWasNotSet)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("preset 1.0 1000"));
    shared.runLine(QStringLiteral("velocity 1.0 on"));
    shared.controls().setSpeed(NodeId("1.0"), 10);
    for (const char *line : {"preset 1.0 1000 --in-position-mode", "preset 1.0 --in-position-mode"}) {
        connectAgain(shared);
        const CliRun run = shared.runLine(QString::fromLatin1(line));
        EXPECT_EQ(run.exit, 1) << line;
        EXPECT_THAT(run.err, HasSubstr("it is not known whether the position was set: position mode would "
                                       "show 1000, but IN is 0000000A, which may be the speed"));
        EXPECT_THAT(run.err, HasSubstr("It is not known in which mode the encoder was left"));
        EXPECT_THAT(run.err, testing::Not(HasSubstr("was not set")));
        EXPECT_THAT(run.out, HasSubstr("Position before: IN 0000000A, and the mode of the encoder is not "
                                       "known\nPosition after:  IN 0000000A, and the mode of the encoder is "
                                       "not known\n"))
            << line;
    }
    shared.controls().setSpeed(NodeId("1.0"), 1);
    connectAgain(shared);
    const QJsonObject json =
        shared.runLine(QStringLiteral("preset 1.0 2000 --in-position-mode --json")).json();
    EXPECT_TRUE(json[u"positionBefore"].isNull());
    EXPECT_TRUE(json[u"positionAfter"].isNull());
    shared.controls().setSpeed(NodeId("1.0"), 0);
    const int position =
        shared.runLine(QStringLiteral("velocity 1.0 off --json")).json()[u"position"].toInt();
    EXPECT_NEAR(position, 2'000, 500) << "it was set";
}

// Run is answered by 00000000 there, which proves nothing.
TEST(CliPreset, FromPosition0IsProvedToo)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("preset 1.0 0"));
    EXPECT_EQ(shared.runLine(QStringLiteral("preset 1.0 1000")).out, "Position before: 0\n"
                                                                     "Position after:  1000\n"
                                                                     "EEPROM writes:   2\n");
    shared.runLine(QStringLiteral("preset 1.0 0"));
    const QJsonArray written =
        shared.runLine(QStringLiteral("preset 1.0 2000 --json")).json()[u"written"].toArray();
    ASSERT_EQ(written.size(), 1);
    EXPECT_EQ(written[0][u"value"].toInt(), 2'000) << "it was read back";
}

TEST(CliPreset, OfAnEncoderInCamModeThatWasToldToBeInPositionModeSaysWhatItMayBe)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("words 1.0 20800001 00000000"));
    connectAgain(shared);
    const CliRun run = shared.runLine(QStringLiteral("preset 1.0 1000 --in-position-mode"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err,
                HasSubstr("Error 2: the encoder refused 080003E8, the word for Preset (IN 84000000). "
                          "Perhaps it is in cam mode, where it takes no parameters"));
    EXPECT_THAT(run.err, HasSubstr("The encoder was left in error"));
    connectAgain(shared);
    EXPECT_EQ(shared.runLine(QStringLiteral("velocity 1.0 off")).exit, 0) << "the way out";
}

// Of a preset that is armed no value goes first, which would be refused.
TEST(CliPreset, ThatWasTakenForACamIsSaidToBe)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("write 1.0 preset=5 --yes"));
    shared.runLine(QStringLiteral("words 1.0 20800001 00000000"));
    connectAgain(shared);
    const CliRun run = shared.runLine(QStringLiteral("preset 1.0 --in-position-mode --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "takenAsCamWord") << run.out;
    EXPECT_EQ(shared.bus().encoder("1.0"_ring)->latest().mode, std::nullopt);
}

// It may be a FRABA in cam mode, where 40000000 sets the start of cam 0.
TEST(CliPreset, AnUnnamedK3IsSetOnlyWhereTheUserSaysItsMode)
{
    const CliRun refused = runLine(QStringLiteral("preset 2.0 100 --device generic-k3"));
    EXPECT_EQ(refused.exit, 1);
    EXPECT_THAT(refused.err, HasSubstr("In cam mode the word 40000000 sets the start of cam 0 to 0"));
    EXPECT_THAT(refused.err, HasSubstr("Where you are sure of it, add --in-position-mode."));
    EXPECT_EQ(errorKey(runLine(QStringLiteral("preset 2.0 --device generic-k3 --json"))), "modeNotKnown");
    const CliRun set =
        runLine(QStringLiteral("preset 2.0 100 --device generic-k3 --in-position-mode --trace --json"));
    EXPECT_EQ(errorKey(set), "presetNotKnownWithout") << set.err;
    const std::vector<std::string> rows = rowsOf(set.json());
    EXPECT_TRUE(std::ranges::any_of(rows, [](const auto &row) { return row.starts_with("40000000 "); }));
}

} // namespace
} // namespace codewheel
