// SPDX-License-Identifier: GPL-3.0-or-later
// `replace` and `restore`: a new encoder gets what the previous one had, and previous values come back.
#include "cli/call/command_line.h"
#include "cli/commands.h"
#include "cli/kinds/interbus/ring_access.h"
#include "journal/ledger_keeper.h"
#include "kinds/interbus/ring/ring_session.h"
#include "project/project_file.h"
#include "tests/cli/cli_run.h"
#include "tests/support/places.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::Not;

class CliReplace : public testing::Test
{
protected:
    CliReplace()
    {
        ring.setLedger(std::make_unique<LedgerKeeper>(shared.bus(), DatabasePlace::memory()));
        for (const RingDevice &participant : shared.bus().structure())
            project.devices.emplace_back().participant = participant;
        ProjectDevice &planned = project.devices[0];
        planned.station = QStringLiteral("Hoist");
        planned.label.serialNumber = QStringLiteral("20417");
        planned.wanted = {{Parameter::steps, 4096}, {Parameter::revolutions, 1}};
        planned.stored = {{Parameter::direction, 4, Evidence::read, {}},
                          {Parameter::zeroOffset, 12, Evidence::read, {}}};
        save();
    }
    void save() { EXPECT_TRUE(saveProject(project, file)); }
    Project saved() const { return *loadProject(file); }
    CliRun run(const char *what, const Person &person = {})
    {
        QStringList words = QString::fromLatin1(what).replace(u'@', file).split(u' ', Qt::SkipEmptyParts);
        const Subcommand &command = *commandNamed(words.takeFirst());
        const auto arguments = parseArguments(words, optionsOf(command), {});
        EXPECT_TRUE(arguments) << what;
        std::istringstream in(person.types);
        std::ostringstream out;
        std::ostringstream err;
        const int exit = runOn(command, *arguments, catalog, {&ring}, Terminal{in, out, err, person.isThere});
        return {exit, out.str(), err.str()};
    }
    void connectAgain() // after which nothing is known
    {
        shared.bus().close();
        ASSERT_TRUE(shared.bus().open(RingSession::Start::operating));
    }
    EncoderSession &fraba() { return *shared.bus().encoder("1.0"_ring); }

    const Catalog catalog = Catalog::builtIn();
    SharedBus shared;
    RingAccess ring{shared.bus()};
    QTemporaryDir folder;
    QString file = folder.filePath(QStringLiteral("crane.codewheel"));
    Project project;
};

TEST_F(CliReplace, TheNewEncoderGetsTheValuesAndIsPutIntoTheProject)
{
    const CliRun done = run("replace 1.0 --project @ --label OCD-IBA1B-1213-C100-PRI --serial 4711 "
                            "--position 3000 --yes --trace");
    EXPECT_EQ(done.exit, 0) << done.err << done.out;
    EXPECT_THAT(done.out, HasSubstr("It fits: as far as the project shows, it is like the previous one.\n"));
    EXPECT_THAT(done.out, HasSubstr("  At the end, the position is set to 3000.\n"));
    EXPECT_THAT(done.out, HasSubstr("  Position: set to 3000.\n"));
    EXPECT_THAT(done.out, HasSubstr("  steps        = 4096     Written, and read back\n"));
    EXPECT_THAT(done.out, HasSubstr("  direction    = ccw (4)  Written, and read back\n"));
    EXPECT_THAT(done.out, Not(HasSubstr("0A00000C"))); // the old zero offset
    EXPECT_EQ(fraba().latest().position, 3000);
    const ProjectDevice now = saved().devices[0];
    EXPECT_EQ(now.label.serialNumber, QStringLiteral("4711"));
    EXPECT_EQ(now.label.stepsPerTurn, 8192);
    EXPECT_TRUE(now.stored.empty());
    EXPECT_EQ(now.station, QStringLiteral("Hoist"));
    EXPECT_TRUE(QFile::exists(file + u'~'));
}

// None reports its mode; what is said of it spares the way to position mode.
TEST_F(CliReplace, TheNewEncoderIsInPositionModeIfTheUserSaysSo)
{
    const auto plan = [&](const char *line) {
        connectAgain();
        return run(line).json()[u"plan"][0].toObject();
    };
    const QJsonObject unsaid = plan("replace 1.0 --project @ --position 3000 --dry-run --json");
    const QJsonObject said =
        plan("replace 1.0 --project @ --position 3000 --in-position-mode --dry-run --json");
    EXPECT_EQ(said[u"eepromWritesAtMost"].toInt(), unsaid[u"eepromWritesAtMost"].toInt() - 1);
    connectAgain();
    const CliRun done =
        run("replace 1.0 --project @ --position 3000 --in-position-mode --yes --trace --json");
    EXPECT_EQ(done.exit, 0) << done.err;
    EXPECT_THAT(done.out, Not(HasSubstr("20800000"))) << "the word that switches to position mode";
    EXPECT_EQ(fraba().latest().position, 3000);
}

TEST_F(CliReplace, TransferAndRestoreAreToldTheModeInTheSameWay)
{
    for (const char *line :
         {"transfer @ 1.0 --in-position-mode --yes", "restore 1.0 --in-position-mode --yes"}) {
        connectAgain();
        EXPECT_FALSE(fraba().latest().mode);
        EXPECT_EQ(run(line).exit, 0) << line;
        EXPECT_EQ(fraba().latest().mode, Mode::position) << line;
    }
}

// The wire breaks while the new encoder is being written: its values are still in the project, and the same
// call writes them again.
TEST_F(CliReplace, WhatWasInterruptedIsRepeated)
{
    project.devices[0].wanted.clear();
    project.devices[0].stored = {{Parameter::steps, 1000, Evidence::read, {}},
                                 {Parameter::revolutions, 16, Evidence::read, {}},
                                 {Parameter::direction, 4, Evidence::read, {}}};
    CamProgram cams;
    cams.cam[2] = {.start = 10, .stop = 20, .active = true};
    project.devices[0].storedCams = {{cams, Evidence::read, {}}};
    save();
    const QString plan = folder.filePath(QStringLiteral("faults.json"));
    QFile faults(plan);
    ASSERT_TRUE(faults.open(QIODevice::WriteOnly));
    faults.write(R"({"format": "codewheel-faults", "version": 1,
                     "steps": [{"at": 120, "fault": "wireBreak", "place": "1.0"}]})");
    faults.close();
    const QString call = QStringLiteral("replace 1.0 --serial 777 --yes --json --project ") + file;
    EXPECT_EQ(runLine(call + QStringLiteral(" --fault-plan ") + plan).exit, 1);
    EXPECT_EQ(saved().devices[0].label.serialNumber, QStringLiteral("777"));
    const CliRun again = runLine(call);
    EXPECT_EQ(again.exit, 0) << again.err;
    const QJsonObject account = again.json()[u"encoders"][0].toObject();
    ASSERT_EQ(account[u"values"].toArray().size(), 3);
    for (const QJsonValue value : account[u"values"].toArray())
        EXPECT_EQ(value[u"became"], QStringLiteral("written"));
    EXPECT_EQ(account[u"cams"][0][u"became"], QStringLiteral("written"));
    EXPECT_EQ(saved().devices[0].wantedCams, std::vector{cams});
}

TEST_F(CliReplace, TheLastPositionOfTheProjectIsGiven)
{
    EXPECT_EQ(errorKey(run("replace 1.0 --project @ --position last --yes --json")), "noLastPosition");
    EXPECT_EQ(run("store @ 1.0").exit, 0);
    ASSERT_TRUE(saved().devices[0].lastPosition);
    EXPECT_EQ(saved().devices[0].lastPosition->position, 12345);
    shared.controls().turnBy(NodeId("1.0"), 500);
    shared.bus().advance(5);
    const CliRun done = run("replace Hoist --project @ --position last --yes");
    EXPECT_EQ(done.exit, 0) << done.err;
    EXPECT_THAT(done.out, HasSubstr("The position that the project keeps: 12345, seen at 2026-03-01T"));
    EXPECT_EQ(fraba().latest().position, 12345);
}

TEST_F(CliReplace, ALastPositionOfAnotherScaleSaysSo)
{
    const auto said = [this](const ParameterValues &scale) {
        project.devices[0].stored.clear();
        project.devices[0].wanted = {{Parameter::steps, 4096}};
        project.devices[0].lastPosition = {1000, QDateTime(QDate(2026, 2, 1), QTime(8, 0), Qt::UTC), scale};
        save();
        return run("replace 1.0 --project @ --position last --dry-run").out;
    };
    EXPECT_THAT(said({}), HasSubstr("How the encoder was scaled then is not known: "));
    EXPECT_THAT(said({{Parameter::revolutions, 1}}), HasSubstr("is not known in full: "));
    EXPECT_THAT(said({{Parameter::steps, 8192}}), HasSubstr("It is of another scale than"));
    EXPECT_THAT(said({{Parameter::steps, 4096}}), Not(HasSubstr("scale")));
}

TEST_F(CliReplace, NothingIsDoneWithoutConsent)
{
    EXPECT_EQ(run("replace 1.0 --project @ --serial 4711 --dry-run").exit, 0);
    EXPECT_EQ(run("replace 1.0 --project @ --serial 4711").exit, 2);
    EXPECT_EQ(run("replace 1.0 --project @ --serial 4711", {true, "n\n"}).exit, 2);
    EXPECT_EQ(shared.eepromWrites(), 0);
    EXPECT_EQ(saved(), project);
    EXPECT_EQ(devicesWithOut(shared.bus()).size(), 0u);
}

TEST_F(CliReplace, AnotherMakeIsToldToProgramsAndPeople)
{
    project.devices[0].wanted.push_back({Parameter::offset, 5});
    save();
    EXPECT_THAT(run("replace 1.0 --project @ --device baumer-gxp6w --dry-run").out,
                HasSubstr("A FRABA OCD-IB K3 was planned; the new one is a Baumer GXP6W K3.\n"));
    const QJsonObject json = run("replace 1.0 --project @ --dry-run --json").json();
    EXPECT_EQ(json[u"differences"][u"notTaken"][0][u"parameter"], QStringLiteral("offset"));
    EXPECT_EQ(json[u"deviceBefore"], QStringLiteral("fraba-ocd-ib"));
    EXPECT_EQ(json[u"device"], QStringLiteral("fraba-ocd-ib"));
}

TEST_F(CliReplace, BadInputIsTold)
{
    for (const auto &[call, key] : std::initializer_list<std::pair<const char *, const char *>>{
             {"replace 1.0", "missingProject"},
             {"replace 9.0 --project @", "unknownDevice"},
             {"replace 3.0 --project @", "writingNotSupported"},
             {"replace 1.0 --project @ --device fraba-ocd-ib --label OCD-IBA1B-1213-C100-PRI",
              "deviceAndLabel"},
             {"replace 1.0 --project @ --device fraba-ocd-ib-loop2", "deviceCodeDiffers"},
             {"replace 1.0 --project @ --device nobodys", "unknownDeviceName"},
             {"replace 1.0 --project @ --position here", "badPosition"},
             {"restore 1.0", "noValuesFromBefore"},
             {"restore 1.0 --at 25:99", "badTime"},
             {"restore 9.0", "unknownDevice"}})
        EXPECT_EQ(errorKey(run((std::string(call) + " --json").c_str())), key) << call;
    EXPECT_EQ(shared.eepromWrites(), 0);
}

TEST_F(CliReplace, WhatWasThereBeforeAWriteIsRestored)
{
    EXPECT_EQ(run("write 1.0 steps=255 direction=ccw --yes").exit, 0); // read first: 8192, cw
    const QJsonArray list = run("restore 1.0 --list --json").json()[u"valuesBefore"].toArray();
    ASSERT_EQ(list.size(), 1);
    EXPECT_EQ(list[0][u"values"].toArray().size(), 2);
    EXPECT_THAT(run("restore 1.0 --list").out, HasSubstr("steps=8192, direction=cw (3)\n"));

    EXPECT_THAT(run("restore 1.0 --dry-run").out, HasSubstr("02002000\n"));
    EXPECT_EQ(run("restore 1.0 --json").exit, 2); // nobody to ask
    EXPECT_EQ(shared.eepromWrites(), 2);
    const CliRun done = run("restore 1.0 --yes");
    EXPECT_EQ(done.exit, 0) << done.err;
    EXPECT_THAT(done.out, HasSubstr("Written: 2. Already there: 0. EEPROM writes: 2.\n"));
    EXPECT_EQ(fraba().known(Parameter::steps)->value, 8192);
    EXPECT_EQ(shared.eepromWrites(), 4);
    EXPECT_EQ(run("restore 1.0 --list --json").json()[u"valuesBefore"].toArray().size(), 2); // and back
}

TEST_F(CliReplace, TheWriteToBeTakenBackIsCalledByItsTime)
{
    EXPECT_EQ(run("write 1.0 steps=255 --yes").exit, 0);
    shared.bus().advance(120'000);
    EXPECT_EQ(run("write 1.0 steps=256 --yes").exit, 0);
    EXPECT_THAT(run("restore 1.0 --at 2026-03-01T14:02:00Z --list").out, HasSubstr("steps=255"));
    EXPECT_EQ(errorKey(run("restore 1.0 --at 2025-03-01T14:02 --json")), "noWriteThen");
    EXPECT_EQ(errorKey(run("restore 1.0 --at noon --json")), "badTime");
    EXPECT_EQ(errorKey(run("restore 1.0 --at 2026-03-01 --json")), "badTime");
    const QJsonArray list = run("restore 1.0 --list --json").json()[u"valuesBefore"].toArray();
    ASSERT_EQ(list.size(), 2);
    const QDateTime first = QDateTime::fromString(list[1][u"at"].toString(), Qt::ISODateWithMs).toUTC();
    const QString at = first.toString(QStringLiteral("yyyy-MM-ddTHH:mm"));
    const CliRun shown = run(QStringLiteral("restore 1.0 --dry-run --at %1").arg(at).toLatin1().constData());
    EXPECT_THAT(shown.out, HasSubstr("8192")) << shown.err;
}

// Once an encoder has reported its serial number, its writes are listed under it.
TEST_F(CliReplace, AnEncoderIsAskedForItsSerialNumberWhereItsPlaceHasNothing)
{
    const QString option = QStringLiteral(" --ledger %1/ledger.sqlite").arg(folder.path());
    EXPECT_EQ(runLine(QStringLiteral("write 1.0 steps=255 --yes") + option).exit, 0);
    const CliRun byPlace = runLine(QStringLiteral("restore 1.0 --list --json --trace") + option);
    EXPECT_EQ(byPlace.exit, 0);
    {
        auto kept = Ledger::open(DatabasePlace::file(folder.filePath(QStringLiteral("ledger.sqlite"))));
        ASSERT_TRUE(kept);
        ASSERT_TRUE(kept->attribute({1}, {.by = CountedBy::serialNumber,
                                          .vendor = QStringLiteral("FRABA"),
                                          .serialNumber = QStringLiteral("20417"),
                                          .project = {},
                                          .place = "1.0"_ring}));
    }
    EXPECT_EQ(runLine(QStringLiteral("restore 1.0 --list --json") + option).json()[u"valuesBefore"],
              byPlace.json()[u"valuesBefore"]);
}

} // namespace
} // namespace codewheel
