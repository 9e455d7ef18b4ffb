// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/kinds/canopen/shared_can_bus.h"
#include "user_devices.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

// Files in a folder, and a data folder of its own.
class CliEds : public testing::Test
{
protected:
    CliEds()
        : m_before(qgetenv("XDG_DATA_HOME"))
    {
        qputenv("XDG_DATA_HOME", m_folder.path().toLocal8Bit());
    }
    ~CliEds() override { qputenv("XDG_DATA_HOME", m_before); }

    QString write(const QString &name, const QByteArray &bytes) const
    {
        QFile file(m_folder.filePath(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        return file.fileName();
    }
    QByteArray read(const QString &name) const
    {
        QFile file(m_folder.filePath(name));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
        return file.readAll();
    }

    const QTemporaryDir m_folder;
    const QByteArray m_before;
};

// Of the simulated encoders, of which node 6 is one.
QByteArray simulatedFile(const QByteArray &identity = {})
{
    return "[DeviceInfo]\nVendorName=Sim Works\nProductName=Sim 13\n" + identity +
           "[1000]\nParameterName=Device type\nDataType=7\nAccessType=ro\nDefaultValue=0x00020196\n"
           "[1008]\nParameterName=Name\nDataType=9\nAccessType=const\n"
           "[1010]\nParameterName=Store\nObjectType=8\n[1010sub1]\nDataType=7\nAccessType=rw\n"
           "[1017]\nParameterName=Heartbeat\nDataType=6\nAccessType=rw\nDefaultValue=0\n"
           "[6001]\nParameterName=Steps\nDataType=7\nAccessType=rw\nDefaultValue=8192\nLowLimit=1\n"
           "HighLimit=8192\n"
           "[6002]\nParameterName=Range\nDataType=7\nAccessType=rw\n"
           "[6003]\nParameterName=Preset\nDataType=7\nAccessType=rw\n"
           "[5FFF]\nParameterName=Nothing\nDataType=7\nAccessType=rw\n";
}

TEST_F(CliEds, ComparesTwoFiles)
{
    const QString one = write(QStringLiteral("one.eds"), simulatedFile());
    EXPECT_THAT(runLine(QStringLiteral("eds %1 --compare %1").arg(one)).out, "All values are the same.\n");
    const QString third =
        write(QStringLiteral("third.dcf"), simulatedFile().replace("8192\nLow", "4096\nLow"));
    const CliRun differs = runLine(QStringLiteral("eds %1 --compare %2").arg(one, third));
    EXPECT_EQ(differs.exit, 1);
    EXPECT_THAT(differs.out, ContainsRegex("^6001:0 +Steps +differs +8192 +4096\n$"));
    EXPECT_EQ(errorKey(runLine(QStringLiteral("eds %1 --compare %2 --json").arg(one, third))), "filesDiffer");
    const QJsonObject json = runLine(QStringLiteral("eds %1 --compare %2 --json").arg(one, third)).json();
    EXPECT_EQ(json[u"differences"].toArray().size(), 1);
    EXPECT_EQ(json[u"differences"][0].toObject(),
              (QJsonObject{{QStringLiteral("index"), QStringLiteral("6001")},
                           {QStringLiteral("sub"), 0},
                           {QStringLiteral("name"), QStringLiteral("Steps")},
                           {QStringLiteral("comparison"), QStringLiteral("differs")},
                           {QStringLiteral("value"), 8192},
                           {QStringLiteral("other"), 4096}}));
}

TEST_F(CliEds, SaysWhatOfAFileIsLeftOutOfAccount)
{
    const QString dcf = write(QStringLiteral("old.dcf"),
                              simulatedFile() + "[DeviceComissioning]\nNodeID=6\nBaudrate=16960\n");
    const CliRun run = runLine(QStringLiteral("eds %1 --compare %1").arg(dcf));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.err, HasSubstr("Baudrate: \"16960\" is no rate of CANopen in kBd"));
}

TEST_F(CliEds, SavesADcfAndReplacesNoneUnasked)
{
    const QString eds = write(QStringLiteral("sim.eds"), simulatedFile());
    const QString dcf = m_folder.filePath(QStringLiteral("sim.dcf"));
    const QString call = QStringLiteral("eds %1 --save %2 --node 9 --rate 250000").arg(eds, dcf);
    EXPECT_EQ(runLine(call).exit, 0);
    EXPECT_THAT(read(QStringLiteral("sim.dcf")).toStdString(),
                HasSubstr("[DeviceComissioning]\r\nNodeID=9\r\nNodeName=\r\nBaudrate=250\r\n"));
    EXPECT_EQ(errorKey(runLine(call + QStringLiteral(" --json"))), "fileExists");
    EXPECT_EQ(runLine(call + QStringLiteral(" --yes")).exit, 0);
    EXPECT_EQ(runLine(QStringLiteral("devices --check ") + dcf).exit, 0);
    EXPECT_EQ(runLine(QStringLiteral("eds %1 --save %2 --yes --rate 200000").arg(eds, dcf)).exit, 2);
    EXPECT_EQ(runLine(QStringLiteral("eds %1 --save %2 --yes --node 128").arg(eds, dcf)).exit, 2);
}

TEST_F(CliEds, ReadsANodeAndWritesNothingToIt)
{
    SharedCanBus bus;
    const QString eds = write(QStringLiteral("sim.eds"), simulatedFile());
    const QString dcf = m_folder.filePath(QStringLiteral("node6.dcf"));
    const CliRun run = bus.runLine(QStringLiteral("eds %1 --read can:6 --save %2").arg(eds, dcf));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, ContainsRegex("1017:0 +Heartbeat +differs +0 +1000\n"));
    const std::string written = read(QStringLiteral("node6.dcf")).toStdString();
    EXPECT_THAT(written, HasSubstr("NodeID=6\r\n"));
    EXPECT_THAT(written, HasSubstr("[1017]\r\n"));
    EXPECT_THAT(written, HasSubstr("ParameterValue=1000\r\n"));
    EXPECT_EQ(QString::fromStdString(written)
                  .section(QStringLiteral("[6003]"), 1)
                  .section(u'[', 0, 0)
                  .count(QStringLiteral("ParameterValue")),
              0)
        << "writing the preset sets the position";
    EXPECT_EQ(bus.eepromWritesOf6(), 0U);
    const QJsonObject json = bus.runLine(QStringLiteral("eds %1 --read can:6 --json").arg(eds)).json();
    EXPECT_EQ(json[u"notRead"].toArray().size(), 1);
    EXPECT_EQ(json[u"notRead"][0][u"index"], QStringLiteral("5FFF"));
    EXPECT_EQ(json[u"notRead"][0][u"abortCode"], QStringLiteral("06020000"));
}

TEST_F(CliEds, ANodeThatDoesNotAnswerIsTold)
{
    SharedCanBus bus;
    const QString eds = write(QStringLiteral("sim.eds"), simulatedFile());
    const CliRun run = bus.runLine(QStringLiteral("eds %1 --read can:99 --json").arg(eds));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "sdoNoAnswer");
}

TEST_F(CliEds, ImportsADescriptionByWhichANodeIsRecognised)
{
    SharedCanBus bus;
    const auto wordOf6 = [&](int sub) {
        return QByteArray::number(bus.runLine(QStringLiteral("od can:6 read 1018:%1 --json").arg(sub))
                                      .json()[u"value"]
                                      .toInteger());
    };
    const QString eds = write(QStringLiteral("sim.eds"),
                              simulatedFile("VendorNumber=" + wordOf6(1) + "\nProductNumber=" + wordOf6(2) +
                                            "\nRevisionNumber=" + wordOf6(3) + "\n"));
    const CliRun run = runLine(QStringLiteral("eds %1 --import").arg(eds));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("Sim Works Sim 13 is described as sim-works-sim-13, with "));
    EXPECT_TRUE(QFileInfo::exists(userDeviceFolder() + QStringLiteral("/sim-works-sim-13.json")));
    EXPECT_EQ(errorKey(runLine(QStringLiteral("eds %1 --import --json").arg(eds))), "fileExists");
    EXPECT_EQ(runLine(QStringLiteral("eds %1 --import --yes").arg(eds)).exit, 0);
    EXPECT_THAT(runLine(QStringLiteral("devices sim-works-sim-13")).out,
                ContainsRegex("\nsteps +6001h:0 +6001h:0 +8,?192 +steps +1\\.\\.8192\n"));
    EXPECT_THAT(runLine(QStringLiteral("scan --ask --link canopen:training")).out,
                ContainsRegex("\ncan:6 .*sim-works-sim-13"));
    EXPECT_EQ(runLine(QStringLiteral("read can:6 steps --link canopen:training --json"))
                  .json()[u"device"]
                  .toString()
                  .toStdString(),
              "sim-works-sim-13");
    EXPECT_EQ(runLine(QStringLiteral("eds %1 --import --name mine").arg(eds)).exit, 0);
    EXPECT_EQ(runLine(QStringLiteral("devices mine")).exit, 0);
}

TEST_F(CliEds, WhatIsNoEncoderIsNotImported)
{
    const QString lift = write(QStringLiteral("tilt.eds"), "[1000]\nDataType=7\nDefaultValue=0x1019A\n");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("eds %1 --import --json").arg(lift))), "noEncoder");
    const QString silent = write(QStringLiteral("silent.eds"), "[1000]\nDataType=7\n[6004]\nDataType=7\n");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("eds %1 --import --json").arg(silent))), "formNotTold");
    EXPECT_EQ(runLine(QStringLiteral("eds %1 --import --as canopen-406-linear").arg(silent)).exit, 0);
    EXPECT_EQ(errorKey(runLine(QStringLiteral("eds %1 --import --as twk-k3 --json").arg(silent))),
              "notOfCia406");
}

} // namespace
} // namespace codewheel
