// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/project_file.h"
#include "tests/cli/cli_run.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::Not;

// Node 5 and node 6 send their first PDO for two seconds, from 2018-12-06 14:31:19 UTC on. Somebody reads the
// mapping of node 6 at the beginning.
class CliCanLog : public testing::Test
{
protected:
    CliCanLog()
    {
        constexpr const char *mapping[] = {
            "586#4300180186010000", "586#4F001802FE000000", "586#4B00180300000000",
            "586#4B00180500000000", "586#4F001A0001000000", "586#43001A0120000460",
        };
        qint64 microseconds = 1'544'106'679'000'000;
        QByteArray text;
        const auto add = [&](const QByteArray &frame, int later) {
            microseconds += later;
            text += '(' + QByteArray::number(static_cast<double>(microseconds) / 1e6, 'f', 6) + ") can0 " +
                    frame + '\n';
        };
        for (const QByteArray answer : mapping) {
            add("606#40" + answer.mid(6, 6) + "00000000", 1'000); // the same object
            add(answer, 1'000);
        }
        for (int i = 0; i < 200; ++i) {
            add("185#" + octets(5'000 + i), 9'000);
            add("186#" + octets(1'000 + 2 * i), 1'000);
        }
        add("085#1081010000000000", 1'000);
        QFile file(log());
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    QString log() const { return m_folder.filePath(QStringLiteral("bus.log")); }
    CliRun run(const QString &line, const QString &settings = {})
    {
        return runLine(line + QStringLiteral(" --link log:") + log() + settings);
    }
    static QByteArray octets(int number)
    {
        QByteArray bytes(4, '\0');
        for (int i = 0; i < 4; ++i)
            bytes[i] = static_cast<char>(number >> 8 * i);
        return bytes.toHex().toUpper();
    }

    QTemporaryDir m_folder;
};

TEST_F(CliCanLog, ScanListsWhoIsInIt)
{
    const CliRun scan = run(QStringLiteral("scan"));
    EXPECT_EQ(scan.exit, 0);
    EXPECT_THAT(scan.out, HasSubstr("can:5  operational  sends  8110h"));
    EXPECT_THAT(scan.out, HasSubstr("can:6  operational  sends  -"));
    EXPECT_EQ(errorKey(run(QStringLiteral("scan --ask --json"))), "canOnlyLogged");
}

TEST_F(CliCanLog, MonitorShowsPositionsByAMappingThatIsInIt)
{
    const CliRun monitor = run(QStringLiteral("monitor can:6 --every 1000"));
    EXPECT_THAT(monitor.out, HasSubstr("      1194  operational"));
    EXPECT_THAT(run(QStringLiteral("monitor can:5 --every 1000")).out,
                HasSubstr("if it is mapped as CiA 406"));
    EXPECT_EQ(errorKey(run(QStringLiteral("monitor can:9 --json"))), "nodeSilent");
}

TEST_F(CliCanLog, OthersOnlyIfTheUserSaysThatTheMappingIsTheUsualOne)
{
    const CliRun monitor =
        run(QStringLiteral("monitor can:5 --every 1000"), QStringLiteral(",usual-mapping=yes"));
    EXPECT_THAT(monitor.out, HasSubstr("      5098  operational"));
    EXPECT_THAT(monitor.out, Not(HasSubstr("if it is mapped")));
}

TEST_F(CliCanLog, BecomesARecordingAndThatATable)
{
    const QString recording = m_folder.filePath(QStringLiteral("bus.cwrec"));
    const QString table = m_folder.filePath(QStringLiteral("bus.csv"));
    const CliRun recorded =
        run(QStringLiteral("record -o ") + recording, QStringLiteral(",usual-mapping=yes"));
    EXPECT_EQ(recorded.exit, 0) << recorded.err;
    EXPECT_THAT(recorded.out, HasSubstr("can:5, can:6"));
    EXPECT_THAT(recorded.out, HasSubstr("Messages: 1"));
    EXPECT_EQ(runLine(QStringLiteral("export %1 -o %2").arg(recording, table)).exit, 0);
    QFile file(table);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = file.readAll().split('\n');
    EXPECT_GE(lines.size(), 400);
    EXPECT_TRUE(lines.value(1).startsWith("1544106679.")) << lines.value(1).toStdString();
    EXPECT_TRUE(lines.value(1).contains("5000")) << lines.value(1).toStdString();
}

// Its first frame, too.
TEST_F(CliCanLog, OnePositionBecomesARecordingOfOne)
{
    QFile file(log());
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("(1544106679.000000) can0 185#88130000\n");
    file.close();
    const QString recording = m_folder.filePath(QStringLiteral("one.cwrec"));
    const QString table = m_folder.filePath(QStringLiteral("one.csv"));
    const CliRun recorded =
        run(QStringLiteral("record -o ") + recording, QStringLiteral(",usual-mapping=yes"));
    EXPECT_EQ(recorded.exit, 0) << recorded.err;
    const CliRun exported = runLine(QStringLiteral("export %1 -o %2").arg(recording, table));
    EXPECT_EQ(exported.exit, 0) << recorded.out << exported.out << exported.err;
    QFile shown(table);
    ASSERT_TRUE(shown.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = shown.readAll().trimmed().split('\n');
    ASSERT_EQ(lines.size(), 2);
    EXPECT_TRUE(lines[1].startsWith("1544106679.000")) << lines[1].toStdString();
    EXPECT_TRUE(lines[1].contains("5000")) << lines[1].toStdString();
}

TEST_F(CliCanLog, WhatIsOverCannotBeAsked)
{
    for (const char *line : {"read can:5 serial-number", "od can:5 read 6004", "nmt start", "lss scan",
                             "write can:5 steps=4096 --yes"})
        EXPECT_EQ(errorKey(run(QString::fromLatin1(line) + QStringLiteral(" --json"))), "notOnCanLog")
            << line;
}

TEST_F(CliCanLog, TheProjectOfAScanHasTheBusThatWasLogged)
{
    const QString file = m_folder.filePath(QStringLiteral("p.codewheel"));
    EXPECT_EQ(run(QStringLiteral("scan --save ") + file).exit, 0);
    QFile saved(file);
    ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
    EXPECT_TRUE(saved.readAll().contains("can:can0"));
}

TEST_F(CliCanLog, ItsSettingsAreChecked)
{
    const std::pair<const char *, const char *> rows[] = {
        {",rate=125000", "unknownCanSetting"},
        {",usual-mapping=no", "canAgreementWrong"},
        {",interface=can7", "canLogHasNotThat"},
        {".none", "fileNotReadable"},
    };
    for (const auto &[settings, key] : rows)
        EXPECT_EQ(errorKey(run(QStringLiteral("scan --json"), QString::fromLatin1(settings))), key)
            << settings;
}

// Node 5 tells that its first PDO has the identifier that node 6 has by the predefined set, which only sends
// its heartbeat. Before, a frame has come under each of both.
class CliCanLogElsewhere : public testing::Test
{
protected:
    void write(const std::vector<QByteArray> &heard)
    {
        QByteArray text;
        int later = 0;
        const auto add = [&](const QByteArray &frame) {
            later += 10'000;
            text +=
                "(1544106679." + QByteArray::number(later).rightJustified(6, '0') + ") can0 " + frame + '\n';
        };
        add("186#88130000");
        for (const QByteArray &frame : heard)
            add(frame);
        for (int i = 0; i < 20; ++i) {
            add("186#88130000");
            add("706#7F");
        }
        QFile file(log);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    std::string monitor(const char *place, const QString &settings = {})
    {
        return runLine(QStringLiteral("monitor %1 --every 100 --link log:").arg(QLatin1String(place)) + log +
                       settings)
            .out;
    }

    const QTemporaryDir folder;
    const QString log = folder.filePath(QStringLiteral("bus.log"));
    const std::vector<QByteArray> identifier{"605#4000180100000000", "585#4300180186010000"};
};

TEST_F(CliCanLogElsewhere, APdoIsRemarkedAtTheNodeThatWasHeardToSendIt)
{
    write(identifier);
    EXPECT_THAT(monitor("can:5"), HasSubstr("position 5000 if it is mapped as CiA 406"));
    EXPECT_THAT(monitor("can:6").substr(monitor("can:6").size() / 2), Not(HasSubstr("PDO1")));
    EXPECT_THAT(monitor("can:6", QStringLiteral(",usual-mapping=yes")), HasSubstr("5000"))
        << "of node 6 nothing was heard otherwise";
}

TEST_F(CliCanLogElsewhere, OneThatHasNoPositionByItsMappingIsNotRemarkedAsAPosition)
{
    std::vector<QByteArray> heard = identifier;
    for (const char *frame :
         {"605#40001A0000000000", "585#4F001A0001000000", "605#40001A0100000000", "585#43001A0110013060"})
        heard.emplace_back(frame);
    write(heard);
    EXPECT_THAT(monitor("can:5"), Not(HasSubstr("if it is mapped")));
}

} // namespace
} // namespace codewheel
