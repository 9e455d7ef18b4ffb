// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/kinds/esc/shared_line.h"

#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::vector<QJsonObject> lines(const CliRun &run)
{
    std::vector<QJsonObject> objects;
    for (const QByteArray &line : QByteArray::fromStdString(run.out).trimmed().split('\n'))
        objects.push_back(CliRun{0, line.toStdString(), {}}.json());
    return objects;
}

TEST(CliTerminal, SendsWhatIsTypedOnceAndPrintsBothWays)
{
    SharedLine line;
    const CliRun run = line.runLine(QStringLiteral("terminal 05P"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.out,
              "      0.0  sent      <1B>05P<0D><0A>           1B 30 35 50 0D 0A                             "
              "05: position?\n"
              "     10.5  answer    <0D><0A>00001235<0D><0A>  0D 0A 30 30 30 30 31 32 33 35 0D 0A           "
              "1235h = 4661\n");
}

TEST(CliTerminal, ReadsRequestsFromAPipe)
{
    SharedLine line;
    const CliRun run = line.runLine(QStringLiteral("terminal"), {false, "05N\n\n 12a \n03P"});
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("0012D5A4h\n"));
    EXPECT_THAT(run.out, HasSubstr("12: alarms?\n"));
    EXPECT_THAT(run.out, HasSubstr("03: position?\n"));
}

TEST(CliTerminal, ForProgramsEachRowIsALine)
{
    SharedLine line;
    const auto rows = lines(line.runLine(QStringLiteral("terminal 05P --json")));
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0], (QJsonObject{{QStringLiteral("microseconds"), 0},
                                    {QStringLiteral("direction"), QStringLiteral("sent")},
                                    {QStringLiteral("bytes"), QStringLiteral("1B 30 35 50 0D 0A")},
                                    {QStringLiteral("text"), QStringLiteral("<1B>05P<0D><0A>")},
                                    {QStringLiteral("address"), QStringLiteral("05")},
                                    {QStringLiteral("letters"), QStringLiteral("P")},
                                    {QStringLiteral("data"), QJsonValue()}}));
    EXPECT_EQ(rows[1][u"answer"], QStringLiteral("value"));
    EXPECT_EQ(rows[1][u"value"], 0x1235);
    EXPECT_EQ(rows[2][u"command"], QStringLiteral("terminal"));
    EXPECT_EQ(rows[2][u"exit"], 0);
    EXPECT_EQ(rows[2][u"figures"][u"answers"], 1);
}

TEST(CliTerminal, WhatWritesIsAskedFor)
{
    SharedLine line;
    const CliRun nobody = line.runLine(QStringLiteral("terminal 05GP1000 05P"));
    EXPECT_EQ(nobody.exit, 2);
    EXPECT_THAT(nobody.err, HasSubstr("05GP00001000 writes, and was not sent"));
    EXPECT_EQ(nobody.out, ""); // the rest is not sent either

    const CliRun no = line.runLine(QStringLiteral("terminal"), {true, "05GP1000\nn\n05P\n"});
    EXPECT_EQ(no.exit, 0);
    EXPECT_THAT(no.out, HasSubstr("1B 30 35 47 50 30 30 30 30 31 30 30 30 0D 0A"));
    EXPECT_THAT(no.out, HasSubstr("1235h = 4661\n"));
    EXPECT_EQ(line.registers(0x05).preset, 1U);

    EXPECT_THAT(line.runLine(QStringLiteral("terminal"), {true, "05GP1000\ny\n05P\n"}).out,
                HasSubstr("1000h = 4096\n"));
    EXPECT_EQ(line.runLine(QStringLiteral("terminal 05GP2000 --yes")).exit, 0);
    EXPECT_EQ(line.registers(0x05).preset, 0x2000U);
}

TEST(CliTerminal, InAPipeTheFirstThatIsWrongIsTheLast)
{
    SharedLine line;
    const CliRun typo = line.runLine(QStringLiteral("terminal"), {false, "05P\n05?\n05N\n"});
    EXPECT_EQ(typo.exit, 2);
    EXPECT_THAT(typo.err, StartsWith("codewheel-cli: "));
    EXPECT_THAT(typo.out, testing::Not(HasSubstr("serial number")));

    const CliRun silent = line.runLine(QStringLiteral("terminal 07P 05P --json"));
    EXPECT_EQ(silent.exit, 1);
    EXPECT_EQ(lines(silent).back()[u"error"][u"key"], QStringLiteral("escNoAnswer"));

    // A person at the terminal can go on.
    const CliRun person = line.runLine(QStringLiteral("terminal"), {true, "05?\n07P\n05N\n"});
    EXPECT_EQ(person.exit, 0);
    EXPECT_THAT(person.out, HasSubstr("0012D5A4h\n"));
}

TEST(CliTerminal, AnAnswerThatRefusesIsAnAnswer)
{
    SharedLine line;
    const CliRun run = line.runLine(QStringLiteral("terminal 05GT00000001 --yes"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("answer"));
}

// The serial number identifies the encoder before the write, which is never sent.
TEST(CliTerminal, AWriteThatThePortWasGoneForWasNotSent)
{
    SharedLine line;
    line.unplugAfter("03N");
    const CliRun run = line.runLine(QStringLiteral("terminal 03GP5200 --yes --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(CliRun{run.exit, run.out.substr(run.out.rfind('\n', run.out.size() - 2) + 1), {}}),
              "portLost");
    EXPECT_THAT(run.out, testing::Not(HasSubstr("03GP")));
    EXPECT_THAT(run.err, testing::Not(HasSubstr("carried out")));
}

TEST(CliTerminal, SaysWhenTheAdapterIsUnplugged)
{
    SharedLine line;
    line.unplugAfter("05N");
    const CliRun run = line.runLine(QStringLiteral("terminal"), {true, "05P\n05N\n05P\n"});
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("The serial port training line is gone"));
}

TEST(CliTerminal, CtrlCSendsNothingElse)
{
    for (const char *call : {"terminal 05GL00000005 05GL00000006 --yes --json", "terminal --yes --json"}) {
        SharedLine line;
        line.interruptAfter("05GL");
        const CliRun run = line.runLine(QString::fromLatin1(call), {false, "05GL00000005\n05GL00000006\n"});
        EXPECT_THAT(run.out, HasSubstr("05GL00000005"));
        EXPECT_THAT(run.out, testing::Not(HasSubstr("05GL00000006"))) << call;
        EXPECT_EQ(line.registers(0x05).lowerLimit, 5U);
    }
    SharedLine line;
    line.interruptAfter("05P");
    const CliRun run = line.runLine(QStringLiteral("terminal 05P 05N --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(lines(run).back()[u"error"][u"key"], QStringLiteral("cancelled"));
}

TEST(CliTerminal, SaysNothingOfTheWiringWhenTheAdapterIsUnplugged)
{
    SharedLine line;
    line.unplugAfter("05GP");
    const CliRun run = line.runLine(QStringLiteral("terminal 05GP1000 --yes"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("The serial port training line is gone"));
    EXPECT_THAT(run.err, HasSubstr("Whether it was carried out is not known"));
    EXPECT_THAT(run.err, testing::Not(HasSubstr("baud rate")));
}

TEST(CliTerminal, PollsNothing)
{
    SharedLine line;
    const CliRun run = line.runLine(QStringLiteral("terminal 05GD1 05A --yes"));
    EXPECT_THAT(run.out, testing::Not(HasSubstr("position?")));
}

} // namespace
} // namespace codewheel
