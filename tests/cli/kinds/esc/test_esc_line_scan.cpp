// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_line_address.h"
#include "project/project_file.h"
#include "tests/cli/kinds/esc/shared_line.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> addressesIn(const CliRun &run)
{
    std::vector<std::string> addresses;
    for (const QJsonValue encoder : run.json()[u"encoders"].toArray())
        addresses.push_back(encoder[u"address"].toString().toStdString());
    return addresses;
}

TEST(CliLineScan, FindsTheEncodersOfTheTrainingLine)
{
    SharedLine line;
    const CliRun run = line.runLine(QStringLiteral("scan"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.out, "place  address     Bd  serial number      device code  version\n"
                       "03           3  19200  1234321 (12D591h)  8000h        5882 RS485 V1.2 SIMULATED\n"
                       "05           5  19200  1234340 (12D5A4h)  8000h        5882 RS485 V1.2 SIMULATED\n"
                       "12          18  19200  1245192 (130008h)  8000h        5882 RS485 V1.2 SIMULATED\n");
}

TEST(CliLineScan, TellsProgramsTheSame)
{
    SharedLine line;
    const QJsonObject json = line.runLine(QStringLiteral("scan --json")).json();
    ASSERT_EQ(json[u"encoders"].toArray().size(), 3);
    EXPECT_EQ(json[u"encoders"][1].toObject(),
              (QJsonObject{{QStringLiteral("address"), QStringLiteral("05")},
                           {QStringLiteral("baudRate"), 19'200},
                           {QStringLiteral("serialNumber"), QStringLiteral("0012D5A4")},
                           {QStringLiteral("deviceCode"), 0x8000},
                           {QStringLiteral("version"), QStringLiteral("5882 RS485 V1.2 SIMULATED")}}));
}

TEST(CliLineScan, OfTheTrainingBusStandsBehindTheRing)
{
    const CliRun run = runLine(QStringLiteral("scan --json"));
    EXPECT_EQ(run.json()[u"participants"].toArray().size(), 7);
    EXPECT_THAT(addressesIn(run), ElementsAre("03", "05", "12"));
}

TEST(CliLineScan, AsksFromTheFirstToTheLastAddress)
{
    SharedLine line;
    EXPECT_THAT(addressesIn(line.runLine(QStringLiteral("scan --first 04 --last 12 --json"))),
                ElementsAre("05", "12"));
    EXPECT_EQ(errorKey(line.runLine(QStringLiteral("scan --first 00 --json"))), "lineAddressWrong");
    EXPECT_EQ(errorKey(line.runLine(QStringLiteral("scan --last 20 --json"))), "lineAddressWrong");
    EXPECT_EQ(errorKey(line.runLine(QStringLiteral("scan --first 12 --last 05 --json"))),
              "addressesReversed");
}

TEST(CliLineScan, AtAllRatesFindsAnEncoderThatHasAnother)
{
    SharedLine line;
    EXPECT_EQ(line.runLine(QStringLiteral("write 05 baud-rate=9600 --yes")).exit, 0);
    EXPECT_THAT(addressesIn(line.runLine(QStringLiteral("scan --json"))), ElementsAre("03", "12"));
    const QJsonArray found =
        line.runLine(QStringLiteral("scan --all-rates --json")).json()[u"encoders"].toArray();
    ASSERT_EQ(found.size(), 3);
    EXPECT_EQ(found[2][u"address"], QStringLiteral("05"));
    EXPECT_EQ(found[2][u"baudRate"], 9'600);
    EXPECT_EQ(line.runLine(QStringLiteral("read 05 steps --link esc:training,baud=9600")).exit, 0);
}

TEST(CliLineScan, TheMasterAddressFindsTheOneThatIsAlone)
{
    SharedLine line;
    line.mute(0x03);
    line.mute(0x12);
    const CliRun run = line.runLine(QStringLiteral("scan --master --first 10 --last 11"));
    EXPECT_THAT(run.out, HasSubstr("00      master  19200  1234340 (12D5A4h)"));
}

TEST(CliLineScan, NobodyThereIsSaid)
{
    SharedLine line;
    const CliRun run = line.runLine(QStringLiteral("scan --first 06 --last 07"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("No encoder answers. Check baud rate (--all-rates)"));
    EXPECT_EQ(run.err, "");
}

TEST(CliLineScan, WhoSitsThereSeesItGoOn)
{
    SharedLine line;
    EXPECT_THAT(line.runLine(QStringLiteral("scan"), {true, {}}).err,
                HasSubstr("Addresses asked: 5 of 31. Encoders found: 2."));
    EXPECT_EQ(line.runLine(QStringLiteral("scan --json"), {true, {}}).err.find("Addresses"),
              std::string::npos);
}

TEST(CliLineScan, CtrlCEndsItWithWhatWasFound)
{
    SharedLine line;
    line.interruptAfter("0AN");
    const CliRun run = line.runLine(QStringLiteral("scan --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "scanCancelled");
    EXPECT_THAT(addressesIn(run), ElementsAre("03", "05"));
}

TEST(CliLineScan, CtrlCBeforeAnybodyAnsweredIsNoSilence)
{
    SharedLine line;
    line.interruptAfter("01N");
    const CliRun run = line.runLine(QStringLiteral("scan"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(run.out.find("No encoder answers"), std::string::npos);
    EXPECT_THAT(run.err, HasSubstr("until then no encoder had answered"));
}

// Encoders no longer asked for would be lost from the project.
TEST(CliLineScan, WhatWasCancelledIsNotSaved)
{
    SharedLine line;
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("line.codewheel"));
    line.interruptAfter("0AN");
    EXPECT_EQ(errorKey(line.runLine(QStringLiteral("scan --json --save ") + file)), "scanCancelled");
    EXPECT_FALSE(QFile::exists(file));
}

TEST(CliLineScan, SavesWhatAnswersAsAProject)
{
    SharedLine line;
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("line.codewheel"));
    ASSERT_EQ(line.runLine(QStringLiteral("scan --last 10 --json --save ") + file).exit, 0);
    const auto project = loadProject(file);
    ASSERT_TRUE(project);
    ASSERT_EQ(project->buses.size(), 1U) << "the link has no ring";
    EXPECT_EQ(project->buses[0].kind, QStringLiteral("esc"));
    ASSERT_EQ(project->devices.size(), 2U);
    EXPECT_EQ(project->devices[0].place(), placeOnLine({3}));
    EXPECT_EQ(project->devices[1].place(), placeOnLine({5}));
    EXPECT_EQ(project->devices[1].participant.deviceKey, QStringLiteral("kuebler-esc-rs485"));
    EXPECT_EQ(project->devices[1].label.serialNumber, QStringLiteral("0012D5A4"));
}

// Wanted values and names stay with an encoder that answers again.
TEST(CliLineScan, WhatIsPlannedStaysWithTheEncoder)
{
    SharedLine line;
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("line.codewheel"));
    ASSERT_EQ(line.runLine(QStringLiteral("scan --last 10 --save ") + file).exit, 0);
    Project project = *loadProject(file);
    project.devices[1].station = QStringLiteral("Hoist");
    project.devices[1].wanted = {{Parameter::steps, 864}};
    ASSERT_TRUE(saveProject(project, file));
    ASSERT_EQ(line.runLine(QStringLiteral("scan --yes --project %1 --save %1").arg(file)).exit, 0);
    const Project after = *loadProject(file);
    ASSERT_EQ(after.devices.size(), 3U);
    EXPECT_EQ(after.devices[1], project.devices[1]);
    EXPECT_EQ(after.devices[2].place(), placeOnLine({0x12}));
}

} // namespace
} // namespace codewheel
