// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/cli_run.h"

#include <QDateTime>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::Not;

class CliFrames : public testing::Test
{
protected:
    CliRun frames(const QByteArray &log, const QString &options = {}) const
    {
        QFile its(file);
        EXPECT_TRUE(its.open(QIODevice::WriteOnly));
        its.write(log);
        its.close();
        return runLine(QStringLiteral("frames %1 ").arg(file) + options);
    }
    QJsonObject json(const QByteArray &log, const QString &options = {}) const
    {
        return frames(log, QStringLiteral("--json ") + options).json();
    }

    QTemporaryDir folder;
    QString file = folder.filePath(QStringLiteral("frames.log"));
};

const QByteArray readOut = "(1544106679.432583) can0 605#4004600000000000\n"
                           "(1544106679.433583) can0 585#4304600088130000 R\n";

TEST_F(CliFrames, EachIsARow)
{
    const CliRun run = frames(readOut + "(1544106679.5) can0 705#R\n(1544106679.6) can0 0CFFE0E0#01\n");
    EXPECT_EQ(run.exit, 0);
    const QString second =
        QDateTime::fromSecsSinceEpoch(1'544'106'679).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
    EXPECT_EQ(QString::fromStdString(run.out).replace(second, QStringLiteral("T")).toStdString(),
              "T.432583  605  40 04 60 00 00 00 00 00  Node 5: read 6004h:0\n"
              "T.433583  585  43 04 60 00 88 13 00 00  Node 5: 6004h:0 = 1388h = 5000\n"
              "T.500000  705  R0                       Node 5: guarding: which state?\n"
              "T.600000  0CFFE0E0  01                       J1939: priority 3, PGN FFE0h, from E0h\n");
    EXPECT_EQ(run.err, "codewheel-cli: The times of the log are absolute; they are shown as local time.\n");
}

TEST_F(CliFrames, AreSavedForOtherPrograms)
{
    const QString saved = folder.filePath(QStringLiteral("saved.log"));
    const QString save = QStringLiteral("--save ") + saved;
    const QByteArray asc = "base hex timestamps absolute\n0.020000 1 185x Rx d 2 88 13\n0.5 1 705 Rx r 1\n";
    const CliRun run = frames(asc, save);
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("Saved in " + saved.toStdString()));
    QFile its(saved);
    ASSERT_TRUE(its.open(QIODevice::ReadOnly));
    EXPECT_EQ(its.readAll(), "(0000000000.000000) can0 00000185#8813\n(0000000000.480000) can0 705#R1\n");
    EXPECT_EQ(errorKey(frames(asc, save + QStringLiteral(" --json"))), "fileExists");
    EXPECT_EQ(frames(readOut, save + QStringLiteral(" --yes")).exit, 0);
    EXPECT_EQ(runLine(QStringLiteral("frames --json ") + saved).json()[u"frames"], json(readOut)[u"frames"]);
}

TEST_F(CliFrames, OfALogThatCannotBeReadNothingIsSaved)
{
    const QString saved = folder.filePath(QStringLiteral("saved.log"));
    EXPECT_EQ(frames("no frame\n", QStringLiteral("--save ") + saved).exit, 1);
    EXPECT_FALSE(QFile::exists(saved));
    const CliRun away = frames(readOut, QStringLiteral("--save %1/missing/saved.log").arg(folder.path()));
    EXPECT_EQ(away.exit, 2) << away.err;
}

TEST_F(CliFrames, AreSavedWithTheirInterface)
{
    const QString saved = folder.filePath(QStringLiteral("saved.log"));
    EXPECT_EQ(
        frames("(1544106679.0) vcan1 080#\n(1544106679.1) can0 185#01 T\n", QStringLiteral("--save ") + saved)
            .exit,
        0);
    QFile its(saved);
    ASSERT_TRUE(its.open(QIODevice::ReadOnly));
    EXPECT_EQ(its.readAll(), "(1544106679.000000) vcan1 080#\n(1544106679.100000) can0 185#01\n");
}

TEST_F(CliFrames, AreNotSavedOntoTheLogItself)
{
    const QString link = folder.filePath(QStringLiteral("link.log"));
    for (const QString &target : {file, link}) {
        frames(readOut);
        QFile::link(file, link);
        const CliRun run = frames(readOut, QStringLiteral("--yes --save ") + target);
        EXPECT_EQ(run.exit, 2);
        EXPECT_THAT(run.err, HasSubstr("is the log itself"));
    }
    QFile its(file);
    ASSERT_TRUE(its.open(QIODevice::ReadOnly));
    EXPECT_EQ(its.readAll(), readOut);
}

TEST_F(CliFrames, WithoutTimesAreNotSaved)
{
    const QString saved = folder.filePath(QStringLiteral("saved.log"));
    const CliRun run = frames("  can0  185   [2]  88 13\n", QStringLiteral("--json --save ") + saved);
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "noTimes");
    EXPECT_FALSE(QFile::exists(saved));
}

TEST_F(CliFrames, OfMoreThanOneInterfaceTellTheirs)
{
    const QByteArray log = "(1.0) can0 185#00\n(2.0) can1 080#\n(3.0) can0 080#\n";
    EXPECT_EQ(frames(log).out, "0.000000  185  00                       Node 5: TPDO1\n"
                               "1.000000  can1  080  -                        SYNC\n"
                               "2.000000  can0  080  -                        SYNC\n");
    EXPECT_EQ(json(log)[u"frames"][1][u"interface"], QStringLiteral("can1"));
}

TEST_F(CliFrames, OptionThatDoesNotFitIsSaid)
{
    const QByteArray dated = "(2018-12-06 14:31:19.0) can0 185#00\n";
    EXPECT_THAT(frames(dated, QStringLiteral("--times differences")).err,
                HasSubstr("--times differences does not fit this log"));
    const CliRun undated = frames("0.5 1 185 Rx d 0\n", QStringLiteral("--times absolute"));
    EXPECT_THAT(undated.err, HasSubstr("--times absolute does not fit this log"));
    EXPECT_THAT(undated.err, HasSubstr("The times of the log are relative"));
    EXPECT_THAT(frames(dated, QStringLiteral("--times absolute")).err, Not(HasSubstr("does not fit")));
}

TEST_F(CliFrames, OfMixedTimesAreTheSameInTextAndJson)
{
    const QByteArray log = "(1544106679.0) can0 185#01\n(0.5) can0 185#02\n(1544106680.0) can0 185#03\n";
    const QJsonObject all = json(log);
    EXPECT_TRUE(all[u"frames"][1][u"microseconds"].isNull());
    EXPECT_EQ(all[u"notes"][0][u"line"].toInt(), 2);
    const CliRun run = frames(log);
    EXPECT_THAT(run.out, HasSubstr("\n-                           185  02"));
    EXPECT_THAT(run.err, HasSubstr("Line 2: Its time is of another kind than the log's"));
}

TEST_F(CliFrames, InJsonWithNumbersAndHexadecimalData)
{
    const QJsonObject all = json(readOut + "(1544106679.5) can0 00000005#R8\n(1544106679.6) can0 7FF#\n");
    EXPECT_EQ(all[u"command"], QStringLiteral("frames"));
    EXPECT_EQ(all[u"exit"].toInt(-1), 0);
    EXPECT_EQ(all[u"count"].toInt(), 4);
    EXPECT_EQ(all[u"times"], QStringLiteral("absolute"));
    EXPECT_EQ(all[u"since"], QStringLiteral("1970"));
    EXPECT_TRUE(all[u"notes"].toArray().isEmpty());
    const QJsonArray list = all[u"frames"].toArray();
    ASSERT_EQ(list.size(), 4);
    EXPECT_EQ(list[1].toObject(),
              (QJsonObject{{QStringLiteral("id"), 0x585},
                           {QStringLiteral("extended"), false},
                           {QStringLiteral("remote"), false},
                           {QStringLiteral("error"), false},
                           {QStringLiteral("length"), 8},
                           {QStringLiteral("data"), QStringLiteral("4304600088130000")},
                           {QStringLiteral("interface"), QStringLiteral("can0")},
                           {QStringLiteral("microseconds"), qint64{1'544'106'679'433'583}},
                           {QStringLiteral("meaning"), QStringLiteral("Node 5: 6004h:0 = 1388h = 5000")}}));
    const QJsonObject remote = list[2].toObject();
    EXPECT_EQ(remote[u"id"].toInt(), 5);
    EXPECT_TRUE(remote[u"extended"].toBool());
    EXPECT_TRUE(remote[u"remote"].toBool());
    EXPECT_EQ(remote[u"length"].toInt(), 8);
    EXPECT_EQ(remote[u"data"], QString());
    EXPECT_TRUE(list[3][u"meaning"].isNull());
}

TEST_F(CliFrames, AnErrorFrameWithoutAClassHasNoIdentifier)
{
    const QJsonArray list = json("0.02 1 ErrorFrame\n0.03 1 185 Rx d 0\n")[u"frames"].toArray();
    EXPECT_TRUE(list[0][u"error"].toBool());
    EXPECT_TRUE(list[0][u"id"].isNull());
    EXPECT_FALSE(list[1][u"error"].toBool());
    const QJsonArray known = json("(1.0) can0 20000040#0000000000000000\n")[u"frames"].toArray();
    EXPECT_EQ(known[0][u"id"].toInt(), 0x40);
    EXPECT_EQ(known[0][u"meaning"], QStringLiteral("Error frame: bus off"));
}

TEST_F(CliFrames, WithoutATimeThereIsNone)
{
    const QJsonObject all = json("  can0  185   [2]  88 13\n");
    EXPECT_TRUE(all[u"times"].isNull());
    EXPECT_TRUE(all[u"since"].isNull());
    EXPECT_TRUE(all[u"frames"][0][u"microseconds"].isNull());
    EXPECT_EQ(frames("  can0  185   [2]  88 13\n").out, "-  185  88 13                    Node 5: TPDO1\n");
}

TEST_F(CliFrames, LinesThatAreNotReadHaveTheirNumberAndAReason)
{
    const QByteArray log = "(1.0) can0 185#00\nhello\n(1.1) can0 185##0\n(1.2) can0 185#01\n";
    const QJsonObject all = json(log);
    EXPECT_EQ(all[u"exit"].toInt(-1), 0);
    EXPECT_EQ(all[u"count"].toInt(), 2);
    EXPECT_EQ(all[u"canFd"].toInt(), 1);
    const QJsonArray notes = all[u"notes"].toArray();
    ASSERT_EQ(notes.size(), 2);
    EXPECT_EQ(notes[0][u"line"].toInt(), 2);
    EXPECT_EQ(notes[0][u"reason"], QStringLiteral("This is no line of a CAN log."));
    EXPECT_EQ(notes[1][u"line"].toInt(), 3);
    EXPECT_THAT(notes[1][u"reason"].toString().toStdString(), HasSubstr("CAN FD"));
    const CliRun run = frames(log);
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.err, HasSubstr("Line 2: This is no line of a CAN log.\n"));
    EXPECT_THAT(run.err, HasSubstr("CAN FD frames: 1\n"));
}

TEST_F(CliFrames, OfManySuchLinesSomeAreTold)
{
    const QByteArray log = "(1.0) can0 185#00\n" + QByteArray("hello\n").repeated(1'500);
    const QJsonObject all = json(log);
    EXPECT_EQ(all[u"notes"].toArray().size(), 1'000);
    EXPECT_EQ(all[u"moreNotes"].toInt(), 500);
    EXPECT_THAT(frames(log).err, HasSubstr("Further lines that were not read: 1480\n"));
}

TEST_F(CliFrames, WhatTheTimesAreIsSaidAndCanBeSaid)
{
    const QByteArray log = "(000.000000) can0 185#00\n(000.010000) can0 185#00\n(000.000500) can0 185#00\n";
    const QJsonObject taken = json(log);
    EXPECT_EQ(taken[u"times"], QStringLiteral("differences"));
    EXPECT_EQ(taken[u"since"], QStringLiteral("first"));
    EXPECT_EQ(taken[u"frames"][2][u"microseconds"].toInt(), 10'500);
    EXPECT_THAT(frames(log).err, HasSubstr("The times of the log are differences; they are shown since"));
    const QJsonObject told = json(log, QStringLiteral("--times relative"));
    EXPECT_EQ(told[u"times"], QStringLiteral("relative"));
    EXPECT_EQ(told[u"frames"][2][u"microseconds"].toInt(), 500);
    EXPECT_THAT(frames(log, QStringLiteral("--times relative")).out, HasSubstr("\n0.000500  185  00  "));
}

TEST_F(CliFrames, ATimeBeforeTheFirstIsNegative)
{
    EXPECT_THAT(frames("(1.0) can0 185#00\n(0.75) can0 080#\n", QStringLiteral("--times relative")).out,
                HasSubstr("\n-0.250000  080  "));
}

TEST_F(CliFrames, WhatCannotBeReadIsBadInputAndNothingReadIsRefused)
{
    const CliRun missing = runLine(QStringLiteral("frames %1 --json").arg(file));
    EXPECT_EQ(missing.exit, 2);
    EXPECT_EQ(errorKey(missing), "fileNotReadable");
    const CliRun isFolder = runLine(QStringLiteral("frames %1 --json").arg(folder.path()));
    EXPECT_EQ(isFolder.exit, 2);
    EXPECT_EQ(errorKey(isFolder), "fileNotReadable");
    for (const char *nothing : {"", "\n", "hello\nworld\n"}) {
        const CliRun run = frames(nothing, QStringLiteral("--json"));
        EXPECT_EQ(run.exit, 1) << nothing;
        EXPECT_EQ(errorKey(run), "noFrames") << nothing;
        EXPECT_TRUE(run.json()[u"frames"].toArray().isEmpty());
    }
    EXPECT_EQ(runLine(QStringLiteral("frames")).exit, 2);
    const CliRun wrong = frames(readOut, QStringLiteral("--json --times today"));
    EXPECT_EQ(wrong.exit, 2);
    EXPECT_EQ(errorKey(wrong), "optionNotAllowed");
}

TEST_F(CliFrames, ALongLogComesInOrder)
{
    QByteArray log;
    for (int i = 0; i < 30'000; ++i)
        log += QByteArray("(") + QByteArray::number(i) + ".0) can0 185#" +
               QByteArray::number(i, 16).rightJustified(8, '0') + '\n';
    const QJsonArray list = json(log)[u"frames"].toArray();
    ASSERT_EQ(list.size(), 30'000);
    for (int i = 0; i < 30'000; ++i)
        ASSERT_EQ(list[i][u"microseconds"].toInteger(), i * 1'000'000LL);
    EXPECT_EQ(std::ranges::count(frames(log).out, '\n'), 30'000);
}

TEST_F(CliFrames, NothingInALogControlsTheTerminal)
{
    EXPECT_THAT(frames("(1.0) \x1B[31m 185#00\n(1.1) can0 \x1B[31m#00\n").out, Not(HasSubstr("\x1B")));
}

} // namespace
} // namespace codewheel
