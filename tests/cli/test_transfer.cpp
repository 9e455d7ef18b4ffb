// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/words/device_number.h"
#include "project/project_file.h"
#include "tests/cli/cli_run.h"
#include "tests/support/places.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::Not;

// The training bus as a project with wanted values for two of its encoders.
class CliTransfer : public testing::Test
{
protected:
    CliTransfer()
    {
        for (const RingDevice &participant : shared.bus().structure()) {
            ProjectDevice device;
            device.participant = participant;
            if (participant.number == NodeId("1.0"))
                device.wanted = {{Parameter::steps, 255}, {Parameter::revolutions, 1}};
            if (participant.number == NodeId("2.0"))
                device.wanted = {{Parameter::steps, 4096}};
            project.devices.push_back(device);
        }
        save();
    }
    void save() { EXPECT_TRUE(saveProject(project, file)); }
    CliRun runIt(const char *what, const Person &person = {})
    {
        return shared.runLine(QString::fromLatin1(what).replace(u'@', file), person);
    }

    SharedBus shared;
    QTemporaryDir folder;
    QString file = folder.filePath(QStringLiteral("crane.codewheel"));
    Project project;
};

TEST_F(CliTransfer, AProjectThatWantsNothingIsSaidSo)
{
    for (ProjectDevice &device : project.devices)
        device.wanted.clear();
    save();
    const CliRun wanted = runIt("transfer @ --dry-run");
    EXPECT_EQ(wanted.exit, 0) << wanted.err;
    EXPECT_EQ(wanted.out,
              file.toStdString() + " wants nothing of its encoders: there is nothing to write.\n");
    EXPECT_EQ(runIt("transfer @ --stored --dry-run").out,
              file.toStdString() + " has nothing stored of its encoders: there is nothing to write.\n");
    EXPECT_EQ(runIt("transfer @ --dry-run --json").json()[u"plan"].toArray(), QJsonArray());
}

TEST_F(CliTransfer, ADryRunShowsTheDifferenceAndSendsNothing)
{
    const CliRun run = runIt("transfer @ --dry-run");
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(run.out, "1.0  FRABA OCD-IB K3\n"
                       "  steps        unknown  255  020000FF\n"
                       "  revolutions  unknown  1    04000001\n"
                       "  The encoder is read first; what it already has is not written again.\n"
                       "  If the encoder counts steps minus 1, the word for the steps is one less.\n"
                       "  With another scaling the position tells another place: set it to the preset again "
                       "afterwards.\n"
                       "  Values and cam programs to write: 2. EEPROM writes: at most 2.\n"
                       "2.0  Baumer GXP6W K3\n"
                       "  steps  unknown  4096  02001000\n"
                       "  With another scaling the position tells another place: set it to the preset again "
                       "afterwards.\n"
                       "  Values and cam programs to write: 1. EEPROM writes: at most 1.\n");
    EXPECT_EQ(shared.eepromWrites(), 0);
    EXPECT_EQ(devicesWithOut(shared.bus()).size(), 0u);
}

TEST_F(CliTransfer, WritesToAllAndASecondTimeToNone)
{
    const CliRun run = runIt("transfer @ --yes");
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(
        run.out,
        HasSubstr("  steps        = 255  Written, and read back\n  revolutions  = 1    Already there\n"));
    EXPECT_THAT(run.out, HasSubstr("Written: 2. Already there: 1. EEPROM writes: 2.\n"));
    EXPECT_EQ(shared.eepromWrites(), 2);
    const CliRun again = runIt("transfer @");
    EXPECT_EQ(again.exit, 0) << again.err;
    EXPECT_THAT(again.out, HasSubstr("  It has everything already: nothing is sent.\n"));
    EXPECT_EQ(shared.eepromWrites(), 2);
}

TEST_F(CliTransfer, NothingIsWrittenWithoutConsent)
{
    EXPECT_EQ(runIt("transfer @").exit, 2);
    EXPECT_EQ(runIt("transfer @", {.isThere = true, .types = "no\n"}).exit, 2);
    EXPECT_EQ(shared.eepromWrites(), 0);
    EXPECT_EQ(runIt("transfer @ 2.0", {.isThere = true, .types = "yes\n"}).exit, 0);
    EXPECT_EQ(shared.eepromWrites(), 1);
}

TEST_F(CliTransfer, TheAccountIsToldToProgramsAndSaved)
{
    const QString account = folder.filePath(QStringLiteral("account.txt"));
    const CliRun run =
        shared.runLine(QStringLiteral("transfer %1 2.0 --yes --json --trace --report %2").arg(file, account));
    EXPECT_EQ(run.exit, 0) << run.err;
    const QJsonObject encoder = run.json()[u"encoders"].toArray()[0].toObject();
    EXPECT_EQ(encoder[u"place"].toString(), QStringLiteral("2.0"));
    const QJsonObject value = encoder[u"values"].toArray()[0].toObject();
    EXPECT_EQ(value[u"became"].toString(), QStringLiteral("written"));
    EXPECT_EQ(value[u"evidence"].toString(), QStringLiteral("echoed"));
    EXPECT_EQ(encoder[u"leftIn"].toString(), QStringLiteral("operation"));
    EXPECT_EQ(run.json()[u"eepromWrites"].toInt(), 1);
    EXPECT_FALSE(run.json()[u"trace"].toObject()[u"2.0"].toArray().isEmpty());
    QFile saved(account);
    ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
    EXPECT_THAT(saved.readAll().toStdString(), HasSubstr("Values written to encoders\n"));
}

TEST_F(CliTransfer, AnEncoderThatRefusesIsNamedAndTheExitCodeTellsIt)
{
    project.devices[1].wanted = {{Parameter::steps, 8193}, {Parameter::revolutions, 1}}; // 2.0
    save();
    const CliRun run = runIt("transfer @ --yes");
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("Not all of it was written, first of all to 2.0. Error 1:"));
    EXPECT_THAT(run.out, HasSubstr("  steps        = 255  Written, and read back"));
}

TEST_F(CliTransfer, APlaceOrAFileThatIsNotThereIsRefused)
{
    EXPECT_EQ(errorKey(runIt("transfer @ 9.0 --json")), "noSuchProjectDevice");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("transfer nowhere.codewheel --json"))), "fileNotReadable");
    project.devices.clear();
    save();
    EXPECT_EQ(errorKey(runIt("store @ --json")), "projectEmpty");
}

TEST_F(CliTransfer, StoreKeepsWhatWasReadInTheProject)
{
    const CliRun run = runIt("store @ 1.0 2.0");
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("  serial-number             = 20417 (4FC1h)   read\n"));
    EXPECT_THAT(run.out, HasSubstr("2.0  Baumer GXP6W K3\n  Nothing is known of it.\n"));
    EXPECT_EQ(shared.eepromWrites(), 0);
    const auto stored = loadProject(file);
    ASSERT_TRUE(stored);
    EXPECT_FALSE(stored->devices[0].stored.empty());
    EXPECT_TRUE(stored->devices[1].stored.empty());
    EXPECT_EQ(stored->devices[0].wanted, project.devices[0].wanted);
    EXPECT_EQ(runIt("transfer @ 1.0 --stored").exit, 0); // it already has it
}

TEST_F(CliTransfer, WhatAnotherProgramSavedMeanwhileIsNotOverwritten)
{
    Project other = project;
    other.title = QStringLiteral("of another program");
    QObject::connect(shared.bus().encoder("1.0"_ring), &EncoderSession::exchanged, &shared.bus(),
                     [&] { EXPECT_TRUE(saveProject(other, file)); });
    const CliRun run = runIt("store @ 1.0");
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("Another program has changed " + file.toStdString()));
    EXPECT_EQ(loadProject(file)->title, other.title);
}

TEST_F(CliTransfer, NothingIsReplacedWhereAnotherProgramChangedTheProjectMeanwhile)
{
    Project other = project;
    other.title = QStringLiteral("of another program");
    QObject::connect(shared.bus().encoder("2.0"_ring), &EncoderSession::latestChanged, &shared.bus(),
                     [&] { EXPECT_TRUE(saveProject(other, file)); });
    EXPECT_EQ(errorKey(runIt("replace 1.0 --project @ --device fraba-ocd-ib --serial 4711 --yes --json")),
              "fileChanged");
    EXPECT_EQ(shared.eepromWrites(), 0);
    EXPECT_EQ(loadProject(file)->title, other.title);
}

TEST_F(CliTransfer, CloneGivesTheValuesOfOneToAnother)
{
    ASSERT_EQ(runIt("transfer @ 1.0 --yes").exit, 0);
    const CliRun run = runIt("clone 1.0 6.1 --yes");
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("  steps        = 255     Written, and read back\n"));
    EXPECT_THAT(run.out, Not(HasSubstr("zero-offset")));
    EXPECT_EQ(runIt("clone 1.0 2.0 --yes").exit, 1);
    EXPECT_EQ(errorKey(runIt("clone 2.0 1.0 --json")), "nothingKnown");
}

TEST_F(CliTransfer, AnEncoderNamedTwiceIsMeantOnce)
{
    project.devices[0].station = QStringLiteral("Hoist"); // 1.0
    save();
    const CliRun stored = runIt("store @ 1.0 Hoist 1.0 --json");
    EXPECT_EQ(stored.exit, 0) << stored.err;
    EXPECT_EQ(stored.json()[u"encoders"].toArray().size(), 1);
    EXPECT_EQ(loadProject(file)->devices.size(), project.devices.size());
    const CliRun written = runIt("transfer @ 1.0 Hoist --yes --json");
    EXPECT_EQ(written.exit, 0) << written.err;
    EXPECT_EQ(written.json()[u"encoders"].toArray().size(), 1);
    EXPECT_EQ(written.json()[u"eepromWrites"].toInt(), shared.eepromWrites());
    const CliRun cloned = runIt("clone 1.0 6.1 6.1 --yes --json");
    EXPECT_EQ(cloned.exit, 0) << cloned.err;
    EXPECT_EQ(cloned.json()[u"encoders"].toArray().size(), 1);
}

TEST_F(CliTransfer, AReportThatCannotBeSavedIsToldBeforeAnythingIsWritten)
{
    for (const auto &[name, key] :
         {std::pair{"/nonexistent/x.html", "fileNotWritten"}, std::pair{"x.pdf", "reportFormatUnknown"}})
        EXPECT_EQ(errorKey(runIt((std::string("transfer @ --yes --json --report ") + name).c_str())), key);
    EXPECT_EQ(errorKey(runIt("transfer @ --dry-run --json --report x.html")), "reportOfDryRun");
    const QString account = folder.filePath(QStringLiteral("account.html"));
    ASSERT_TRUE(QFile::copy(file, account));
    const QString line = QStringLiteral("transfer %1 2.0 --json --report %2").arg(file, account);
    EXPECT_EQ(errorKey(shared.runLine(line)), "fileExists");
    EXPECT_EQ(shared.eepromWrites(), 0);
    EXPECT_EQ(shared.runLine(line + QStringLiteral(" --yes")).exit, 0);
}

TEST_F(CliTransfer, WhyAnEncoderWasNotWrittenIsToldBeforeAReportThatWasNotSaved)
{
    const QString reports = folder.filePath(QStringLiteral("reports"));
    ASSERT_TRUE(QDir().mkpath(reports));
    project.devices[1].wanted = {{Parameter::steps, 8193}, {Parameter::revolutions, 1}}; // 2.0
    save();
    QObject::connect(shared.bus().encoder("2.0"_ring), &EncoderSession::jobStarted, &shared.bus(),
                     [&] { QDir(reports).removeRecursively(); });
    const CliRun run =
        shared.runLine(QStringLiteral("transfer %1 2.0 --yes --report %2/x.html").arg(file, reports));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("first of all to 2.0. Error 1:"));
    EXPECT_THAT(run.err, HasSubstr("x.html cannot be written"));
}

// The project has a K1 before the K3s: each of its encoders is one place further on than on the bus.
class CliTransferShifted : public CliTransfer
{
protected:
    CliTransferShifted()
    {
        const Participant ofTheFront = project.devices[2].participant; // K1
        Project shifted;
        ProjectDevice front;
        front.participant = ofTheFront;
        front.participant.number = NodeId("1.0");
        shifted.devices.push_back(front);
        for (int i = 0; i < 4; ++i) {
            ProjectDevice device = project.devices[static_cast<std::size_t>(i)];
            device.participant.number = DeviceNumber{i + 2, 0}.node();
            device.participant.deviceKey.clear();
            shifted.devices.push_back(device);
        }
        shifted.devices[1].station = QStringLiteral("Hoist");
        project = shifted;
        save();
    }
};

TEST_F(CliTransferShifted, NothingIsWrittenToAnEncoderThatIsNotTheProjectsOne)
{
    EXPECT_EQ(errorKey(runIt("transfer @ Hoist --yes --json")), "busDiffers");
    const CliRun run = runIt("transfer @ 2.0 --yes");
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out,
                HasSubstr("2.0: configured is K3, make not known (its number is 1.0 now), found was Baumer "
                          "GXP6W K3. Compare, and take over what is right."));
    EXPECT_EQ(runIt("transfer @ --yes").exit, 1);
    EXPECT_EQ(shared.eepromWrites(), 0);
}

TEST_F(CliTransferShifted, NothingIsStoredOfAnEncoderThatIsNotTheProjectsOne)
{
    const CliRun run = runIt("store @");
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("2.0: nothing was stored.\n"));
    EXPECT_THAT(run.err, HasSubstr("1.0: configured is FRABA OCD-IB K1 (missing now), found was FRABA OCD"));
    const auto stored = loadProject(file);
    ASSERT_TRUE(stored);
    EXPECT_EQ(*stored, project);
}

TEST_F(CliTransferShifted, NothingIsReplacedOrRestoredThere)
{
    const QString as = QStringLiteral(" --project %1 --device fraba-ocd-ib --yes --json").arg(file);
    EXPECT_EQ(errorKey(shared.runLine(QStringLiteral("replace 2.0") + as)), "ringDiffers");
    EXPECT_EQ(errorKey(shared.runLine(QStringLiteral("restore 2.0 --json --yes --project ") + file)),
              "ringDiffers");
    EXPECT_EQ(shared.eepromWrites(), 0);
    const auto kept = loadProject(file);
    ASSERT_TRUE(kept);
    EXPECT_EQ(*kept, project);
}

} // namespace
} // namespace codewheel
