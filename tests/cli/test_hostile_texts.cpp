// SPDX-License-Identifier: GPL-3.0-or-later
// Names, keys and arguments with terminal control sequences: none of them reaches the terminal.
#include "cli/call/command_line.h"
#include "cli/call/terminal.h"
#include "journal/message_store.h"
#include "tests/cli/cli_run.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

const QString hostile = QStringLiteral("Kran\u001B[2J\u202E\u009B\u0007");
constexpr auto shown = "Kran\\u001B[2J\\u202E\\u009B\\u0007";

bool isHarmless(const std::string &said)
{
    const QString text = QString::fromStdString(said);
    return std::ranges::none_of(text, [](QChar c) {
        const bool isControl = c.category() == QChar::Other_Control && c != u'\n';
        return isControl || c == QChar(0x202E) || c == QChar::ReplacementCharacter;
    });
}

class CliHostileTexts : public testing::Test
{
protected:
    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    // The example with `from` replaced.
    QString project(const QByteArray &from, const QByteArray &to) const
    {
        QFile example(
            QStringLiteral("%1/docs/examples/two-encoders.codewheel").arg(QStringLiteral(CODEWHEEL_ROOT)));
        EXPECT_TRUE(example.open(QIODevice::ReadOnly));
        QByteArray json = example.readAll();
        EXPECT_TRUE(json.contains(from));
        QFile file(path("hostile.codewheel"));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(json.replace(from, to));
        return file.fileName();
    }

private:
    QTemporaryDir m_folder;
};

TEST_F(CliHostileTexts, StationsOfAProject)
{
    const QString file =
        project("\"station\": \"Hoist\"", "\"station\": \"Kran\\u001b[2J\\u202e\\u009b\\u0007\"");
    for (const char *command :
         {"compare %1", "transfer %1 --dry-run", "write 1.0 steps=4096 --yes --project %1",
          "scan --project %1", "transfer %1 --yes", "monitor 1.0 --for 1 --project %1"}) {
        const CliRun run = runLine(QString::fromLatin1(command).arg(file));
        EXPECT_TRUE(isHarmless(run.out)) << command << run.out;
        EXPECT_TRUE(isHarmless(run.err)) << command << run.err;
    }
    EXPECT_THAT(runLine(QStringLiteral("transfer %1 --dry-run").arg(file)).out, HasSubstr(shown));
}

TEST_F(CliHostileTexts, KeysOfAProjectAndItsReport)
{
    const QString keys = project("\"station\"", "\"sta\\u001b[31mtion\"");
    const CliRun broken = runLine(QStringLiteral("compare ") + keys);
    EXPECT_EQ(broken.exit, 2);
    EXPECT_THAT(broken.err, HasSubstr("sta\\u001B[31mtion"));
    EXPECT_TRUE(isHarmless(broken.err)) << broken.err;

    const QString file =
        project("\"station\": \"Hoist\"", "\"station\": \"Kran\\u001b[2J\\u202e\\u009b\\u0007\"");
    EXPECT_EQ(runLine(QStringLiteral("transfer %1 --yes --report %2").arg(file, path("account.txt"))).exit,
              0);
    QFile account(path("account.txt"));
    ASSERT_TRUE(account.open(QIODevice::ReadOnly));
    const std::string text = account.readAll().toStdString();
    EXPECT_THAT(text, HasSubstr(shown));
    EXPECT_TRUE(isHarmless(text)) << text;
}

TEST_F(CliHostileTexts, ArgumentsOfACall)
{
    for (const QString &line :
         {hostile, QStringLiteral("read ") + hostile, QStringLiteral("devices ") + hostile,
          QStringLiteral("words 1.0 ") + hostile, QStringLiteral("scan --") + hostile,
          QStringLiteral("compare /no/") + hostile, QStringLiteral("scan --link ") + hostile,
          QStringLiteral("read 1.0 ") + hostile}) {
        const CliRun run = runLine(line);
        EXPECT_NE(run.exit, 0) << line.toStdString();
        EXPECT_TRUE(isHarmless(run.err)) << run.err;
        EXPECT_THAT(run.err, HasSubstr(shown));
        const CliRun json = runLine(line + QStringLiteral(" --json"));
        EXPECT_TRUE(isHarmless(json.out)) << json.out;
    }
}

TEST_F(CliHostileTexts, AFileWhoseNameBreaksTheLine)
{
    const CliRun run = runWith({}, [&](const Terminal &terminal) {
        return runCommandLine({QStringLiteral("compare"), QStringLiteral("x\ncodewheel-cli: all is well")},
                              terminal);
    });
    EXPECT_THAT(run.err, HasSubstr("x\\u000Acodewheel-cli: all is well"));
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1);
}

TEST_F(CliHostileTexts, ArgumentsOfMessagesAndJsonKeepsItsValue)
{
    {
        MessageStore store({.file = path("messages.sqlite")});
        store.add({.id = MessageId::training, .arguments = {hostile}}, QDateTime::currentDateTime());
        store.add({.id = MessageId::training, .arguments = {QStringLiteral("=1+1")}},
                  QDateTime::currentDateTime());
    }
    const QString listed = QStringLiteral("messages --file %1").arg(path("messages.sqlite"));
    const CliRun text = runLine(listed);
    EXPECT_THAT(text.out, HasSubstr(shown));
    EXPECT_TRUE(isHarmless(text.out)) << text.out;
    const CliRun json = runLine(listed + QStringLiteral(" --json"));
    EXPECT_TRUE(isHarmless(json.out)) << json.out;
    EXPECT_EQ(json.json()[u"messages"][0][u"arguments"][0].toString(), hostile);

    EXPECT_EQ(runLine(listed + QStringLiteral(" --export ") + path("all.csv")).exit, 0);
    QFile csv(path("all.csv"));
    ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
    const std::string table = csv.readAll().toStdString();
    EXPECT_THAT(table, HasSubstr(",\"'=1+1\",\r\n"));
    EXPECT_THAT(table, HasSubstr(shown));
}

} // namespace
} // namespace codewheel
