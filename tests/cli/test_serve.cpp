// SPDX-License-Identifier: GPL-3.0-or-later
// The real program serves the line; this test is the other program, with none of our core code between it and
// the terminal.
#include "tests/cli/cli_run.h"

#include <QFile>
#include <QProcess>

#include <array>
#include <csignal>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

class Serve : public testing::Test
{
protected:
    ~Serve() override
    {
        if (m_port >= 0)
            ::close(m_port);
        if (m_program.state() != QProcess::NotRunning)
            stop(SIGTERM);
    }

    void start(const QString &options = {})
    {
        m_program.start(QStringLiteral(CODEWHEEL_CLI),
                        QStringList{QStringLiteral("serve"), QStringLiteral("esc")} +
                            options.split(u' ', Qt::SkipEmptyParts));
        while (!m_program.canReadLine())
            ASSERT_TRUE(m_program.waitForReadyRead(60'000)) << m_program.readAllStandardError().toStdString();
        const QByteArray path = m_program.readLine().trimmed();
        m_port = ::open(path.constData(), O_RDWR | O_NOCTTY | O_CLOEXEC); // NOLINT(*-vararg)
        ASSERT_GE(m_port, 0) << path.toStdString();
    }
    void setRate(speed_t rate)
    {
        termios settings = {};
        ASSERT_EQ(::tcgetattr(m_port, &settings), 0);
        ASSERT_EQ(::cfsetspeed(&settings, rate), 0);
        ASSERT_EQ(::tcsetattr(m_port, TCSANOW, &settings), 0);
    }
    void sendBytes(const QByteArray &bytes)
    {
        ASSERT_EQ(::write(m_port, bytes.constData(), static_cast<std::size_t>(bytes.size())), bytes.size());
    }
    void send(const char *text) { sendBytes("\x1B" + QByteArray(text) + "\r\n"); }
    QByteArray receive(qsizetype count)
    {
        QByteArray received;
        pollfd port{m_port, POLLIN, 0};
        while (received.size() < count && ::poll(&port, 1, patience) == 1) {
            std::array<char, 64> bytes{};
            const auto got = ::read(m_port, bytes.data(), bytes.size());
            if (got <= 0)
                break;
            received.append(bytes.data(), got);
        }
        return received;
    }
    QByteArray ask(const char *text, qsizetype count)
    {
        send(text);
        return receive(count);
    }
    void stop(int signal)
    {
        ::kill(static_cast<pid_t>(m_program.processId()), signal);
        EXPECT_TRUE(m_program.waitForFinished(60'000));
        EXPECT_EQ(m_program.exitStatus(), QProcess::NormalExit);
        EXPECT_EQ(m_program.exitCode(), 0);
    }

    QProcess m_program;
    int m_port = -1;
};

TEST_F(Serve, AnswersAsTheEncodersDo)
{
    start();
    EXPECT_EQ(ask("05P", 12), "\r\n00001235\r\n");
    EXPECT_EQ(ask("03D", 8), "\r\n2000\r\n");
    EXPECT_EQ(ask("12GP00005200", 2), "\r\n");
    EXPECT_EQ(ask("05Q", 4), "03\r\n");
    stop(SIGINT);
}

TEST_F(Serve, KeepsWhatItsEncodersHaveForTheNextProgram)
{
    start();
    EXPECT_EQ(ask("05GP00005200", 2), "\r\n");
    const QByteArray name(::ttyname(m_port));
    ::close(m_port);
    m_port = ::open(name.constData(), O_RDWR | O_NOCTTY | O_CLOEXEC); // NOLINT(*-vararg)
    EXPECT_EQ(ask("05P", 12), "\r\n00005200\r\n");
}

// Megabytes of nonsense, much faster than the line can carry.
TEST_F(Serve, AFloodIsBoundedAndTheNextProgramIsServedAtOnce)
{
    start();
    EXPECT_EQ(ask("05P", 12), "\r\n00001235\r\n");
    const auto memory = [&] { // pages
        QFile file(QStringLiteral("/proc/%1/statm").arg(m_program.processId()));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll().split(' ').at(1).toLongLong();
    };
    const qint64 before = memory();
    const QByteArray rubbish(4'096, 'U');
    for (int i = 0; i < 1'000; ++i)
        sendBytes(rubbish);
    EXPECT_LT(memory() - before, 4'000) << "16 MB; what is freed stays for a while under AddressSanitizer";

    const QByteArray name(::ttyname(m_port));
    ::close(m_port);
    m_port = ::open(name.constData(), O_RDWR | O_NOCTTY | O_CLOEXEC); // NOLINT(*-vararg)
    QByteArray answer;
    for (int asked = 0; asked < 20 && answer.isEmpty(); ++asked) {
        send("05P");
        pollfd port{m_port, POLLIN, 0};
        if (::poll(&port, 1, 1'000) == 1)
            answer = receive(12);
    }
    EXPECT_EQ(answer, "\r\n00001235\r\n");
}

TEST_F(Serve, WhatWasNotFetchedIsNotForTheNextProgram)
{
    start();
    send("05P");
    pollfd port{m_port, POLLIN, 0};
    ASSERT_EQ(::poll(&port, 1, 60'000), 1);
    const QByteArray name(::ttyname(m_port));
    ::close(m_port);
    for (bool isEmpty = false; !isEmpty;) {                               // takes effect shortly
        m_port = ::open(name.constData(), O_RDWR | O_NOCTTY | O_CLOEXEC); // NOLINT(*-vararg)
        port.fd = m_port;
        isEmpty = ::poll(&port, 1, 100) == 0;
        if (!isEmpty)
            ::close(m_port);
    }
    EXPECT_EQ(ask("05U", 8), "\r\n1000\r\n");
}

TEST_F(Serve, TheBaudRateIsThatOfTheTerminal)
{
    start();
    EXPECT_EQ(ask("05Y1", 2), "\r\n");
    send("05P"); // at 19200: nobody understands
    EXPECT_EQ(ask("12U", 8), "\r\n1000\r\n");
    setRate(B9600);
    EXPECT_EQ(ask("05P", 12), "\r\n00001235\r\n");
}

TEST_F(Serve, FaultsAreSetByOptions)
{
    start(QStringLiteral("--echo --silent 03,12 --answer-delay 1"));
    EXPECT_EQ(ask("05P", 18), "\x1B"
                              "05P\r\n\r\n00001235\r\n");
    EXPECT_EQ(ask("12P", 6), "\x1B"
                             "12P\r\n");
    EXPECT_EQ(ask("05U", 14), "\x1B"
                              "05U\r\n\r\n1000\r\n");
    stop(SIGTERM);
}

TEST_F(Serve, BytesAreDamagedAsOftenAsItWasTold)
{
    start(QStringLiteral("--doubled 1000 --echo --delayed 1 --delay 1 --lost 0 --corrupted 0 --seed 3"));
    sendBytes("05P");
    EXPECT_EQ(receive(6), "0055PP");
}

TEST(CliServe, BadOptionsAreRefusedBeforeAnythingIsServed)
{
    const std::pair<const char *, const char *> rows[] = {
        {"serve", "missingArgument"},
        {"serve k3", "unknownService"},
        {"serve esc --lost 1001", "optionOutOfRange"},
        {"serve esc --delay 0", "optionOutOfRange"},
        {"serve esc --silent 04", "optionNotAllowed"},
        {"serve esc --silent x", "optionNotAllowed"},
        {"serve esc --noise 1", "unknownOption"},
    };
    for (const auto &[line, key] : rows) {
        const CliRun run = runLine(QString::fromLatin1(line) + QStringLiteral(" --json"));
        EXPECT_EQ(run.exit, 2) << line;
        EXPECT_EQ(errorKey(run), key) << line;
    }
    EXPECT_THAT(runLine(QStringLiteral("serve esc --silent 04")).err,
                HasSubstr("Allowed are: 03, 05, 12, all"));
}

} // namespace
} // namespace codewheel
