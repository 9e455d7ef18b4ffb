// SPDX-License-Identifier: GPL-3.0-or-later
// A kind of bus that the command line does not know.
#include "project/project_file.h"
#include "tests/kinds/plain/plain_calls.h"

#include <QFile>
#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

class CliPlainBus : public test::PlainCalls
{};

TEST_F(CliPlainBus, MonitorShowsItsPositions)
{
    const CliRun shown = run(QStringLiteral("monitor n:2 --for 1 --every 500"));
    EXPECT_EQ(shown.exit, 0) << shown.err;
    EXPECT_THAT(shown.out, HasSubstr("      0.0  000003E9      1001"));
    EXPECT_THAT(shown.out, HasSubstr("   1000.0  000007D1      2001"));
    const QJsonObject json = run(QStringLiteral("monitor Plain/n:2 --for 1 --every 500 --json")).json();
    EXPECT_EQ(json[u"busName"], QStringLiteral("Plain"));
    EXPECT_EQ(json[u"bus"], 9);
    EXPECT_EQ(json[u"place"], QStringLiteral("n:2"));
    EXPECT_EQ(json[u"samples"].toArray().size(), 3);
}

TEST_F(CliPlainBus, WhatIsNoEncoderOrNotThereIsRefused)
{
    EXPECT_EQ(errorKey(run(QStringLiteral("monitor n:3 --json"))), "noEncoder");
    EXPECT_EQ(errorKey(run(QStringLiteral("monitor n:4 --json"))), "unknownDevice");
    EXPECT_EQ(errorKey(run(QStringLiteral("monitor 1.0 --json"))), "placeOnBus");
}

TEST_F(CliPlainBus, ScanTellsAndKeepsWhatStandsThere)
{
    const CliRun scan = run(QStringLiteral("scan --save ") + file);
    EXPECT_EQ(scan.exit, 0) << scan.err;
    EXPECT_THAT(scan.out, HasSubstr("n:3          -        Lamp\n"));
    const Project project = *loadProject(file);
    ASSERT_EQ(devicesOn(project, test::plainId).size(), 3U);
    const Participant &kept = project.devices[1].participant;
    EXPECT_EQ(kept.deviceKey, QStringLiteral("plain-node"));
    EXPECT_EQ(kept.details, KindData(test::PlainDetails{.inputBytes = 3}));
    EXPECT_EQ(run(QStringLiteral("monitor n:1 --for 1 --project ") + file).exit, 0);
}

TEST_F(CliPlainBus, ScanLeavesWhatTheProjectHasOfADevice)
{
    EXPECT_EQ(run(QStringLiteral("scan --save ") + file).exit, 0);
    Project project = *loadProject(file);
    project.devices[0].set(test::PlainNodeSettings{.heartbeat = 250});
    EXPECT_TRUE(saveProject(project, file));
    EXPECT_EQ(run(QStringLiteral("scan --yes --project %1 --save %1").arg(file)).exit, 0);
    EXPECT_EQ(loadProject(file)->devices[0].its<test::PlainNodeSettings>().heartbeat, 250);
}

TEST_F(CliPlainBus, WritesNumbersBelowZeroAndTexts)
{
    const CliRun written = run(QStringLiteral("write n:1 2000:1=-5 1008=Hoist steps=100 --yes"));
    EXPECT_EQ(written.exit, 0) << written.err;
    EXPECT_THAT(written.out, HasSubstr("set 2000:1=-5"));
    EXPECT_THAT(written.out, HasSubstr("EEPROM writes:   1"));
    const CliRun read = run(QStringLiteral("read n:1 2000:1 1008"));
    EXPECT_THAT(read.out, HasSubstr("-5"));
    EXPECT_THAT(read.out, HasSubstr("Hoist"));
    const QJsonArray values = run(QStringLiteral("read n:1 2000:1 1008 --json")).json()[u"values"].toArray();
    ASSERT_EQ(values.size(), 2);
    EXPECT_EQ(values[0][u"value"], -5);
    EXPECT_EQ(values[1][u"value"], QStringLiteral("Hoist"));
}

TEST_F(CliPlainBus, TellsWhetherItsValuesAreStored)
{
    EXPECT_EQ(run(QStringLiteral("read n:1 steps --json")).json()[u"values"][0][u"kept"],
              QStringLiteral("notKnown"));
    EXPECT_FALSE(run(QStringLiteral("read n:1 serial-number --json"))
                     .json()[u"values"][0]
                     .toObject()
                     .contains(u"kept"));
    const CliRun written = run(QStringLiteral("write n:1 steps=4096 --yes"));
    EXPECT_EQ(written.exit, 0) << written.err;
    EXPECT_THAT(written.out, HasSubstr("In force already; only stored"));
    EXPECT_THAT(written.out, HasSubstr("in force before, and stored now"));
    EXPECT_THAT(written.out, HasSubstr("EEPROM writes:   1"));
    EXPECT_EQ(bus.node(test::plainHoist).writes(), 1);
    EXPECT_THAT(run(QStringLiteral("read n:1 steps")).out, HasSubstr("stored\n"));
    EXPECT_THAT(run(QStringLiteral("write n:1 steps=4096 --yes")).out, HasSubstr("nothing to write"));
    const QJsonObject json = run(QStringLiteral("write n:1 steps=100 --yes --json")).json();
    EXPECT_EQ(json[u"plan"][0][u"kept"], QStringLiteral("stored"));
    EXPECT_EQ(json[u"written"][0][u"kept"], QStringLiteral("stored"));
    EXPECT_TRUE(json[u"stored"].toArray().isEmpty());
}

TEST_F(CliPlainBus, ATransferStoresWhatIsInForce)
{
    want(test::plainGate, {{test::plainFilter(), 0}});
    const QString transfer = QStringLiteral("transfer ") + file + QStringLiteral(" --yes");
    const CliRun transferred = run(transfer);
    EXPECT_EQ(transferred.exit, 0) << transferred.err;
    EXPECT_THAT(transferred.out, HasSubstr("In force before, and stored now"));
    EXPECT_THAT(transferred.out, HasSubstr("Stored, in force before: 1."));
    EXPECT_THAT(transferred.out, HasSubstr("Written: 0. Already there: 0. EEPROM writes: 1."));
    EXPECT_THAT(run(transfer).out, HasSubstr("It has everything already"));
    EXPECT_EQ(bus.node(test::plainGate).writes(), 1);
}

TEST_F(CliPlainBus, WhatDoesNotFitIsRefused)
{
    EXPECT_EQ(errorKey(run(QStringLiteral("write n:1 2000:1=-1001 --yes --json"))), "valueOutOfRange");
    const CliRun tooLong = run(QStringLiteral("write n:1 1008=seventeen-letters --yes"));
    EXPECT_EQ(tooLong.exit, 2);
    EXPECT_THAT(tooLong.err, HasSubstr("a text of at most 16 characters"));
    EXPECT_TRUE(bus.node(test::plainHoist).heard().empty());
}

TEST_F(CliPlainBus, TransfersWhatAProjectWants)
{
    const ParameterValues wanted{{test::plainName(), Value(QStringLiteral("Gate 1"))},
                                 {test::plainFilter(), -5}};
    want(test::plainGate, wanted);
    EXPECT_EQ(loadProject(file)->devices[1].wanted, wanted);
    const CliRun transferred = run(QStringLiteral("transfer ") + file + QStringLiteral(" --yes"));
    EXPECT_EQ(transferred.exit, 0) << transferred.err;
    EXPECT_THAT(transferred.out, HasSubstr("Written: 2. Already there: 0. EEPROM writes: 1."));
    EXPECT_EQ(bus.node(test::plainGate).inForce("1008"), "Gate%201");
    EXPECT_TRUE(bus.node(test::plainHoist).heard().empty());
}

TEST_F(CliPlainBus, GivesAnotherEncoderTheSameValues)
{
    EXPECT_EQ(run(QStringLiteral("write n:1 2000:1=-5 1008=Hoist direction=ccw --yes")).exit, 0);
    const CliRun cloned = run(QStringLiteral("clone n:1 n:2 --yes"));
    EXPECT_EQ(cloned.exit, 0) << cloned.err;
    EXPECT_EQ(bus.node(test::plainGate).inForce("2000:1"), "-5");
    EXPECT_EQ(bus.node(test::plainGate).inForce("1008"), "Hoist");
    EXPECT_EQ(bus.node(test::plainGate).inForce("direction"), "1");
}

TEST_F(CliPlainBus, ReplacesAnEncoder)
{
    want(test::plainHoist, {{test::plainFilter(), 12}});
    const CliRun replaced =
        run(QStringLiteral("replace n:1 --serial 7001 --position 500 --yes --project ") + file);
    EXPECT_EQ(replaced.exit, 0) << replaced.err;
    EXPECT_EQ(bus.node(test::plainHoist).inForce("2000:1"), "12");
    EXPECT_THAT(bus.node(test::plainHoist).heard(), testing::Contains("to 500"));
}

TEST_F(CliPlainBus, WhatItCannotDoIsRefused)
{
    for (const char *line : {"reset n:1 --yes", "cams n:1 read", "velocity n:1 on", "words n:1 0"}) {
        const CliRun refused = run(QLatin1String(line));
        EXPECT_EQ(refused.exit, 1) << line;
        EXPECT_THAT(refused.err, HasSubstr("Plain P1")) << line;
    }
    EXPECT_TRUE(bus.node(test::plainHoist).heard().empty());
}

TEST_F(CliPlainBus, IsRecordedAndExported)
{
    const QString recording = folder.filePath(QStringLiteral("plain.cwrec"));
    const CliRun recorded = run(QStringLiteral("record n:1 --for 2 -o ") + recording);
    EXPECT_EQ(recorded.exit, 0) << recorded.err;
    const CliRun exported = run(QStringLiteral("export ") + recording + QStringLiteral(" -o ") +
                                folder.filePath(QStringLiteral("plain.csv")));
    EXPECT_EQ(exported.exit, 0) << exported.err;
    QFile csv(folder.filePath(QStringLiteral("plain.csv")));
    ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
    EXPECT_THAT(csv.readAll().toStdString(), HasSubstr("n:1"));
}

TEST_F(CliPlainBus, SetsThePosition)
{
    const CliRun set = run(QStringLiteral("preset n:1 500 --yes"));
    EXPECT_EQ(set.exit, 0) << set.err;
    EXPECT_THAT(set.out, HasSubstr("500"));
}

} // namespace
} // namespace codewheel
