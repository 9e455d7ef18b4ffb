// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/kinds/canopen/shared_can_bus.h"

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

} // namespace
} // namespace codewheel
