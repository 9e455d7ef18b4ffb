// SPDX-License-Identifier: GPL-3.0-or-later
// The program as started by a script: nobody at a terminal.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QProcessEnvironment>
#include <QScopeGuard>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

struct Ended
{
    int exit = -1;
    std::string out;
    std::string err;
};

// `locale`: the system's setting, English by default.
Ended start(const QString &line, const QString &locale = QStringLiteral("C.UTF-8"))
{
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("LANGUAGE"));
    environment.insert(QStringLiteral("LC_ALL"), locale);
    program.setProcessEnvironment(environment);
    program.setStandardInputFile(QProcess::nullDevice());
    program.start(QStringLiteral(CODEWHEEL_CLI), line.split(u' ', Qt::SkipEmptyParts));
    EXPECT_TRUE(program.waitForFinished(60'000));
    EXPECT_EQ(program.exitStatus(), QProcess::NormalExit);
    return {program.exitCode(), program.readAllStandardOutput().toStdString(),
            program.readAllStandardError().toStdString()};
}

TEST(CliProgram, DoesTheMainJob)
{
    const Ended run =
        start(QStringLiteral("write 1.0 steps=255 revolutions=1 direction=cw preset=0 --yes --trace"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(run.out, HasSubstr("020000FF  C20000FF"));
}

TEST(CliProgram, WithoutATerminalNothingIsWritten)
{
    const Ended run = start(QStringLiteral("write 1.0 steps=255"));
    EXPECT_EQ(run.exit, 2);
    EXPECT_THAT(run.out, HasSubstr("020000FF"));
    EXPECT_THAT(run.err, HasSubstr("Add --yes"));
}

TEST(CliProgram, SpeaksTheLanguageOfTheSystem)
{
    const QString line = QStringLiteral("explain 00012A4F --device fraba-ocd-ib --direction in");
    EXPECT_THAT(start(line).out, HasSubstr("Running, position 76367"));
    EXPECT_THAT(start(line, QStringLiteral("de_DE.UTF-8")).out, HasSubstr("In Betrieb, Position 76367"));
}

TEST(CliProgram, WhatIsKnownIsToldInTheLanguageOfTheSystem)
{
    const Ended run = start(QStringLiteral("clone 03 05 --dry-run"), QStringLiteral("de_DE.UTF-8"));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("(gelesen)"));
    EXPECT_THAT(run.out, testing::Not(testing::ContainsRegex("[(](read|confirmed|told)[)]")));
}

// Numbers that are printed can be typed in again, and found by a script.
TEST(CliProgram, DigitsAreThoseOfPrograms)
{
    for (const char *locale : {"ar_EG.UTF-8", "fa_IR.UTF-8", "ne_NP.UTF-8"}) {
        const Ended run = start(QStringLiteral("read 1.0"), QString::fromLatin1(locale));
        EXPECT_EQ(run.exit, 0) << run.err;
        EXPECT_THAT(run.out, HasSubstr("= 8192\n")) << locale;
        EXPECT_THAT(run.out, HasSubstr("= 24.5 ")) << locale;
        const Ended written =
            start(QStringLiteral("write 1.0 preset=12 --dry-run"), QString::fromLatin1(locale));
        EXPECT_EQ(written.exit, 0) << written.err;
    }
}

// Except for the texts that docs/command-line.md gives in the user's language.
TEST(CliProgram, JsonIsTheSameInEveryLanguage)
{
    for (const char *line : {"devices --json",
                             "scan --json",
                             "explain 00012A4F --device fraba-ocd-ib --direction in --json",
                             "explain 40000000 --device fraba-ocd-ib --direction out --json",
                             "words 2.0 04004E20 80000000 --json",
                             "words 1.0 02000000 --json",
                             "read 1.0 --json",
                             "read 2.0 --json",
                             "write 1.0 steps=255 direction=ccw --yes --trace --json",
                             "write 1.0 steps=0 --json",
                             "write 1.0 steps=255 --dry-run --json",
                             "preset 1.0 7 --json",
                             "monitor 2.0 --for 0.05 --json",
                             "velocity 2.0 off --json",
                             "read 5.0 rod-length --json",
                             "read 1.0 --device kuebler-esc-rs485 --json",
                             "read 05 --trace --json",
                             "read 07 --json",
                             "write 05 steps=864 direction=ccw --yes --trace --json",
                             "preset 05 1000 --json",
                             "monitor 03 --for 1 --json",
                             "terminal 05P 05V 05GP1000 05O --yes --json",
                             "words 05 0 --json",
                             "explain 7005 --device kuebler-esc-rs485 --other 05O --json",
                             "read 20 --json",
                             "cams 1.0 read --program 9 --json"}) {
        const QString command = QString::fromLatin1(line);
        const Ended english = start(command);
        EXPECT_NE(english.out, "") << line;
        EXPECT_EQ(start(command, QStringLiteral("de_DE.UTF-8")).out, english.out) << line;
    }
}

// The last argument is a reason in the user's language; key and place do not depend on it.
TEST(CliProgram, OnlyTheReasonInAJsonErrorIsInTheUsersLanguage)
{
    QTemporaryDir folder;
    const QString broken = folder.filePath(QStringLiteral("broken.json"));
    QFile file(broken);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{\n  \"format\": \"codewheel-sequence\"\n}\n");
    file.close();
    for (const QString &line : {QStringLiteral("devices --label OCD-IBA1B-1413-C100-PRI --json"),
                                QStringLiteral("cams 1.0 compare %1 --json").arg(broken)}) {
        const auto error = [&](const QString &locale) {
            return QJsonDocument::fromJson(QByteArray::fromStdString(start(line, locale).out))[u"error"]
                .toObject();
        };
        QJsonObject english = error(QStringLiteral("C.UTF-8"));
        QJsonObject german = error(QStringLiteral("de_DE.UTF-8"));
        for (QJsonObject *each : {&english, &german}) {
            QJsonArray arguments = (*each)[u"arguments"].toArray();
            ASSERT_GE(arguments.size(), 3) << line.toStdString();
            EXPECT_NE(arguments.takeAt(arguments.size() - 1).toString(), QString()) << line.toStdString();
            each->insert(u"arguments", arguments);
        }
        EXPECT_EQ(english, german) << line.toStdString();
    }
}

TEST(CliProgram, MakesAPdfWithoutAScreen)
{
    const QByteArray platform = qgetenv("QT_QPA_PLATFORM");
    const auto restore = qScopeGuard([&] { qputenv("QT_QPA_PLATFORM", platform); });
    qputenv("QT_QPA_PLATFORM", "there is none");
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("report.pdf"));
    const Ended run =
        start(QStringLiteral("report %1/docs/examples/two-encoders.codewheel --read --json -o %2")
                  .arg(QStringLiteral(CODEWHEEL_ROOT), path));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.err,
              "codewheel-cli: The bus \"Ring\" differs from the project. See codewheel-cli compare.\n");
    EXPECT_THAT(run.out, HasSubstr("\"pages\": "));
    QFile pdf(path);
    ASSERT_TRUE(pdf.open(QIODevice::ReadOnly));
    EXPECT_TRUE(pdf.readAll().startsWith("%PDF-"));
}

// A Qt without its SQLite driver.
TEST(CliProgram, SaysThatNothingIsKeptWithoutTheDriver)
{
    const QTemporaryDir folder;
    const QString program = folder.filePath(QStringLiteral("codewheel-cli"));
    ASSERT_TRUE(QFile::copy(QStringLiteral(CODEWHEEL_CLI), program));
    QFile settings(folder.filePath(QStringLiteral("qt.conf")));
    ASSERT_TRUE(settings.open(QIODevice::WriteOnly));
    settings.write("[Paths]\nPlugins = nowhere\n");
    settings.close();
    QProcess process;
    process.start(program, {QStringLiteral("scan")});
    ASSERT_TRUE(process.waitForFinished());
    EXPECT_EQ(process.exitCode(), 0);
    EXPECT_THAT(process.readAllStandardError().toStdString(),
                HasSubstr("codewheel-cli: Messages are not kept, and EEPROM writes are counted for this "
                          "connection only: Qt's driver for SQLite is missing on this computer."));
}

TEST(CliProgram, ExitCodesTellWhoRefused)
{
    EXPECT_EQ(start(QStringLiteral("--version")).exit, 0);
    EXPECT_EQ(start(QStringLiteral("read 2.0")).exit, 1);
    EXPECT_EQ(start(QStringLiteral("words 2.0 04004E20 80000000")).exit, 1);
    EXPECT_EQ(start(QStringLiteral("words 1.0 nohex")).exit, 2);
    EXPECT_EQ(start(QString()).exit, 2);
}

} // namespace
} // namespace codewheel
