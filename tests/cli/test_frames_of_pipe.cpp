// SPDX-License-Identifier: GPL-3.0-or-later
// The real program with a log that comes bit by bit, or to an output that takes nothing.
#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int framesPatience = 60'000; // ms

const QByteArray framesLine = "(1544106679.432583) can0 080#\n";

class CliFramesOfPipe : public testing::Test
{
protected:
    CliFramesOfPipe()
    {
        ::mkfifo(QFile::encodeName(pipe).constData(), 0600);
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("LC_ALL"), QStringLiteral("C.UTF-8"));
        program.setProcessEnvironment(environment);
    }

    void start(const QStringList &options = {})
    {
        program.start(QStringLiteral(CODEWHEEL_CLI), QStringList{QStringLiteral("frames"), pipe} + options);
        ASSERT_TRUE(program.waitForStarted(framesPatience));
    }
    void awaitOutput(const char *text)
    {
        while (!out.contains(text) && program.waitForReadyRead(framesPatience))
            out += program.readAllStandardOutput();
        ASSERT_THAT(out.toStdString(), HasSubstr(text));
    }
    void end()
    {
        ASSERT_TRUE(program.waitForFinished(framesPatience));
        out += program.readAllStandardOutput();
        err = program.readAllStandardError().toStdString();
    }
    // Opens the other end; waits until the program has opened its own.
    int writer() const { return ::open(QFile::encodeName(pipe).constData(), O_WRONLY | O_CLOEXEC); } // NOLINT
    static void put(int writer, const QByteArray &bytes)
    {
        ASSERT_EQ(::write(writer, bytes.constData(), static_cast<std::size_t>(bytes.size())), bytes.size());
    }

    QTemporaryDir folder;
    QString pipe = folder.filePath(QStringLiteral("pipe"));
    QProcess program;
    QByteArray out;
    std::string err;
};

TEST_F(CliFramesOfPipe, AreShownAsTheyComeAndCtrlCEndsTheWaiting)
{
    start();
    const int its = writer();
    put(its, framesLine + "(1544106679.5) can0 185#0");
    awaitOutput("SYNC");
    ::kill(static_cast<pid_t>(program.processId()), SIGINT);
    end();
    ::close(its);
    EXPECT_EQ(program.exitCode(), 1);
    EXPECT_THAT(err, HasSubstr("cancelled before the end of the log"));
    EXPECT_THAT(err, Not(HasSubstr("Line 2")));
    EXPECT_THAT(out.toStdString(), Not(HasSubstr("185")));
}

TEST_F(CliFramesOfPipe, NobodyWritesToCanBeEndedToo)
{
    start({QStringLiteral("--json")});
    awaitOutput("frames");
    ::kill(static_cast<pid_t>(program.processId()), SIGINT);
    end();
    EXPECT_EQ(program.exitCode(), 1);
    EXPECT_THAT(out.toStdString(), HasSubstr("framesCancelled"));
}

TEST_F(CliFramesOfPipe, EndWithItsWriterAlsoWithoutAnEndOfTheLine)
{
    start();
    const int its = writer();
    put(its, framesLine);
    awaitOutput("SYNC");
    put(its, "(1544106679.5) can0 185#00");
    ::close(its);
    end();
    EXPECT_EQ(program.exitCode(), 0) << err;
    EXPECT_THAT(out.toStdString(), HasSubstr("TPDO1"));
}

TEST_F(CliFramesOfPipe, OutputThatIsFullSaysNothingOfTheLog)
{
    QFile log(folder.filePath(QStringLiteral("log")));
    ASSERT_TRUE(log.open(QIODevice::WriteOnly));
    log.write(framesLine);
    log.close();
    pipe = log.fileName();
    program.setStandardOutputFile(QStringLiteral("/dev/full"));
    start({QStringLiteral("--json")});
    end();
    EXPECT_EQ(program.exitCode(), 1);
    EXPECT_THAT(err, HasSubstr("Standard output cannot be written: No space left on device."));
    EXPECT_THAT(err, Not(HasSubstr("no CAN frame")));
}

TEST_F(CliFramesOfPipe, NamesThatAreEmptyAreRefused)
{
    pipe.clear();
    start();
    end();
    EXPECT_EQ(program.exitCode(), 2);
    EXPECT_THAT(err, HasSubstr("Name the file of the log."));
}

TEST_F(CliFramesOfPipe, SavingUnderNoNameIsRefusedBeforeAnythingIsRead)
{
    start({QStringLiteral("--save"), QString()});
    end();
    EXPECT_EQ(program.exitCode(), 2);
    EXPECT_THAT(err, HasSubstr("Name the file to save the frames in"));
}

} // namespace
} // namespace codewheel
