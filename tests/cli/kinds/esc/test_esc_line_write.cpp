// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/kinds/esc/shared_line.h"

#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string fateOf(const QJsonObject &json, const char *parameter)
{
    for (const QJsonValue value : json[u"values"].toArray())
        if (value[u"parameter"] == QString::fromLatin1(parameter))
            return value[u"fate"].toString().toStdString();
    return {};
}

TEST(CliLineWrite, ShowsTheCommandsAndWritesThem)
{
    SharedLine line;
    const CliRun run = line.runLine(QStringLiteral("write 05 direction=ccw steps=864 --yes"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(run.out, StartsWith("To be written to esc:05, Kübler 5882 / 5862 / 9081 RS-485:\n"
                                    "  parameter       known    wanted     command\n"
                                    "  direction       cw (0)   ccw (1)    05GD1\n"
                                    "  steps           8192     864        05GR00000360\n"
                                    "  scaling-factor  unknown  03600000h  05GF03600000\n"));
    EXPECT_THAT(run.out, HasSubstr("direction  = ccw (1)  written, and read back\n"
                                   "steps      = 864      written, and read back\n"
                                   "EEPROM writes:   3\n"));
    EXPECT_EQ(line.registers(0x05).stepsPerTurn, 864U);
    EXPECT_EQ(line.registers(0x05).factor, 0x03600000U);
    EXPECT_TRUE(line.registers(0x05).countsCcw);
}

// Manual, GR: "Number of revolutions is 4096".
TEST(CliLineWrite, StepsSetTheRevolutionsAndPlanAndAccountSaySo)
{
    SharedLine line;
    ASSERT_EQ(line.runLine(QStringLiteral("write 05 revolutions=16 --yes")).exit, 0);
    const QString warned = QStringLiteral("With the steps, the encoder sets its revolutions to 4096: now "
                                          "they are 16.");
    EXPECT_THAT(line.runLine(QStringLiteral("write 05 steps=864 --dry-run")).out,
                HasSubstr(warned.toStdString()));
    const CliRun both = line.runLine(QStringLiteral("write 05 steps=864 revolutions=16 --yes"));
    EXPECT_EQ(both.exit, 0) << both.err;
    EXPECT_THAT(both.out, Not(HasSubstr("sets its revolutions")));
    EXPECT_EQ(line.registers(0x05).revolutions, 16U) << "it had them, and has them again";

    const QJsonObject json = line.runLine(QStringLiteral("write 05 steps=500 --yes --json")).json();
    EXPECT_EQ(json[u"notes"].toArray()[1][u"key"], QStringLiteral("revolutionsSetAlong"));
    EXPECT_EQ(fateOf(json, "revolutions"), "setAlong");
    ASSERT_EQ(line.runLine(QStringLiteral("write 05 revolutions=16 --yes")).exit, 0);
    EXPECT_THAT(line.runLine(QStringLiteral("write 05 steps=600 --yes")).out,
                HasSubstr("revolutions  = 4096  set by the encoder itself, with the steps\n"));
}

// Manual, GS. It is read, though nobody wants to write it.
TEST(CliLineWrite, StepsThatDoNotActAreSaidNotTo)
{
    SharedLine line;
    const QString off =
        QStringLiteral("Scaling is off: the encoder keeps the values that scale its position");
    EXPECT_THAT(line.runLine(QStringLiteral("write 05 steps=864 --dry-run")).out,
                HasSubstr(off.toStdString()));
    const QJsonObject json = line.runLine(QStringLiteral("write 05 steps=864 --yes --json")).json();
    EXPECT_EQ(json[u"notes"].toArray()[0][u"key"], QStringLiteral("scalingOff"));
    EXPECT_FALSE(line.registers(0x05).isScaled) << "nobody asked for it";
    const CliRun off500 = line.runLine(QStringLiteral("write 05 steps=500 --yes"));
    EXPECT_EQ(QString::fromStdString(off500.out).count(off), 2) << "before and afterwards";
    const CliRun on = line.runLine(QStringLiteral("write 05 steps=600 scaling=on --yes"));
    EXPECT_THAT(on.out, Not(HasSubstr(off.toStdString())));
}

TEST(CliLineWrite, AnotherDirectionShiftsThePositionAndIsToldBefore)
{
    SharedLine line;
    const std::string shift = "This shifts the position, by how much is not known.\n";
    EXPECT_THAT(line.runLine(QStringLiteral("write 05 direction=ccw --dry-run")).out, HasSubstr(shift));
    EXPECT_THAT(line.runLine(QStringLiteral("write 05 steps=864 --dry-run")).out, Not(HasSubstr(shift)));
}

// 30 fraction bits: 864 / 8192 is 06C00000h.
TEST(CliLineWrite, TheFactorHasTheFormatOfTheLinkOrOfTheDevice)
{
    SharedLine line;
    const QString write = QStringLiteral("write 05 steps=864 --dry-run --link esc:training,fraction-bits=");
    EXPECT_THAT(line.runLine(write + QStringLiteral("30")).out, HasSubstr("05GF06C00000"));
    EXPECT_THAT(line.runLine(write + QStringLiteral("device")).out, HasSubstr("05GF03600000"));
}

QStringList plannedCommands(const QJsonObject &json)
{
    QStringList commands;
    for (const QJsonValue row : json[u"plan"].toArray())
        if (!row[u"leftOut"].toBool())
            commands << row[u"command"].toString();
    return commands;
}

QStringList sentWrites(const QJsonObject &json)
{
    QStringList sent;
    for (const QJsonValue row : json[u"trace"].toArray())
        if (row[u"direction"].toString() == QStringLiteral("sent") && !row[u"data"].isNull())
            sent << row[u"text"].toString().remove(QStringLiteral("<1B>")).section(u'<', 0, 0);
    return sent;
}

TEST(CliLineWrite, WhatIsPlannedIsSentInWhateverOrderItIsTyped)
{
    for (const char *typed : {"measuring-range=4096000 steps=1000", "steps=1000 measuring-range=4096000",
                              "measuring-range=16000 revolutions=16 steps=1000",
                              "steps=1000 scaling-factor=20000000h", "scaling-factor=10000000h steps=1000"}) {
        SharedLine line;
        const CliRun run =
            line.runLine(QStringLiteral("write 05 %1 --yes --json --trace").arg(QString::fromLatin1(typed)));
        EXPECT_EQ(run.exit, 0) << typed << run.err;
        EXPECT_FALSE(sentWrites(run.json()).isEmpty());
        EXPECT_EQ(sentWrites(run.json()), plannedCommands(run.json())) << typed;
    }
}

TEST(CliLineWrite, WhatContradictsIsRefusedBeforeAnythingIsSent)
{
    SharedLine line;
    const CliRun run = line.runLine(QStringLiteral("write 05 measuring-range=131072 steps=1000 --yes"));
    EXPECT_EQ(run.exit, 2);
    EXPECT_THAT(run.err, HasSubstr("\"1000\". Allowed are: 32, which goes with a measuring range of 131072"));
    EXPECT_EQ(line.registers(0x05).stepsPerTurn, 8'192U);
}

TEST(CliLineWrite, TheRangeOfTheFactorIsToldAsItIsTyped)
{
    SharedLine line;
    EXPECT_THAT(line.runLine(QStringLiteral("write 05 scaling-factor=20000001h --yes")).err,
                HasSubstr("= 20000001h is out of range. Give a value from 000014F9h to 20000000h."));
}

TEST(CliLineWrite, WithoutConsentNothingIsWritten)
{
    SharedLine line;
    const CliRun nobody = line.runLine(QStringLiteral("write 05 steps=864 --json"));
    EXPECT_EQ(nobody.exit, 2);
    EXPECT_EQ(errorKey(nobody), "noConsent");
    const CliRun no = line.runLine(QStringLiteral("write 05 steps=864"), {true, "n\n"});
    EXPECT_EQ(no.exit, 2);
    EXPECT_THAT(no.err, HasSubstr("Nothing was sent."));
    EXPECT_EQ(line.runLine(QStringLiteral("write 05 steps=864 --dry-run")).exit, 0);
    EXPECT_EQ(line.registers(0x05).stepsPerTurn, 8'192U);

    EXPECT_EQ(line.runLine(QStringLiteral("write 05 steps=864"), {true, "y\n"}).exit, 0);
    EXPECT_EQ(line.registers(0x05).stepsPerTurn, 864U);
}

TEST(CliLineWrite, WhatIsThereIsLeftOut)
{
    SharedLine line;
    const CliRun run = line.runLine(QStringLiteral("write 05 steps=8192 address=5 --yes"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("The encoder has all of it: there is nothing to write."));
    const QJsonObject all = line.runLine(QStringLiteral("write 05 direction=cw --all --yes --json")).json();
    EXPECT_EQ(all[u"eepromWrites"], 1);
    EXPECT_EQ(fateOf(all, "direction"), "readBack");
}

TEST(CliLineWrite, ValuesOutOfRangeAreRefusedBeforeAnythingIsSent)
{
    SharedLine line;
    for (const char *values : {"steps=0", "steps=8193", "address=0", "address=32", "lower-limit=0",
                               "upper-limit=33554432", "measuring-range=0"}) {
        const CliRun run =
            line.runLine(QStringLiteral("write 05 %1 --yes --json").arg(QString::fromLatin1(values)));
        EXPECT_EQ(run.exit, 2) << values;
        EXPECT_EQ(errorKey(run), "valueOutOfRange") << values;
    }
    EXPECT_EQ(errorKey(line.runLine(QStringLiteral("write 05 baud-rate=300 --yes --json"))),
              "valueNotAllowed");
    EXPECT_EQ(errorKey(line.runLine(QStringLiteral("write 05 preset=5 --yes --json"))), "parameterReadOnly");
}

TEST(CliLineWrite, AnotherAddressIsToldWithThePlace)
{
    SharedLine line;
    const CliRun run = line.runLine(QStringLiteral("write 05 address=15h --yes"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("  address    05h (5)  15h (21)  05X15\n"));
    EXPECT_THAT(run.out, HasSubstr("The encoder is at 15h (21) now: PLACE 15.\n"));
    EXPECT_EQ(line.runLine(QStringLiteral("read 15 serial-number")).out,
              "serial-number  = 1234340 (12D5A4h)\n");
}

// 12h = 18 is there; so is 03, which is what the digits "03" stand for.
TEST(CliLineWrite, AnAddressThatIsTakenIsRefused)
{
    SharedLine line;
    const CliRun run = line.runLine(QStringLiteral("write 05 address=18 --yes"));
    EXPECT_EQ(run.exit, 2);
    EXPECT_THAT(run.err,
                HasSubstr("Address 12h (18) is taken: an encoder with the serial number 1245192 (130008h)"));
    EXPECT_EQ(errorKey(line.runLine(QStringLiteral("write 05 address=3 --yes --json"))), "lineAddressTaken");
    EXPECT_EQ(line.runLine(QStringLiteral("read 05 steps")).exit, 0);
}

TEST(CliLineWrite, AnotherBaudRateIsToldWithTheLink)
{
    SharedLine line;
    const CliRun run = line.runLine(QStringLiteral("write 05 baud-rate=4800 --yes"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("The encoder has 4800 Bd now: give the link as ...,baud=4800.\n"));
}

TEST(CliLineWrite, UnpluggedInTheMiddleEachValueTellsWhatIsKnownOfIt)
{
    SharedLine line;
    line.unplugAfter("05GD");
    const CliRun run =
        line.runLine(QStringLiteral("write 05 upper-limit=5000 direction=ccw lower-limit=10 --yes --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(fateOf(run.json(), "upper-limit"), "readBack");
    EXPECT_EQ(fateOf(run.json(), "direction"), "unknown");
    EXPECT_EQ(fateOf(run.json(), "lower-limit"), "notSent");
    EXPECT_EQ(run.json()[u"eepromWrites"], 2);
    EXPECT_THAT(run.err, HasSubstr("The serial port training line is gone"));
    EXPECT_THAT(run.err, HasSubstr("05GD1"));
    EXPECT_THAT(run.err, HasSubstr("connect again and read it"));
    EXPECT_THAT(run.err, Not(HasSubstr("The encoder answers at")));
}

TEST(CliLineWrite, AWriteOfASilentEncoderIsNotKnown)
{
    SharedLine line;
    line.muteAfter("05GD");
    const CliRun run = line.runLine(QStringLiteral("write 05 direction=ccw lower-limit=10 --yes --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "escWriteUnknown");
    EXPECT_EQ(fateOf(run.json(), "direction"), "unknown");
    EXPECT_EQ(fateOf(run.json(), "lower-limit"), "notSent");
    EXPECT_EQ(run.json()[u"eepromWrites"], 1);
    EXPECT_THAT(run.err, HasSubstr("The encoder does not answer any more."));
}

TEST(CliLineWrite, AfterCtrlCNothingElseIsWrittenAndWhatWasIsRead)
{
    SharedLine line;
    line.interruptAfter("05GD");
    const CliRun run =
        line.runLine(QStringLiteral("write 05 upper-limit=5000 direction=ccw lower-limit=10 --yes --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "cancelled");
    EXPECT_EQ(fateOf(run.json(), "upper-limit"), "readBack");
    EXPECT_EQ(fateOf(run.json(), "direction"), "readBack");
    EXPECT_EQ(fateOf(run.json(), "lower-limit"), "notSent");
    EXPECT_THAT(run.err, HasSubstr("The encoder answers at 05h (5)."));
    EXPECT_EQ(line.registers(0x05).lowerLimit, 1U);
}

// The terminal is closed, or nobody reads the output any more.
TEST(CliLineWrite, EverySignalThatEndsTheProgramLeavesAnAccount)
{
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
        SharedLine line;
        line.interruptAfter("05GD", signal);
        const CliRun run = line.runLine(QStringLiteral("write 05 direction=ccw lower-limit=10 --yes --json"));
        EXPECT_EQ(run.exit, 1) << signal;
        EXPECT_EQ(errorKey(run), "cancelled") << signal;
        EXPECT_EQ(fateOf(run.json(), "direction"), "readBack") << signal;
        EXPECT_EQ(fateOf(run.json(), "lower-limit"), "notSent") << signal;
    }
}

TEST(CliLineWrite, AHangUpThatIsIgnoredEndsNothing) // nohup
{
    const auto before = std::signal(SIGHUP, SIG_IGN);
    SharedLine line;
    line.interruptAfter("05GD", SIGHUP);
    const CliRun run = line.runLine(QStringLiteral("write 05 direction=ccw lower-limit=10 --yes"));
    std::signal(SIGHUP, before);
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(line.registers(0x05).lowerLimit, 10U);
}

TEST(CliLinePreset, SetsThePositionAtOnce)
{
    SharedLine line;
    const CliRun run = line.runLine(QStringLiteral("preset esc:05 3E8h"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.out, "Position before: 4661\nPosition after:  1000\nEEPROM writes:   1\n");
    EXPECT_EQ(line.registers(0x05).preset, 1'000U);
}

// 7 bytes in 1000 are damaged, and so about 8 answers in 100. The shaft stands still.
TEST(CliLinePreset, NoDamagedDigitGetsIntoTheAccount)
{
    SharedLine line;
    ASSERT_EQ(line.runLine(QStringLiteral("preset 05 5000")).exit, 0);
    line.simulated().setFaults({.corrupted = 7});
    int told = 0;
    for (int i = 0; i < 25; ++i) {
        const auto stoodAt = QJsonValue(static_cast<qint64>(line.registers(0x05).preset));
        const QString call = i % 2 ? QStringLiteral("write 05 lower-limit=%1 --yes --json").arg(10 + i)
                                   : QStringLiteral("preset 05 %1 --json").arg(6000 + 100 * i);
        const QJsonObject account = line.runLine(call).json();
        const auto standsAt = QJsonValue(static_cast<qint64>(line.registers(0x05).preset));
        if (!account[u"positionBefore"].isNull() && !account[u"positionBefore"].isUndefined()) {
            EXPECT_EQ(account[u"positionBefore"], stoodAt) << call.toStdString();
            ++told;
        }
        if (!account[u"positionAfter"].isNull() && !account[u"positionAfter"].isUndefined()) {
            EXPECT_EQ(account[u"positionAfter"], standsAt) << call.toStdString();
            ++told;
        }
    }
    EXPECT_GT(told, 40) << "of 50";
}

TEST(CliLinePreset, NeedsAValueInRange)
{
    SharedLine line;
    EXPECT_EQ(errorKey(line.runLine(QStringLiteral("preset 05 --json"))), "presetNeedsValue");
    EXPECT_EQ(errorKey(line.runLine(QStringLiteral("preset 05 0 --json"))), "valueOutOfRange");
    EXPECT_EQ(errorKey(line.runLine(QStringLiteral("preset 05 33554432 --json"))), "valueOutOfRange");
    EXPECT_EQ(line.registers(0x05).preset, 1U);
}

TEST(CliLinePreset, UnpluggedInTheMiddleItIsNotKnown)
{
    SharedLine line;
    line.unplugAfter("05GP");
    const CliRun run = line.runLine(QStringLiteral("preset 05 1000"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("The serial port training line is gone"));
    EXPECT_THAT(run.err, HasSubstr("05GP000003E8 was sent and before it was answered: it is not known"));
}

TEST(CliLinePreset, CutOffTellsWhatIsKnown)
{
    SharedLine line;
    line.interruptAfter("05GP");
    const CliRun cancelled = line.runLine(QStringLiteral("preset 05 1000"));
    EXPECT_EQ(cancelled.exit, 1);
    EXPECT_EQ(cancelled.out, "Position before: 4661\nPosition after:  1000\nEEPROM writes:   1\n");
    EXPECT_THAT(cancelled.err, HasSubstr("The job was cancelled."));
    line.unplugAfter("05GP");
    const CliRun gone = line.runLine(QStringLiteral("preset 05 2000"));
    EXPECT_EQ(gone.exit, 1);
    EXPECT_EQ(gone.out, "Position before: 1000\nEEPROM writes:   1\n"
                        "Whether the position was set is not known: read it.\n");
}

} // namespace
} // namespace codewheel
