// SPDX-License-Identifier: GPL-3.0-or-later
// The real program with a standard output that accepts nothing, and with closed streams.
#include <QJsonDocument>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>

#include <array>
#include <fcntl.h>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

struct Silenced
{
    int exit = -1;
    std::string err;
};

// `prepare` runs in the new process before the program starts.
Silenced startWith(const QString &line, const std::function<void()> &prepare)
{
    const QTemporaryDir data;
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("LC_ALL"), QStringLiteral("C.UTF-8"));
    environment.insert(QStringLiteral("XDG_DATA_HOME"), data.path());
    program.setProcessEnvironment(environment);
    program.setStandardInputFile(QProcess::nullDevice());
    program.setChildProcessModifier(prepare);
    program.start(QStringLiteral(CODEWHEEL_CLI), line.split(u' ', Qt::SkipEmptyParts));
    EXPECT_TRUE(program.waitForFinished(60'000)) << line.toStdString();
    EXPECT_EQ(program.exitStatus(), QProcess::NormalExit) << line.toStdString();
    return {program.exitCode(), program.readAllStandardError().toStdString()};
}

void outputToFullDisk()
{
    ::dup2(::open("/dev/full", O_WRONLY), STDOUT_FILENO); // NOLINT(*-vararg)
}

void outputClosed()
{
    ::close(STDOUT_FILENO);
}

void outputToNobody()
{
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0)
        return;
    ::dup2(ends[1], STDOUT_FILENO);
    ::close(ends[1]);
    ::close(ends[0]);
}

constexpr struct
{
    void (*make)();
    const char *reason;
} deafOutputs[] = {{outputToFullDisk, "Standard output cannot be written: No space left on device."},
                   {outputClosed, "Standard output cannot be written: Bad file descriptor."},
                   {outputToNobody, "Standard output cannot be written: Broken pipe."}};

TEST(CliOutput, ThatCannotBeWrittenIsToldByEveryCommand)
{
    for (const char *line : {"--help", "--version", "read --help", "devices", "scan",
                             "explain 00012A4F --device fraba-ocd-ib --direction in", "read 1.0", "read 05",
                             "monitor 2.0 --for 1", "monitor 05 --for 1", "cams 1.0 read", "messages",
                             "ledger", "terminal 05P", "serve esc", "scan --link esc:training --last 03"}) {
        for (const char *json : {"", " --json"}) {
            const QString called = QString::fromLatin1(line) + QString::fromLatin1(json);
            const Silenced run = startWith(called, outputToFullDisk);
            EXPECT_EQ(run.exit, 1) << called.toStdString();
            EXPECT_THAT(run.err, HasSubstr(deafOutputs[0].reason)) << called.toStdString();
        }
    }
}

TEST(CliOutput, ThatCannotBeWrittenTellsWhatWasDoneAtTheEncoder)
{
    for (const auto &output : deafOutputs) {
        for (const char *line : {"write 1.0 steps=255 --yes --json", "write 05 steps=864 --yes --json"}) {
            const Silenced run = startWith(QString::fromLatin1(line), output.make);
            EXPECT_EQ(run.exit, 1) << line;
            EXPECT_THAT(run.err, HasSubstr(output.reason)) << line;
            EXPECT_THAT(run.err, HasSubstr("This was done:")) << line;
            EXPECT_THAT(run.err, testing::ContainsRegex("steps  = (255|864)  written")) << line;
            EXPECT_THAT(run.err, HasSubstr("EEPROM writes:   ")) << line;
            EXPECT_THAT(run.err, testing::Not(HasSubstr("\\u000A"))) << line;
        }
        const Silenced typed = startWith(QStringLiteral("terminal 05GP1000 05P --yes"), output.make);
        EXPECT_EQ(typed.exit, 1);
        const bool isEndedBySignal = output.make == outputToNobody; // SIGPIPE, before it is sent
        EXPECT_THAT(typed.err, HasSubstr(isEndedBySignal ? "Nothing was written to any encoder."
                                                         : "05GP00001000 was sent, and answered."));
        EXPECT_THAT(startWith(QStringLiteral("read 05 steps"), output.make).err,
                    HasSubstr("Nothing was written to any encoder."));
    }
}

TEST(CliOutput, WhatCouldNotBeShownIsNotSent)
{
    for (const auto &output : deafOutputs) {
        for (const char *line :
             {"write 1.0 steps=255 --yes", "write 05 steps=864 --yes", "terminal 05P 05GP1000 --yes"}) {
            const Silenced run = startWith(QString::fromLatin1(line), output.make);
            EXPECT_EQ(run.exit, 1) << line;
            EXPECT_THAT(run.err, HasSubstr("Nothing was written to any encoder.")) << line;
        }
    }
}

// No signal may end the program here: the account would be lost.
TEST(CliOutput, IntoAFileThatMayNotGrowIsAFullDisk)
{
    const QTemporaryDir folder;
    const QByteArray path = folder.filePath(QStringLiteral("out")).toLocal8Bit();
    const Silenced run = startWith(QStringLiteral("devices baumer-gxp6w"), [&] {
        ::dup2(::open(path.constData(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO); // NOLINT(*-vararg)
        const rlimit little{100, 100};
        ::setrlimit(RLIMIT_FSIZE, &little);
    });
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("Standard output cannot be written: File too large."));
}

TEST(CliOutput, AClosedInputIsItsEnd)
{
    const Silenced terminal = startWith(QStringLiteral("terminal"), [] { ::close(STDIN_FILENO); });
    EXPECT_EQ(terminal.exit, 0);
    const Silenced all = startWith(QStringLiteral("terminal"), [] {
        ::close(STDIN_FILENO);
        ::close(STDOUT_FILENO);
        ::close(STDERR_FILENO);
    });
    EXPECT_EQ(all.exit, 0) << "nothing was to be told";
    const Silenced asked = startWith(QStringLiteral("write 05 steps=864"), [] { ::close(STDIN_FILENO); });
    EXPECT_EQ(asked.exit, 2);
    EXPECT_THAT(asked.err, HasSubstr("there is nobody to ask"));
}

} // namespace
} // namespace codewheel
