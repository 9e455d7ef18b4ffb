// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/kinds/esc/shared_line.h"

#include <QJsonArray>

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(CliLineRead, ReadsAllAndTellsHexadecimalWhatIsNoNumber)
{
    const CliRun run = runLine(QStringLiteral("read 05"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(run.out, HasSubstr("steps                 = 8192\n"));
    EXPECT_THAT(run.out, HasSubstr("scaling-factor        = 20000000h (1)\n"));
    EXPECT_THAT(run.out, HasSubstr("serial-number         = 1234340 (12D5A4h)\n"));
    EXPECT_THAT(run.out, HasSubstr("operating-time        = 1287.6 h\n"));
    EXPECT_THAT(run.out, HasSubstr("warnings              = 8000h (standstill)\n"));
    EXPECT_THAT(run.out, HasSubstr("version               = 5882 RS485 V1.2 SIMULATED\n"));
}

// Manual, read command V: a text among numbers.
TEST(CliLineRead, TheVersionIsAValueToo)
{
    const CliRun alone = runLine(QStringLiteral("read 05 version"));
    EXPECT_EQ(alone.exit, 0);
    EXPECT_EQ(alone.out, "version  = 5882 RS485 V1.2 SIMULATED\n");
    const QJsonArray values =
        runLine(QStringLiteral("read 05 steps version alarms --json")).json()[u"values"].toArray();
    ASSERT_EQ(values.size(), 3);
    EXPECT_EQ(values[2][u"parameter"], QStringLiteral("version"));
    EXPECT_EQ(values[2][u"value"], QStringLiteral("5882 RS485 V1.2 SIMULATED"));
    EXPECT_EQ(errorKey(runLine(QStringLiteral("read 05 version version --json"))), "parameterGivenTwice");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("read 1.0 version --json"))), "unknownParameter");
}

// Manual, "Masteraddress: 00".
TEST(CliLineRead, TheMasterAddressReachesTheOneThatIsAlone)
{
    SharedLine line;
    const CliRun several = line.runLine(QStringLiteral("read 00 serial-number --json"));
    EXPECT_EQ(several.exit, 1);
    EXPECT_EQ(errorKey(several), "encoderNotAlone");
    EXPECT_THAT(several.err, HasSubstr("several may answer at once"));

    SharedLine other;
    other.mute(0x03);
    other.mute(0x12);
    const QJsonObject json = other.runLine(QStringLiteral("read 00 serial-number --json")).json();
    EXPECT_EQ(json[u"place"], QStringLiteral("esc:00"));
    EXPECT_EQ(json[u"values"][0][u"value"], 0x12D5A4);
    EXPECT_EQ(other.runLine(QStringLiteral("write 00 direction=ccw --yes")).exit, 0);
    EXPECT_TRUE(other.registers(0x05).countsCcw);
}

TEST(CliLineRead, AddressesAreHexadecimalWithAndWithoutPrefix)
{
    for (const char *place : {"12", "esc:12"}) {
        const QJsonObject json =
            runLine(QStringLiteral("read %1 serial-number --json").arg(QString::fromLatin1(place))).json();
        EXPECT_EQ(json[u"place"], QStringLiteral("esc:12"));
        EXPECT_EQ(json[u"values"][0][u"value"], 0x130008);
    }
}

TEST(CliLineRead, TheTraceHasWhatPassedWithoutThePolling)
{
    SharedLine line;
    const QJsonArray trace =
        line.runLine(QStringLiteral("read 05 alarms --trace --json")).json()[u"trace"].toArray();
    std::vector<std::string> texts;
    for (const QJsonValue row : trace)
        if (row[u"letters"] == QStringLiteral("A"))
            texts.push_back((row[u"direction"].toString() + u' ' + row[u"text"].toString()).toStdString());
    EXPECT_THAT(texts, ElementsAre("sent <1B>05A<0D><0A>", "answer <0D><0A>0000<0D><0A>",
                                   "sent <1B>05A<0D><0A>", "answer <0D><0A>0000<0D><0A>"));
    for (const QJsonValue row : trace)
        EXPECT_NE(row[u"letters"], QStringLiteral("P"));
}

TEST(CliLineRead, BothMakesCanBeNamed)
{
    EXPECT_EQ(runLine(QStringLiteral("read 05 steps --device kuebler-esc-rs422 --json")).json()[u"device"],
              QStringLiteral("kuebler-esc-rs422"));
    EXPECT_EQ(runLine(QStringLiteral("read 05 steps --device 8.5882.xx1x.1001 --json")).json()[u"device"],
              QStringLiteral("kuebler-esc-rs422"));
    EXPECT_EQ(errorKey(runLine(QStringLiteral("read 05 --device fraba-ocd-ib --json"))), "deviceOfOtherBus");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("read 05 --device nonsense --json"))), "unknownDeviceName");
}

TEST(CliLineMonitor, PrintsWhatChangesAndHowTheLineHasDone)
{
    SharedLine line;
    const CliRun run = line.runLine(QStringLiteral("monitor 05 --for 2"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("00001235      4661  standstill\n"));
    EXPECT_THAT(run.out, HasSubstr("Time-outs: 0. Retries: 0. Not answered: 0."));

    const QJsonObject json = line.runLine(QStringLiteral("monitor 03 --for 1 --every 250 --json")).json();
    ASSERT_EQ(json[u"samples"].toArray().size(), 5);
    EXPECT_LT(json[u"samples"][0][u"position"].toInt(), json[u"samples"][4][u"position"].toInt());
    EXPECT_GT(json[u"figures"][u"answers"].toInt(), 50);
    EXPECT_EQ(json[u"place"], QStringLiteral("esc:03"));
}

// A row for each visible difference, and for nothing else.
TEST(CliLineMonitor, WhatSaysTheSameIsNoSecondRow)
{
    SharedLine line;
    const CliRun run = line.runLine(QStringLiteral("monitor 05 --for 3"));
    std::vector<std::string> said;
    for (const QString &row : QString::fromStdString(run.out).split(u'\n')) {
        if (row.isEmpty())
            break;
        said.push_back(row.mid(9).toStdString()); // after the time
    }
    ASSERT_GT(said.size(), 1U);
    EXPECT_EQ(std::ranges::adjacent_find(said), said.end()) << run.out;

    const QJsonArray samples =
        line.runLine(QStringLiteral("monitor 05 --for 3 --json")).json()[u"samples"].toArray();
    for (qsizetype i = 1; i < samples.size(); ++i) {
        QJsonObject before = samples[i - 1].toObject();
        QJsonObject now = samples[i].toObject();
        before.remove(QStringLiteral("microseconds"));
        now.remove(QStringLiteral("microseconds"));
        EXPECT_NE(before, now);
    }
}

TEST(CliLineMonitor, CtrlCEndsItEarly)
{
    SharedLine line;
    line.interruptAfter("03E"); // the warnings, once a second
    const CliRun run = line.runLine(QStringLiteral("monitor 03 --for 60 --json"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_LT(run.json()[u"samples"].toArray().size(), 30);
}

TEST(CliLineMonitor, SaysWhenTheAdapterIsUnplugged)
{
    SharedLine line;
    line.unplugAfter("05E"); // the warnings, once a second
    const CliRun run = line.runLine(QStringLiteral("monitor 05 --for 60 --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "portLost");
}

} // namespace
} // namespace codewheel
