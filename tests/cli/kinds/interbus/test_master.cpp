// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/cli_run.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

// Fault plans in files, as options of a call.
class CliMaster : public testing::Test
{
protected:
    QString plan(const char *steps)
    {
        const QString path = m_folder.filePath(QStringLiteral("plan.json"));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QByteArray("{\"format\": \"codewheel-faults\", \"version\": 1, \"steps\": [") + steps +
                   "]}");
        return QStringLiteral(" --fault-plan ") + path;
    }

    QTemporaryDir m_folder;
};

TEST_F(CliMaster, TellsHowItStands)
{
    const CliRun run = runLine(QStringLiteral("master"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("The master keeps the configuration training.json (7 devices)."));
    EXPECT_THAT(run.out, HasSubstr("Master:         RUN\n"
                                   "Status:         00E0h (READY, ACTIVE, RUN)\n"
                                   "Fault:          none\n"
                                   "Configuration:  training.json\n"));
}

TEST_F(CliMaster, FindsTheFaultOfAPlan)
{
    const QString broken = plan(R"({"at": 100, "fault": "wireBreak", "place": "4.0"})");
    const CliRun run = runLine(QStringLiteral("master --json --after 200") + broken);
    EXPECT_EQ(run.exit, 0);
    const QJsonObject master = run.json()[u"master"].toObject();
    EXPECT_EQ(master[u"state"].toString(), QStringLiteral("busFail"));
    EXPECT_EQ(master[u"status"].toString(), QStringLiteral("0084"));
    EXPECT_EQ(master[u"parameter"].toString(), QStringLiteral("0380"));
    EXPECT_EQ(master[u"fault"].toObject(),
              (QJsonObject{{QStringLiteral("place"), QStringLiteral("3.0")},
                           {QStringLiteral("spot"), QStringLiteral("outgoingRemoteBus")}}));
    EXPECT_EQ(master[u"devices"].toArray()[2].toObject()[u"inRing"].toBool(), true);
    EXPECT_EQ(master[u"devices"].toArray()[3].toObject()[u"inRing"].toBool(), false);
    const QJsonObject last = run.json()[u"messages"].toArray().last().toObject();
    EXPECT_EQ(last[u"key"].toString(), QStringLiteral("busFault"));
    EXPECT_EQ(last[u"milliseconds"].toInt(), 121);
}

TEST_F(CliMaster, CannotBeStartedWhileTheFaultIsThere)
{
    const QString broken = plan(R"({"at": 100, "fault": "wireBreak", "place": "4.0"})");
    const CliRun run = runLine(QStringLiteral("master start --after 200") + broken);
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("The bus does not run: 0D10 at outgoing remote bus of 3.0"));
}

TEST_F(CliMaster, ReadsInTheRingAsItIs)
{
    const QString broken = plan(R"({"at": 100, "fault": "wireBreak", "place": "4.0"})");
    const CliRun run = runLine(QStringLiteral("master read-in --yes --after 200") + broken);
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("The ring was read in: 3 devices."));
    EXPECT_THAT(run.out, HasSubstr("Master:         RUN"));
    EXPECT_THAT(run.out, testing::Not(HasSubstr("is gone"))); // the wire is still broken
}

TEST_F(CliMaster, SwitchesASegmentOff)
{
    const CliRun run = runLine(QStringLiteral("master segment 6 off --yes"));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("01E0h"));
    EXPECT_THAT(run.out, HasSubstr("Segment 6:      switched off"));
}

TEST_F(CliMaster, ASegmentThatIsNotThereIsRefusedInWords)
{
    const CliRun run = runLine(QStringLiteral("master segment 99 off --yes"));
    EXPECT_EQ(run.exit, 2);
    EXPECT_THAT(run.err,
                HasSubstr("There is no device at 99.0. There are devices at: 1.0, 2.0, 3.0, 4.0, 5.0, 6.0."));
}

TEST_F(CliMaster, SaysThatNoDeviceAnswered)
{
    const QString broken = plan(R"({"at": 10, "fault": "wireBreak", "place": "1.0"})");
    const CliRun run = runLine(QStringLiteral("master read-in --yes --after 100") + broken);
    EXPECT_THAT(run.out, HasSubstr("No device answered when the ring was read in."));
    EXPECT_THAT(run.out, testing::Not(HasSubstr("0 devices")));
    EXPECT_THAT(run.out, HasSubstr("Fault:          not looked for in READY"));
}

TEST_F(CliMaster, WhatChangesTheRingIsNotDoneWithoutConsent)
{
    for (const char *line :
         {"master read-in", "master confirm", "master segment 6 off", "master segment 6 on"}) {
        const CliRun run = runLine(QString::fromLatin1(line) + QStringLiteral(" --json"));
        EXPECT_EQ(run.exit, 2) << line;
        EXPECT_EQ(errorKey(run), "noConsent") << line;
    }
    for (const char *line : {"master start", "master stop", "master alarm-stop", "master confirm --yes"})
        EXPECT_EQ(runLine(QString::fromLatin1(line)).exit, 0) << line;
}

TEST_F(CliMaster, TheQuestionNamesWhatGoesWithASegment)
{
    const CliRun no = runLine(QStringLiteral("master segment 6 off"), {true, "no\n"});
    EXPECT_EQ(no.exit, 2);
    EXPECT_THAT(no.out + no.err,
                HasSubstr("Switch segment 6 off? Out of the data cycles go, with outputs at 0: 6.0, 6.1."));
    const CliRun yes = runLine(QStringLiteral("master segment 6 off"), {true, "yes\n"});
    EXPECT_EQ(yes.exit, 0) << yes.err;
    EXPECT_THAT(yes.out, HasSubstr("Segment 6:      switched off"));
}

TEST_F(CliMaster, TakesNoOtherAction)
{
    for (const char *line : {"master dance", "master segment", "master segment x on", "master start now"}) {
        const CliRun run = runLine(QString::fromLatin1(line));
        EXPECT_EQ(run.exit, 2) << line;
        EXPECT_THAT(run.err, HasSubstr("not an action of the master")) << line;
    }
}

TEST_F(CliMaster, APlanThatIsBrokenOrNotThereIsTold)
{
    const CliRun broken =
        runLine(QStringLiteral("scan") + plan(R"({"at": 1, "fault": "fire", "place": "1.0"})"));
    EXPECT_EQ(broken.exit, 2);
    EXPECT_THAT(broken.err, HasSubstr("line 1, steps[0].fault:"));
    const CliRun missing = runLine(QStringLiteral("scan --json --fault-plan nowhere.json"));
    EXPECT_EQ(missing.exit, 2);
    EXPECT_EQ(errorKey(missing), "fileNotReadable");
}

// A job ended by a bus fault is reported as such.
TEST_F(CliMaster, AJobThatTheFaultEndsIsRefused)
{
    const QString broken = plan(R"({"at": 5, "fault": "noSupply", "place": "2.0"})");
    const CliRun run = runLine(QStringLiteral("read 1.0") + broken);
    EXPECT_EQ(run.exit, 1);
}

} // namespace
} // namespace codewheel
