// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/word_channel.h"
#include "project/project_file.h"
#include "tests/cli/cli_run.h"
#include "tests/support/places.h"

#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const QString mainJob = QStringLiteral("write 1.0 steps=255 revolutions=1 direction=cw preset=0");
const Person nobody;

std::vector<std::string> keysOf(const QJsonObject &json, QStringView list)
{
    std::vector<std::string> keys;
    for (const QJsonValue value : json[list].toArray())
        keys.push_back(value[u"parameter"].toString().toStdString());
    return keys;
}

QJsonObject rowOf(const QJsonObject &json, QStringView list, int index)
{
    return json[list].toArray()[index].toObject();
}

// A Baumer cannot be read: no later call knows them.
TEST(CliWrite, WhatWasConfirmedIsKeptInTheProjectWhereThatIsWanted)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("crane.codewheel"));
    ASSERT_EQ(runLine(QStringLiteral("scan --save ") + file).exit, 0);
    const QString write = QStringLiteral("write 2.0 steps=4096 --yes --store");
    EXPECT_EQ(errorKey(runLine(write + QStringLiteral(" --json"))), "storeNeedsProject");
    const CliRun run = runLine(write + QStringLiteral(" --project ") + file);
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("Saved in "));
    const auto project = loadProject(file);
    ASSERT_TRUE(project);
    const std::vector<StoredValue> &stored = findDevice(*project, "2.0"_ring)->stored;
    const auto steps = std::ranges::find(stored, Parameter::steps, &StoredValue::parameter);
    ASSERT_NE(steps, stored.end());
    EXPECT_EQ(steps->value, 4'096);
    EXPECT_EQ(steps->evidence, Evidence::echoed);
}

TEST(CliWrite, ADryRunShowsDiffAndWordsAndSendsNothing)
{
    SharedBus shared;
    const CliRun run = shared.runLine(mainJob + QStringLiteral(" --dry-run"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(run.out, HasSubstr("  steps        unknown  255     020000FF\n"
                                   "  revolutions  unknown  1       04000001\n"
                                   "  direction    unknown  cw (3)  06000003\n"
                                   "  preset       unknown  0       08000000\n"
                                   "  run                           80000000\n"));
    EXPECT_LE(shared.bus().latest().cycle, 1u);
    EXPECT_EQ(shared.bus().channel("1.0"_ring)->out(), 0u);
}

TEST(CliWrite, WithNobodyToAskItShowsTheDiffAndSendsNothing)
{
    SharedBus shared;
    const CliRun run = shared.runLine(mainJob, nobody);
    EXPECT_EQ(run.exit, 2);
    EXPECT_THAT(run.out, HasSubstr("020000FF"));
    EXPECT_THAT(run.err, HasSubstr("Add --yes"));
    EXPECT_LE(shared.bus().latest().cycle, 1u);
    EXPECT_EQ(shared.eepromWrites(), 0);
}

TEST(CliWrite, NothingIsSentUnlessTheAnswerIsYes)
{
    for (const char *answer : {"n\n", "\n", "", "yesterday\n"}) {
        SharedBus shared;
        const CliRun run = shared.runLine(mainJob, {true, answer});
        EXPECT_EQ(run.exit, 2) << answer;
        EXPECT_THAT(run.out, HasSubstr("Write this to 1.0? [y/N]"));
        EXPECT_THAT(run.err, HasSubstr("Nothing was sent."));
        EXPECT_LE(shared.bus().latest().cycle, 1u);
    }
}

TEST(CliWrite, YesAtTheTerminalWrites)
{
    for (const char *answer : {"y\n", "yes\n", "Y\n"}) {
        SharedBus shared;
        const CliRun run = shared.runLine(mainJob, {true, answer});
        EXPECT_EQ(run.exit, 0) << answer;
        EXPECT_THAT(run.out, HasSubstr("steps        = 255     written, and read back\n"));
        EXPECT_EQ(shared.eepromWrites(), 1);
    }
}

TEST(CliWrite, WithJsonNobodyIsAsked)
{
    SharedBus shared;
    const CliRun run = shared.runLine(mainJob + QStringLiteral(" --json"), {true, "y\n"});
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(errorKey(run), "noConsent");
    EXPECT_EQ(run.json()[u"plan"][0][u"word"], QStringLiteral("020000FF"));
    EXPECT_EQ(shared.eepromWrites(), 0);
}

TEST(CliWrite, WhatTheEncoderHasIsReadAndNotWrittenAgain)
{
    SharedBus shared;
    const QJsonObject json = shared.runLine(mainJob + QStringLiteral(" --yes --json")).json();
    EXPECT_EQ(json[u"exit"], 0);
    EXPECT_THAT(keysOf(json, u"written"), ElementsAre("steps"));
    EXPECT_THAT(keysOf(json, u"alreadyThere"), ElementsAre("revolutions", "direction", "preset"));
    EXPECT_EQ(rowOf(json, u"written", 0)[u"evidence"], QStringLiteral("read"));
    EXPECT_EQ(json[u"eepromWrites"], 1);
    EXPECT_EQ(json[u"positionBefore"], 12345);
    EXPECT_EQ(json[u"positionAfter"], 384);
    EXPECT_EQ(json[u"leftIn"], QStringLiteral("operation"));
    EXPECT_EQ(shared.eepromWrites(), 1);
}

TEST(CliWrite, AllWritesAlsoWhatTheEncoderHas)
{
    SharedBus shared;
    const CliRun run = shared.runLine(mainJob + QStringLiteral(" --yes --all --trace --json"));
    const QJsonObject json = run.json();
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(keysOf(json, u"written"), ElementsAre("steps", "revolutions", "direction", "preset"));
    EXPECT_THAT(rowsOf(json),
                testing::IsSupersetOf({"020000FF C20000FF", "04000001 C4000001", "06000003 C6000003",
                                       "08000000 C8000000", "80000000 00000180"}));
}

TEST(CliWrite, OnlyATraceThatIsAskedForIsPrinted)
{
    EXPECT_THAT(runLine(mainJob + QStringLiteral(" --yes")).out, Not(HasSubstr("C20000FF")));
    EXPECT_THAT(runLine(mainJob + QStringLiteral(" --yes --trace")).out, HasSubstr("020000FF  C20000FF"));
}

TEST(CliWrite, WritesInTheOrderGiven)
{
    const QJsonObject json =
        runLine(QStringLiteral("write 1.0 preset=7 direction=ccw steps=0x100 --yes --json")).json();
    EXPECT_THAT(keysOf(json, u"plan"), ElementsAre("preset", "direction", "steps"));
    EXPECT_EQ(rowOf(json, u"plan", 1)[u"word"], QStringLiteral("06000004"));
    EXPECT_EQ(rowOf(json, u"plan", 2)[u"word"], QStringLiteral("02000100"));
    EXPECT_THAT(keysOf(json, u"written"), ElementsAre("preset", "direction", "steps"));
}

TEST(CliWrite, AnOffsetThatShiftsThePositionIsToldBefore)
{
    SharedBus shared;
    const QString write = QStringLiteral("write 1.0 zero-offset=30 --dry-run");
    EXPECT_THAT(shared.runLine(write).out,
                HasSubstr("This shifts the position, by how much is not known.\n"));
    shared.runLine(QStringLiteral("read 1.0"));
    EXPECT_THAT(shared.runLine(write).out, HasSubstr("This shifts the position: now 12345, then 12375.\n"));
    const QJsonObject json = shared.runLine(write + QStringLiteral(" --json")).json();
    EXPECT_EQ(json[u"notes"].toArray()[0][u"key"], QStringLiteral("positionShifts"));
}

// Without the zero offset nobody can say where to.
TEST(CliWrite, AnotherDirectionOrCodingShiftsThePositionAndIsToldBefore)
{
    SharedBus shared;
    const std::string shift = "This shifts the position, by how much is not known.\n";
    const QString direction = QStringLiteral("write 6.1 direction=ccw --dry-run");
    EXPECT_THAT(shared.runLine(direction).out, HasSubstr(shift)) << "which direction it has is not known";
    shared.bus().encoder("6.1"_ring)->tell(Parameter::direction, 3);
    EXPECT_THAT(shared.runLine(direction).out, HasSubstr(shift));
    EXPECT_THAT(shared.runLine(QStringLiteral("write 6.1 direction=cw --dry-run")).out,
                Not(HasSubstr("shifts the position")));

    const QString coding = QStringLiteral("write 2.0 coding=signed-cw --dry-run");
    EXPECT_THAT(shared.runLine(coding).out, HasSubstr(shift));
    shared.runLine(QStringLiteral("write 2.0 coding=signed-ccw --yes"));
    const QJsonObject json = shared.runLine(coding + QStringLiteral(" --json")).json();
    EXPECT_EQ(json[u"notes"].toArray()[0][u"key"], QStringLiteral("positionShifts"));
}

TEST(CliWrite, WhereTheModeIsNotKnownTheRawWordIsTold)
{
    SharedBus shared;
    shared.bus().close();
    ASSERT_TRUE(shared.bus().open(RingSession::Start::operating)); // after which nothing is known
    const CliRun run = shared.runLine(QStringLiteral("write 1.0 steps=255 --yes"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out,
                HasSubstr("Position before: IN 00003039, and the mode of the encoder is not known\n"));
}

TEST(CliWrite, AnEncoderWithoutReadOutIsBelievedByItsHandshake)
{
    SharedBus shared;
    const CliRun run = shared.runLine(QStringLiteral("write 2.0 steps=4096 coding=unsigned-cw --yes"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("steps   = 4096             written, confirmed by the handshake\n"));
    EXPECT_THAT(run.out, HasSubstr("coding  = unsigned-cw (3)  written, confirmed by the handshake\n"));
    EXPECT_THAT(run.out, HasSubstr("Position before: IN 000F4240, and how it is coded is not known\n"));
    EXPECT_THAT(run.out, Not(HasSubstr("The encoder is read first")));
}

TEST(CliWrite, WithoutReadOutWhatWasWrittenFromHereIsLeftOut)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("write 2.0 steps=4096 preset=5 --yes"));
    const int before = shared.eepromWrites();

    const CliRun same = shared.runLine(QStringLiteral("write 2.0 steps=4096 preset=5 --yes"));
    EXPECT_EQ(same.exit, 0);
    EXPECT_THAT(same.out, HasSubstr("there is nothing to write"));
    EXPECT_EQ(shared.eepromWrites(), before);

    const QJsonObject other =
        shared.runLine(QStringLiteral("write 2.0 steps=4096 preset=6 --yes --json")).json();
    EXPECT_EQ(rowOf(other, u"plan", 0)[u"known"], 5);
    EXPECT_EQ(rowOf(other, u"plan", 1)[u"leftOut"], true);
    EXPECT_TRUE(rowOf(other, u"plan", 1)[u"word"].isNull());
    EXPECT_THAT(keysOf(other, u"written"), ElementsAre("preset"));
}

// More steps per turn than the disc has: the encoder's error 1 at run.
TEST(CliWrite, WhatTheEncoderRefusesIsExit1AndSaysWhereItWasLeft)
{
    const CliRun run = runLine(QStringLiteral("write 2.0 steps=20000 revolutions=1 --yes --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "wrongParameterData");
    EXPECT_THAT(run.err, HasSubstr("82000000"));
    EXPECT_THAT(run.err, HasSubstr("The encoder was left in error"));
    EXPECT_THAT(keysOf(run.json(), u"written"), ElementsAre());
    EXPECT_THAT(runLine(QStringLiteral("write 2.0 steps=20000 revolutions=1 --yes")).out,
                HasSubstr("steps        = 20000  did not become active\n"));
}

// Another call has switched it to cam mode.
TEST(CliWrite, AWordThatWasRefusedWasSent)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("words 1.0 20800001 00000000"));
    shared.bus().close();
    ASSERT_TRUE(shared.bus().open(RingSession::Start::operating)); // after which nothing is known
    const CliRun run = shared.runLine(QStringLiteral("write 1.0 steps=1000 direction=ccw --yes"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("steps      = 1000     sent, and refused by the encoder (error 2)\n"));
    EXPECT_THAT(run.out, HasSubstr("direction  = ccw (4)  not sent\n"));
    EXPECT_THAT(run.err, HasSubstr("Error 2: the encoder refused 020003E8, the word for Steps (IN 84000000). "
                                   "Perhaps it is in cam mode, where it takes no parameters: switch it to "
                                   "position mode, then try again."));
    EXPECT_EQ(shared.eepromWrites(), 0);
}

struct BadWrite
{
    const char *values;
    const char *key;
    const char *help;
};

class CliWriteBadInput : public testing::TestWithParam<BadWrite>
{};

TEST_P(CliWriteBadInput, IsRefusedAndNothingIsSent)
{
    SharedBus shared;
    const CliRun run =
        shared.runLine(QStringLiteral("write %1 --yes --json").arg(QString::fromLatin1(GetParam().values)));
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(errorKey(run), GetParam().key);
    EXPECT_THAT(run.err, HasSubstr(GetParam().help));
    EXPECT_LE(shared.bus().latest().cycle, 1u);
    EXPECT_EQ(shared.bus().channel("1.0"_ring)->out(), 0u);
}

TEST(CliWrite, AnEncoderThatOnlyTellsItsPositionTakesNoParameters)
{
    SharedBus shared;
    const CliRun run = shared.runLine(QStringLiteral("write 3.0 steps=255 --yes"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err, "codewheel-cli: The FRABA OCD-IB K1 cannot be parameterized over the bus.\n");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("write 4.0 steps=255 --yes --json"))), "writingNotSupported");
}

INSTANTIATE_TEST_SUITE_P(
    Calls, CliWriteBadInput,
    testing::Values(
        BadWrite{"1.0 stepps=255", "unknownParameter", "steps, revolutions, direction, preset, zero-offset"},
        BadWrite{"1.0 coding=3", "parameterNotSupported", "It has: steps, revolutions, direction"},
        BadWrite{"1.0 serial-number=3", "parameterReadOnly", "It has: steps, revolutions, direction"},
        BadWrite{"1.0 steps=0", "valueOutOfRange", "from 1 to 33554431"},
        BadWrite{"1.0 steps=33554432", "valueOutOfRange", "from 1 to 33554431"},
        BadWrite{"1.0 steps=", "valueNotAllowed", "Allowed are: 1..33554431."},
        BadWrite{"1.0 steps=-5", "valueNotAllowed", "Allowed are: 1..33554431."},
        BadWrite{"1.0 steps=FF", "valueNotAllowed", "0xFF or FFh"},
        BadWrite{"1.0 direction=left", "valueNotAllowed", "cw (3), ccw (4)"},
        BadWrite{"1.0 direction=1", "valueNotAllowed", "cw (3), ccw (4)"},
        BadWrite{"1.0 steps=1 preset=2 steps=3", "parameterGivenTwice", "Give it once"},
        BadWrite{"1.0 steps", "notAnAssignment", "steps=255"},
        BadWrite{"7.0 steps=255", "unknownDevice", "1.0, 2.0"}));

} // namespace
} // namespace codewheel
