// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/cli_run.h"

#include <QDir>
#include <QJsonArray>

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

using testing::StartsWith;

TEST(CliCommandLine, HelpTellsCommandsOptionsExamplesAndExitCodes)
{
    for (const char *line : {"--help", "-h"}) {
        const CliRun run = runLine(QString::fromLatin1(line));
        EXPECT_EQ(run.exit, 0);
        EXPECT_EQ(run.err, "");
        for (const char *part : {"devices", "scan", "explain", "words", "read", "write", "preset", "monitor",
                                 "--json", "--link", "new training bus", "Exit code: 0 done; 1", "020000FF"})
            EXPECT_THAT(run.out, HasSubstr(part));
    }
}

TEST(CliCommandLine, EachCommandExplainsItself)
{
    for (const char *command :
         {"devices", "scan", "compare", "explain", "words", "read", "write", "preset", "monitor"}) {
        const CliRun run = runLine(QStringLiteral("%1 --help").arg(QString::fromLatin1(command)));
        EXPECT_EQ(run.exit, 0);
        EXPECT_THAT(run.out, StartsWith(std::string("Usage: codewheel-cli ") + command));
        EXPECT_THAT(run.out, HasSubstr(std::string("  codewheel-cli ") + command));
    }
}

// Users type the examples first.
TEST(CliCommandLine, TheExamplesOfTheHelpWork)
{
    QDir::setCurrent(QStringLiteral(CODEWHEEL_ROOT)); // the examples name files in docs/examples
    const QString prefix = QStringLiteral("  codewheel-cli ");
    for (const char *command :
         {"devices", "scan", "explain", "words", "read", "write", "preset", "monitor", "terminal"}) {
        const CliRun help = runLine(QStringLiteral("%1 --help").arg(QString::fromLatin1(command)));
        int examples = 0;
        for (const QString &line : QString::fromStdString(help.out).split(u'\n')) {
            if (!line.startsWith(prefix))
                continue;
            ++examples;
            const CliRun run = runLine(line.sliced(prefix.size()), {true, "y\n"});
            EXPECT_NE(run.exit, 2) << line.toStdString() << '\n' << run.err;
            EXPECT_NE(run.out, "") << line.toStdString();
        }
        EXPECT_GT(examples, 0) << command;
    }
}

TEST(CliCommandLine, TellsItsVersion)
{
    EXPECT_THAT(runLine(QStringLiteral("--version")).out, StartsWith("codewheel-cli 0."));
    EXPECT_EQ(runLine(QStringLiteral("scan --version")).out, runLine(QStringLiteral("--version")).out);
}

TEST(CliCommandLine, HelpAndVersionAreJsonToo)
{
    const QJsonObject version = runLine(QStringLiteral("--version --json")).json();
    EXPECT_EQ(version[u"program"], QStringLiteral("codewheel-cli"));
    EXPECT_EQ(QStringLiteral("codewheel-cli %1\n").arg(version[u"version"].toString()).toStdString(),
              runLine(QStringLiteral("--version")).out);
    EXPECT_EQ(version[u"exit"], 0);
    EXPECT_EQ(runLine(QStringLiteral("scan --version --json")).json()[u"version"], version[u"version"]);

    for (const char *line : {"--help --json", "-h --json", "--json --help"}) {
        const QJsonObject help = runLine(QString::fromLatin1(line)).json();
        EXPECT_EQ(help[u"exit"], 0) << line;
        EXPECT_GT(help[u"commands"].toArray().size(), 20) << line;
        EXPECT_EQ(help[u"commands"][0][u"name"], QStringLiteral("devices"));
        EXPECT_GT(help[u"options"].toArray().size(), 3);
        EXPECT_GT(help[u"examples"].toArray().size(), 3);
    }
    const QJsonObject read = runLine(QStringLiteral("read --help --json")).json();
    EXPECT_EQ(read[u"command"], QStringLiteral("read"));
    EXPECT_EQ(read[u"exit"], 0);
    EXPECT_TRUE(read[u"usage"].toString().startsWith(QStringLiteral("codewheel-cli read PLACE")));
    EXPECT_FALSE(read[u"details"].toString().isEmpty());
    EXPECT_EQ(read[u"options"][0][u"name"], QStringLiteral("--device"));
    EXPECT_EQ(read[u"options"][0][u"value"], QStringLiteral("NAME"));
    const std::string lines = runLine(QStringLiteral("terminal --help --json")).out;
    EXPECT_EQ(std::ranges::count(lines, '\n'), 1) << "a line for each object";
}

TEST(CliCommandLine, CommonOptionsMayStandBeforeTheCommand)
{
    EXPECT_EQ(runLine(QStringLiteral("--json scan")).json()[u"command"], QStringLiteral("scan"));
    EXPECT_EQ(runLine(QStringLiteral("--link training --json scan")).exit, 0);
    EXPECT_EQ(runLine(QStringLiteral("--link=training scan --json")).exit, 0);
    EXPECT_EQ(runLine(QStringLiteral("--project missing.codewheel scan --json")).json()[u"command"],
              QStringLiteral("scan"));
}

TEST(CliCommandLine, EachCallHasANewBusThatStartsTheSame)
{
    const CliRun first = runLine(QStringLiteral("write 1.0 steps=255 --yes --trace --json"));
    EXPECT_EQ(first.exit, 0);
    EXPECT_EQ(runLine(QStringLiteral("write 1.0 steps=255 --yes --trace --json")).out, first.out);
}

TEST(CliCommandLine, JsonHasCommandAndExitCode)
{
    const CliRun done = runLine(QStringLiteral("read 1.0 steps --json"));
    EXPECT_EQ(done.json()[u"command"], QStringLiteral("read"));
    EXPECT_EQ(done.json()[u"exit"], 0);
    EXPECT_FALSE(done.json().contains(u"error"));

    const CliRun refused = runLine(QStringLiteral("read 2.0 --json"));
    EXPECT_EQ(refused.json()[u"command"], QStringLiteral("read"));
    EXPECT_EQ(refused.json()[u"exit"], 1);
    EXPECT_EQ(refused.json()[u"error"][u"arguments"][0], QStringLiteral("Baumer GXP6W K3"));
}

struct BadCommandLine
{
    const char *line;
    const char *key;
    const char *help;
};

class CliCommandLineBadInput : public testing::TestWithParam<BadCommandLine>
{};

TEST_P(CliCommandLineBadInput, SaysWhatWouldBeRightAndExits2)
{
    const QString line = QString::fromLatin1(GetParam().line);
    const CliRun plain = runLine(line);
    EXPECT_EQ(plain.exit, 2);
    EXPECT_EQ(plain.out, "");
    EXPECT_THAT(plain.err, StartsWith("codewheel-cli: "));
    EXPECT_THAT(plain.err, HasSubstr(GetParam().help));
    const CliRun json = runLine(line + QStringLiteral(" --json"));
    EXPECT_EQ(json.exit, 2);
    EXPECT_EQ(errorKey(json), GetParam().key);
    EXPECT_EQ(json.json()[u"exit"], 2);
}

INSTANTIATE_TEST_SUITE_P(
    Calls, CliCommandLineBadInput,
    testing::Values(
        BadCommandLine{"", "missingCommand", "devices, scan, compare, explain, words, read, write"},
        BadCommandLine{"--quiet", "unknownOption", "--json"},
        BadCommandLine{"rad 1.0", "unknownCommand", "devices, scan, compare, explain, words, read, write"},
        BadCommandLine{"scan --all", "unknownOption", "--json"},
        BadCommandLine{"write 1.0 steps=1 --force", "unknownOption", "--dry-run"},
        BadCommandLine{"scan 1.0", "tooManyArguments", "codewheel-cli scan"},
        BadCommandLine{"preset 1.0 5 6", "tooManyArguments", "\"6\" is too much"},
        BadCommandLine{"read", "missingArgument", "read PLACE [PARAMETER...]"},
        BadCommandLine{"write 1.0", "missingArgument", "write PLACE PARAMETER=VALUE..."},
        BadCommandLine{"words 1.0", "missingArgument", "words PLACE WORD..."},
        BadCommandLine{"scan --link modbus", "unknownLink", "training"},
        BadCommandLine{"devices --link modbus", "unknownLink", "training"}));

} // namespace
} // namespace codewheel
