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

// A folder with one file.
class CliDeviceFile : public testing::Test
{
protected:
    CliRun check(const QString &name, const QByteArray &bytes, const QString &options = {})
    {
        QFile file(m_folder.filePath(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        return runLine(QStringLiteral("devices --check %1 %2").arg(file.fileName(), options).trimmed());
    }

    const QTemporaryDir m_folder;
};

const QByteArray rotorFile = "[DeviceInfo]\nVendorName=Rotor Works\nProductName=Rotor 12\nVendorNumber=418\n"
                             "[OptionalObjects]\nSupportedObjects=2\n1=0x1800\n2=0x6004\n"
                             "[1800]\nParameterName=TPDO 1\nObjectType=9\nSubNumber=1\n"
                             "[1800sub1]\nParameterName=Identifier\nDataType=7\nAccessType=rw\n"
                             "DefaultValue=0x180 + $NODEID\n"
                             "[6004]\nParameterName=Position\nDataType=7\nAccessType=ro\nPDOMapping=1\n"
                             "LowLimit=010\nHighLimit=0xFFFFFFFF\n";

TEST_F(CliDeviceFile, IsReadForPrograms)
{
    const QJsonObject json = check(QStringLiteral("rotor.EDS"), rotorFile, QStringLiteral("--json")).json();
    EXPECT_EQ(json[u"exit"], 0);
    EXPECT_EQ(json[u"vendorNumber"], 418);
    ASSERT_EQ(json[u"objects"].toArray().size(), 2);
    EXPECT_EQ(json[u"objects"][0].toObject(),
              (QJsonObject{{QStringLiteral("index"), QStringLiteral("1800")},
                           {QStringLiteral("sub"), 1},
                           {QStringLiteral("name"), QStringLiteral("Identifier")},
                           {QStringLiteral("type"), QStringLiteral("u32")},
                           {QStringLiteral("access"), QStringLiteral("rw")},
                           {QStringLiteral("default"), QStringLiteral("$NODEID+384")},
                           {QStringLiteral("minimum"), QJsonValue()},
                           {QStringLiteral("maximum"), QJsonValue()},
                           {QStringLiteral("mapped"), false},
                           {QStringLiteral("value"), QJsonValue()}}));
    EXPECT_EQ(json[u"objects"][1][u"index"], QStringLiteral("6004"));
    EXPECT_EQ(json[u"objects"][1][u"minimum"], 10);
    EXPECT_EQ(json[u"objects"][1][u"maximum"], 4'294'967'295.0);
    EXPECT_EQ(json[u"objects"][1][u"mapped"], true);
    EXPECT_EQ(json[u"commissioning"].toObject(),
              (QJsonObject{{QStringLiteral("node"), QJsonValue()}, {QStringLiteral("rate"), QJsonValue()}}));
    ASSERT_EQ(json[u"notes"].toArray().size(), 1);
    EXPECT_EQ(json[u"notes"][0][u"line"], 23);
    EXPECT_EQ(json[u"notes"][0][u"key"], QStringLiteral("LowLimit"));
    EXPECT_EQ(json[u"notes"][0][u"reason"],
              QStringLiteral("The leading zero does not mean octal: read as 10."));
}

TEST_F(CliDeviceFile, IsReadForPeople)
{
    const CliRun run = check(QStringLiteral("rotor.dcf"),
                             rotorFile + "ParameterValue=77\n[DeviceComissioning]\nNodeID=9\nBaudrate=50\n");
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("rotor.dcf is read: Rotor Works Rotor 12, objects: 2\n"
                                   "Node: 9, Rate: 50000 Bd\n"));
    EXPECT_THAT(run.out,
                testing::ContainsRegex("\n1800:1 +Identifier +u32 +rw +\\$NODEID\\+384 +- +- +no +-\n"));
    EXPECT_THAT(run.out, testing::ContainsRegex("\n6004:0 +Position +u32 +ro +- +10 +4294967295 +yes +77\n"));
    EXPECT_THAT(run.err, HasSubstr("Line 23: LowLimit: The leading zero does not mean octal: read as 10."));
}

TEST_F(CliDeviceFile, ANodeOrRateThatIsNoneIsRefusedAndTheRestIsTold)
{
    const QByteArray bytes = rotorFile + "[DeviceComissioning]\nNodeID=9\nBaudrate=16960\n";
    const CliRun run = check(QStringLiteral("rotor.dcf"), bytes, QStringLiteral("--json"));
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(errorKey(run), "deviceFileBroken");
    EXPECT_THAT(run.err, HasSubstr("rotor.dcf, line 27, Baudrate: \"16960\" is no rate of CANopen in kBd"));
    EXPECT_EQ(run.json()[u"line"], 27);
    EXPECT_EQ(run.json()[u"faultKey"], QStringLiteral("Baudrate"));
    EXPECT_EQ(run.json()[u"objects"].toArray().size(), 2);
    EXPECT_EQ(run.json()[u"commissioning"][u"node"], 9);
    EXPECT_TRUE(run.json()[u"commissioning"][u"rate"].isNull());
}

TEST_F(CliDeviceFile, WithoutAnObjectIsRefused)
{
    const CliRun run =
        check(QStringLiteral("rotor.eds"), "[FileInfo]\nFileName=rotor.eds\n", QStringLiteral("--json"));
    EXPECT_EQ(run.exit, 2);
    EXPECT_THAT(run.err, HasSubstr("There is no object in this file: it is no EDS and no DCF."));
    EXPECT_TRUE(run.json()[u"line"].isNull());
    EXPECT_EQ(runLine(QStringLiteral("devices --check %1/none.eds").arg(m_folder.path())).exit, 2);
    EXPECT_EQ(check(QStringLiteral("rotor.json"), rotorFile).exit, 2) << "only by its name";
}

TEST_F(CliDeviceFile, NumbersThatJsonCannotHaveAreTexts)
{
    const QJsonObject json = check(QStringLiteral("wide.eds"),
                                   "[2000]\nDataType=0x1B\nDefaultValue=0xFFFFFFFFFFFFFFFF\n"
                                   "[2001]\nDataType=8\nDefaultValue=0.5\n[2002]\nDefaultValue=a\n",
                                   QStringLiteral("--json"))
                                 .json();
    EXPECT_EQ(json[u"objects"][0][u"default"], QStringLiteral("18446744073709551615"));
    EXPECT_EQ(json[u"objects"][1][u"default"], 0.5);
    EXPECT_EQ(json[u"objects"][2][u"default"], QStringLiteral("a"));
    EXPECT_TRUE(json[u"objects"][2][u"type"].isNull());
    EXPECT_TRUE(json[u"objects"][2][u"access"].isNull());
}

} // namespace
} // namespace codewheel
