// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that work on encoders of any kind, on a CAN bus.
#include "tests/cli/kinds/canopen/shared_can_bus.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(CliCanEncoder, IsReadAsWhatItsDeviceTypeSays)
{
    SharedCanBus bus;
    const QJsonObject json = bus.runLine(QStringLiteral("read can:7 serial-number --trace --json")).json();
    EXPECT_EQ(json[u"device"], QStringLiteral("canopen-406-linear"));
    EXPECT_EQ(json[u"values"][0][u"value"], 1'245'192);
    ASSERT_EQ(json[u"trace"].toArray().size(), 2);
    EXPECT_EQ(json[u"trace"][0][u"data"], QStringLiteral("4018100400000000"));
    EXPECT_EQ(json[u"trace"][0][u"direction"], QStringLiteral("sent"));
    const CliRun run = bus.runLine(QStringLiteral("read can:6 steps --trace"));
    EXPECT_THAT(run.out, HasSubstr("Node 6: read 6001h:0"));
    EXPECT_THAT(run.out, HasSubstr("steps  = 8192\n"));
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("read can:6 --device kuebler-esc-rs485 --json"))),
              "deviceOfOtherBus");
}

TEST(CliCanEncoder, IsWrittenStoredAndCounted)
{
    SharedCanBus bus;
    EXPECT_EQ(bus.runLine(QStringLiteral("write can:6 steps=4096")).exit, 2);
    EXPECT_EQ(bus.eepromWritesOf6(), 0U);
    const CliRun run = bus.runLine(QStringLiteral("write can:6 steps=4096 --yes"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("written, and read back"));
    EXPECT_THAT(run.out, HasSubstr("EEPROM writes:   1"));
    EXPECT_EQ(bus.eepromWritesOf6(), 1U);
}

TEST(CliCanEncoder, IsSetToAPosition)
{
    SharedCanBus bus;
    const QJsonObject json = bus.runLine(QStringLiteral("preset can:6 1000 --json")).json();
    EXPECT_EQ(json[u"exit"], 0);
    EXPECT_NEAR(json[u"positionAfter"].toInt(), 1'000, 100); // it turns
}

TEST(CliCanEncoder, IsReset)
{
    SharedCanBus bus;
    EXPECT_EQ(bus.runLine(QStringLiteral("od can:6 write 6001=4096 --yes")).exit, 0);
    const CliRun run = bus.runLine(QStringLiteral("reset can:6 --yes"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("will be reset to factory settings.\n"));
    EXPECT_THAT(run.out, HasSubstr("= 8192\n"));
    EXPECT_THAT(run.out, Not(HasSubstr("0E000000")));
}

TEST(CliCanEncoder, ThatRunsIsStoppedOnlyIfThatWasAgreedTo)
{
    SharedCanBus bus;
    EXPECT_EQ(bus.runLine(QStringLiteral("nmt start can:6 --yes")).exit, 0);
    const CliRun refused = bus.runLine(QStringLiteral("reset can:6 --yes --json"));
    EXPECT_EQ(refused.exit, 1);
    EXPECT_EQ(errorKey(refused), "nodeWouldStop");
    EXPECT_THAT(refused.err, HasSubstr("may-stop=yes"));
    EXPECT_EQ(bus.runLine(QStringLiteral("reset can:6 --yes --link canopen:training,may-stop=yes")).exit, 0);
}

// Node 5 has no heartbeat.
TEST(CliCanEncoder, ThatMayRunIsStoppedOnlyIfThatWasAgreedTo)
{
    SharedCanBus bus;
    const CliRun refused = bus.runLine(QStringLiteral("reset can:5 --yes --json"));
    EXPECT_EQ(refused.exit, 1);
    EXPECT_EQ(errorKey(refused), "nodeMayRun");
    EXPECT_THAT(refused.err, HasSubstr("may-stop=yes"));
    EXPECT_EQ(bus.runLine(QStringLiteral("reset can:5 --yes --link canopen:training,may-stop=yes")).exit, 0);
}

TEST(CliCanEncoder, IsWatchedWithoutSending)
{
    SharedCanBus bus;
    const QJsonObject json = bus.runLine(QStringLiteral("monitor can:6 --for 2 --json")).json();
    EXPECT_EQ(json[u"figures"][u"sent"], 0);
    EXPECT_EQ(json[u"samples"].toArray().last()[u"nmt"], QStringLiteral("preOperational"));
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("monitor can:50 --json"))), "nodeSilent");
}

TEST(CliCanEncoder, ItsCamsAreRead)
{
    SharedCanBus bus;
    const CliRun run = bus.runLine(QStringLiteral("cams can:6 read"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("Cam program 1"));
    EXPECT_THAT(run.out, Not(HasSubstr("In which mode")));
}

TEST(CliCanEncoder, WhatItDoesNotHaveIsSaidSo)
{
    for (const char *line : {"words can:6 0", "velocity can:6 on", "master --link canopen:training"}) {
        const QString call = QString::fromLatin1(line);
        const CliRun run = runLine(call.contains(QStringLiteral("--link"))
                                       ? call
                                       : call + QStringLiteral(" --link canopen:training"));
        EXPECT_EQ(run.exit, 2) << line;
    }
}

TEST(CliCanEncoder, OfAProjectIsStoredComparedAndTransferred)
{
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("p.codewheel"));
    EXPECT_EQ(runLine(QStringLiteral("scan --ask --link canopen:training --save ") + file).exit, 0);
    EXPECT_EQ(runLine(QStringLiteral("store %1 --link canopen:project").arg(file)).exit, 0);
    const CliRun same = runLine(QStringLiteral("compare %1 --link canopen:project").arg(file));
    EXPECT_EQ(same.exit, 0);
    EXPECT_THAT(same.out, HasSubstr("same  can:6"));
    const CliRun stored =
        runLine(QStringLiteral("transfer %1 can:6 --stored --yes --link canopen:project").arg(file));
    EXPECT_EQ(stored.exit, 0) << stored.err;
    EXPECT_EQ(runLine(QStringLiteral("read can:6 steps --project %1 --link project").arg(file)).exit, 0);
}

TEST(CliCanEncoder, IsRecordedBeforeItWasStarted)
{
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("r.cwrec"));
    const CliRun run = runLine(QStringLiteral("record can:6 --for 1 --link canopen:training -o ") + file);
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_TRUE(QFile::exists(file));
    EXPECT_THAT(run.out, HasSubstr("can:6  position"));
}

TEST(CliCanEncoder, ATransferBeforeItWasStartedIsDone)
{
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("p.codewheel"));
    SharedCanBus bus;
    EXPECT_EQ(bus.runLine(QStringLiteral("scan --ask --save ") + file).exit, 0);
    EXPECT_EQ(bus.runLine(QStringLiteral("write can:6 steps=4096 --yes")).exit, 0);
    EXPECT_EQ(bus.runLine(QStringLiteral("store %1 can:6").arg(file)).exit, 0);
    EXPECT_EQ(bus.runLine(QStringLiteral("write can:6 steps=8192 --yes")).exit, 0);
    const CliRun run = bus.runLine(QStringLiteral("transfer %1 can:6 --stored --yes").arg(file));
    EXPECT_EQ(run.exit, 0) << run.out << run.err;
    EXPECT_THAT(bus.runLine(QStringLiteral("od can:6 read 6001")).out, HasSubstr("4096"));
}

TEST(CliCanEncoder, AnotherSerialNumberThanOnItsLabelIsToldToPrograms)
{
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("p.codewheel"));
    SharedCanBus bus;
    EXPECT_EQ(bus.runLine(QStringLiteral("scan --ask --save ") + file).exit, 0);
    auto others = canopen::trainingEncoders();
    others[1].identity[3] = 4711;
    SharedCanBus other(others);
    const QJsonObject json = other.runLine(QStringLiteral("compare %1 --json").arg(file)).json();
    EXPECT_EQ(json[u"lines"][1][u"why"][u"key"], QStringLiteral("serialDiffers"));
    EXPECT_TRUE(json[u"lines"][0][u"why"].isUndefined());
}

TEST(CliCanEncoder, WhoGoesByAnotherProfileIsNotWrittenAsAnEncoder)
{
    auto encoders = canopen::trainingEncoders();
    encoders[1].profile = 417;
    SharedCanBus bus(encoders);
    for (const char *line : {"preset can:6 1000 --yes --json", "write can:6 steps=4096 --yes --json",
                             "write can:6 steps=4096 --device canopen-406-multi-turn --yes --json",
                             "reset can:6 --yes --json"}) {
        const CliRun run = bus.runLine(QString::fromLatin1(line));
        EXPECT_EQ(run.exit, 1) << line;
        EXPECT_EQ(errorKey(run), "canopenOtherProfile") << line << run.out << run.err;
        EXPECT_THAT(run.err, HasSubstr("417 (lifts)")) << line;
    }
    EXPECT_EQ(bus.eepromWritesOf6(), 0U);
    EXPECT_THAT(bus.runLine(QStringLiteral("od can:6 read 6001")).out, HasSubstr("8192"));
    EXPECT_EQ(bus.runLine(QStringLiteral("od can:6 write 6001=4096 --yes")).exit, 0);
}

} // namespace
} // namespace codewheel
