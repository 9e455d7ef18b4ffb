// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/plan/canopen_plan.h"
#include "kinds/canopen/protocol/canopen_address.h"
#include "project/project_file.h"
#include "tests/cli/kinds/canopen/shared_can_bus.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

TEST(CliOd, ReadsAnObjectAsNumberOrText)
{
    SharedCanBus bus;
    EXPECT_EQ(bus.runLine(QStringLiteral("od can:5 read 6004")).out, "6004h:0 = 00001388h, 5000\n");
    EXPECT_EQ(bus.runLine(QStringLiteral("od can:5 read 0x1018:4h")).out,
              "1018h:4 serial-number = 0012D591h, 1234321\n");
    EXPECT_EQ(bus.runLine(QStringLiteral("od can:5 read 1008")).out, "1008h:0 1008 = \"SIM13-CO\"\n");
}

TEST(CliOd, TellsProgramsTheSame)
{
    SharedCanBus bus;
    const QJsonObject json = bus.runLine(QStringLiteral("od can:5 read 1018:4 --json")).json();
    EXPECT_EQ(json[u"index"], QStringLiteral("1018"));
    EXPECT_EQ(json[u"sub"], 4);
    EXPECT_EQ(json[u"value"], 1'234'321);
    EXPECT_EQ(json[u"octets"], QStringLiteral("91 D5 12 00"));
    EXPECT_EQ(json[u"place"], QStringLiteral("can:5"));
}

TEST(CliOd, AsksBeforeItWritesAndReadsBack)
{
    SharedCanBus bus;
    const CliRun refused = bus.runLine(QStringLiteral("od can:6 write 6001=4096"), {true, "n\n"});
    EXPECT_EQ(refused.exit, 2);
    EXPECT_THAT(refused.out, HasSubstr("6001h:0 steps := 00001000h, 4096 (now 00002000h, 8192)"));
    EXPECT_THAT(bus.runLine(QStringLiteral("od can:6 read 6001")).out, HasSubstr("8192"));

    const CliRun done = bus.runLine(QStringLiteral("od can:6 write 6001=1000h"), {true, "y\n"});
    EXPECT_EQ(done.exit, 0);
    EXPECT_THAT(done.out, HasSubstr("Written, and read back."));
    const QJsonObject json = bus.runLine(QStringLiteral("od can:6 write 6001=8192 --yes --json")).json();
    EXPECT_EQ(json[u"fate"], QStringLiteral("readBack"));
    EXPECT_EQ(json[u"before"], 4'096);
    EXPECT_EQ(json[u"after"], 8'192);
    EXPECT_EQ(bus.eepromWritesOf6(), 0U);
}

TEST(CliOd, WhatMaySetThePositionIsSaidBefore)
{
    SharedCanBus bus;
    EXPECT_THAT(bus.runLine(QStringLiteral("od can:6 write 6003=5"), {true, "n\n"}).out,
                HasSubstr("It sets the position at once."));
    EXPECT_THAT(bus.runLine(QStringLiteral("od can:6 write 2000=9"), {true, "n\n"}).out,
                HasSubstr("It is an object of the maker"));
    EXPECT_THAT(bus.runLine(QStringLiteral("od can:6 write 6001=5"), {true, "n\n"}).out,
                testing::Not(HasSubstr("position")));
}

TEST(CliOd, NobodyToAskMeansNothingIsWritten)
{
    SharedCanBus bus;
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("od can:6 write 6001=4096 --json"))), "noConsent");
    EXPECT_THAT(bus.runLine(QStringLiteral("od can:6 read 6001")).out, HasSubstr("8192"));
}

TEST(CliOd, StoringCountsAsAWriteToTheEeprom)
{
    QTemporaryDir folder;
    const QString ledger = QStringLiteral(" --ledger ") + folder.filePath(QStringLiteral("ledger"));
    SharedCanBus bus;
    const CliRun run = bus.runLine(QStringLiteral("od can:6 write 1010:1=save --yes") + ledger);
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("It counts as a write to the EEPROM."));
    EXPECT_EQ(bus.eepromWritesOf6(), 1U);
    EXPECT_THAT(runLine(QStringLiteral("ledger") + ledger).out, HasSubstr("1234340"));
}

TEST(CliOd, WhatTheEncoderRefusesIsToldWithItsReason)
{
    SharedCanBus bus;
    const CliRun missing = bus.runLine(QStringLiteral("od can:5 read 6001 --json"));
    EXPECT_EQ(missing.exit, 1);
    EXPECT_EQ(errorKey(missing), "sdoAborted");
    EXPECT_THAT(missing.err, HasSubstr("06020000h"));
    const CliRun readOnly = bus.runLine(QStringLiteral("od can:6 write 6004=1 --yes --json"));
    EXPECT_EQ(readOnly.exit, 1);
    EXPECT_EQ(readOnly.json()[u"fate"], QStringLiteral("refused"));
}

TEST(CliOd, ANodeThatIsSilentIsToldSo)
{
    SharedCanBus bus;
    const CliRun run = bus.runLine(QStringLiteral("od can:50 read 1008 --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "sdoNoAnswer");
}

TEST(CliOd, WrongCallsAreRefusedBeforeAnythingIsSent)
{
    SharedCanBus bus;
    const auto key = [&](const char *line) {
        const CliRun run = bus.runLine(QString::fromLatin1(line) + QStringLiteral(" --json"));
        EXPECT_EQ(run.exit, 2) << line;
        return errorKey(run);
    };
    EXPECT_EQ(key("od can:5 go 6004"), "odActionWrong");
    EXPECT_EQ(key("od can:5 read position"), "objectWrong");
    EXPECT_EQ(key("od can:5 read 6004:256"), "objectWrong");
    EXPECT_EQ(key("od can:5 read 6004=1"), "valueNotRead");
    EXPECT_EQ(key("od can:5 write 6004"), "valueMissing");
    EXPECT_EQ(key("od can:200 read 6004"), "canopenNodeNumberWrong");
    EXPECT_EQ(key("od can:5 read 6004 --type f32"), "optionNotAllowed");
    EXPECT_EQ(key("od can:6 write 6001=4294967296 --yes"), "objectValueWrong");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("od 1.0 read 6004 --json"))), "notANode");
}

// A planned encoder, number 17, on a bus that the project has no link for.
class CliOdOfPlan : public testing::Test
{
protected:
    CliOdOfPlan()
        : m_before(qgetenv("XDG_DATA_HOME"))
    {
        qputenv("XDG_DATA_HOME", folder.path().toLocal8Bit());
    }
    ~CliOdOfPlan() override { qputenv("XDG_DATA_HOME", m_before); }

    void plan(const QString &device, const QString &file = {})
    {
        Project project;
        setCanopenPlan(project, firstCanBus, {});
        std::vector<ProjectDevice> devices(1);
        devices[0].standAt({firstCanBus, NodeId("can:17")});
        devices[0].participant.deviceKey = device;
        if (!file.isEmpty())
            devices[0].set(CanopenEncoderSettings{.file = file});
        setDevicesOn(project, firstCanBus, std::move(devices));
        ASSERT_TRUE(saveProject(project, path));
    }
    CliRun od(const QString &options = {}) const
    {
        return runLine(
            QStringLiteral("od can:17 --link project --project %1 %2").arg(path, options).trimmed());
    }
    QString write(const QString &name)
    {
        QFile file(folder.filePath(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("[DeviceInfo]\nVendorName=Rotor Works\nProductName=Rotor 13\n"
                   "[1000]\nParameterName=Device type\nDataType=7\nAccessType=ro\nDefaultValue=0x20196\n"
                   "[1800]\nParameterName=TPDO 1\nObjectType=9\n[1800sub1]\nParameterName=Identifier\n"
                   "DataType=7\nAccessType=rw\nDefaultValue=$NODEID+0x180\n"
                   "[2101]\nParameterName=Filter depth\nDataType=5\nAccessType=rw\nDefaultValue=7\n"
                   "[6001]\nParameterName=Steps\nDataType=7\nAccessType=rw\nDefaultValue=4096\n");
        return file.fileName();
    }

    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("p.codewheel"));

private:
    const QByteArray m_before;
};

TEST_F(CliOdOfPlan, TheImportedDescriptionTellsObjectsAndDefaultsAndNothingIsRead)
{
    EXPECT_EQ(runLine(QStringLiteral("eds %1 --import").arg(write(QStringLiteral("rotor.eds")))).exit, 0);
    plan(QStringLiteral("rotor-works-rotor-13"));
    const CliRun run = od();
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("Node 17 (11h): nothing was read. Objects and defaults are those that the "
                                   "description of Rotor Works Rotor 13 tells"));
    EXPECT_THAT(run.out, testing::ContainsRegex("\n2101:0 +Filter depth +u8 +ro +7 "));
    EXPECT_THAT(run.out, testing::ContainsRegex("\n6001:0 .* 4096 "));
    const QJsonObject json = od(QStringLiteral("--json")).json();
    EXPECT_EQ(json[u"isRead"], false);
    EXPECT_EQ(json[u"device"], QStringLiteral("rotor-works-rotor-13"));
    EXPECT_EQ(json[u"place"], QStringLiteral("can:17"));
    EXPECT_GT(json[u"objects"].toArray().size(), 20);
}

TEST_F(CliOdOfPlan, TheFileOfTheProjectGoesBeforeTheDescription)
{
    write(QStringLiteral("rotor.eds"));
    plan(QStringLiteral("canopen-406-multi-turn"), QStringLiteral("/elsewhere/rotor.eds"));
    const CliRun run = od();
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("those of " + folder.filePath(QStringLiteral("rotor.eds")).toStdString()));
    EXPECT_THAT(run.out, testing::ContainsRegex("\n1800:1 +Identifier +u32 +rw +401 ")) << "of node 17";
    plan(QStringLiteral("canopen-406-multi-turn"), QStringLiteral("/elsewhere/gone.eds"));
    const CliRun gone = od();
    EXPECT_EQ(gone.exit, 0);
    EXPECT_THAT(gone.err, HasSubstr("/elsewhere/gone.eds"));
    EXPECT_THAT(gone.out, HasSubstr("CiA 406, of which no device has all"));
}

TEST_F(CliOdOfPlan, AnActionWithoutAnObjectIsNoList)
{
    plan(QStringLiteral("canopen-406-multi-turn"));
    EXPECT_EQ(errorKey(runLine(QStringLiteral("od can:17 read --json --link project --project ") + path)),
              "missingArgument");
}

} // namespace
} // namespace codewheel
