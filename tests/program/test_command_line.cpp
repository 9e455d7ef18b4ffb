// SPDX-License-Identifier: GPL-3.0-or-later
// What the window program prints when started in a terminal.
#include <QProcess>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr int generous = 60'000; // ms; sanitizers are slow

struct Ended
{
    int exitCode = -1;
    QString output;
    QString errors;
};

Ended run(const QStringList &arguments, const QString &platform, const QString &output = {})
{
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("DISPLAY"));
    environment.remove(QStringLiteral("WAYLAND_DISPLAY"));
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), platform);
    program.setProcessEnvironment(environment);
    if (!output.isEmpty())
        program.setStandardOutputFile(output);
    program.start(QStringLiteral(CODEWHEEL_PROGRAM), arguments);
    EXPECT_TRUE(program.waitForFinished(generous));
    return {program.exitCode(), QString::fromUtf8(program.readAllStandardOutput()),
            QString::fromUtf8(program.readAllStandardError())};
}

TEST(CommandLine, TellsWhatItTakesWithoutAScreen)
{
    for (const char *option : {"--help", "-h"}) {
        const Ended help = run({QString::fromLatin1(option)}, QStringLiteral("xcb"));
        EXPECT_EQ(help.exitCode, 0) << help.errors.toStdString();
        EXPECT_TRUE(help.output.contains(QStringLiteral("[FILE]"))) << help.output.toStdString();
    }
}

TEST(CommandLine, TellsItsVersionWithoutAScreen)
{
    const Ended version = run({QStringLiteral("--version")}, QStringLiteral("xcb"));
    EXPECT_EQ(version.exitCode, 0) << version.errors.toStdString();
    EXPECT_EQ(version.output, QStringLiteral("codewheel " CODEWHEEL_VERSION "\n"));
}

TEST(CommandLine, AnOptionItDoesNotKnowIsNotTakenForAProject)
{
    const Ended refused = run({QStringLiteral("--operate")}, QStringLiteral("offscreen"));
    EXPECT_NE(refused.exitCode, 0);
    EXPECT_TRUE(refused.errors.contains(QStringLiteral("operate"))) << refused.errors.toStdString();
}

TEST(CommandLine, AnOptionSteersNoTerminal)
{
    const Ended refused = run({QStringLiteral("--a\u001B[31m\u202E")}, QStringLiteral("offscreen"));
    EXPECT_NE(refused.exitCode, 0);
    EXPECT_TRUE(refused.errors.contains(QStringLiteral("a\\u001B[31m\\u202E")))
        << refused.errors.toStdString();
}

TEST(CommandLine, HelpThatCannotBeWrittenIsAFailure)
{
    for (const char *option : {"--help", "--version"}) {
        const Ended told =
            run({QString::fromLatin1(option)}, QStringLiteral("xcb"), QStringLiteral("/dev/full"));
        EXPECT_EQ(told.exitCode, 1) << option;
        EXPECT_TRUE(told.errors.contains(QStringLiteral("Standard output cannot be written: No space left")))
            << told.errors.toStdString();
    }
}

} // namespace
} // namespace codewheel
