// SPDX-License-Identifier: GPL-3.0-or-later
// The real program serves the bus. Who uses it: a program without any of our code, python-can, and the
// program itself.
#include "tests/cli/cli_run.h"

#include <QProcess>

#include <csignal>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class ServedCan
{
public:
    explicit ServedCan(const QString &options = {})
    {
        m_program.start(QStringLiteral(CODEWHEEL_CLI),
                        QStringList{QStringLiteral("serve"), QStringLiteral("canopen")} +
                            options.split(u' ', Qt::SkipEmptyParts));
        while (!m_program.canReadLine())
            if (!m_program.waitForReadyRead(patience)) {
                ADD_FAILURE() << m_program.readAllStandardError().toStdString();
                return;
            }
        m_port = QString::fromLatin1(m_program.readLine()).trimmed();
    }
    ~ServedCan() { stop(SIGTERM); }
    ServedCan(const ServedCan &) = delete;
    ServedCan &operator=(const ServedCan &) = delete;

    void stop(int signal)
    {
        if (m_program.state() == QProcess::NotRunning)
            return;
        ::kill(static_cast<pid_t>(m_program.processId()), signal);
        EXPECT_TRUE(m_program.waitForFinished(patience));
        EXPECT_EQ(m_program.exitStatus(), QProcess::NormalExit);
        EXPECT_EQ(m_program.exitCode(), 0);
    }
    // The lines that the other program prints.
    std::vector<std::string> client(const QString &words)
    {
        return python(QStringList{m_port} + words.split(u' ', Qt::SkipEmptyParts));
    }
    std::vector<std::string> pythonCan() { return python({QStringLiteral("--python-can"), m_port}); }
    CliRun runLine(const QString &line, int rate = 125'000)
    {
        return codewheel::runLine(line + QStringLiteral(" --link slcan:%1,rate=%2").arg(m_port).arg(rate));
    }

private:
    static std::vector<std::string> python(const QStringList &words)
    {
        QProcess client;
        client.start(QStringLiteral(CODEWHEEL_DEBIAN_PYTHON),
                     QStringList{QStringLiteral(CODEWHEEL_SLCAN_CLIENT)} + words);
        EXPECT_TRUE(client.waitForFinished(patience));
        EXPECT_EQ(client.readAllStandardError(), "");
        std::vector<std::string> lines;
        for (const QByteArray &line : client.readAllStandardOutput().trimmed().split('\n'))
            lines.push_back(line.toStdString());
        return lines;
    }

    QProcess m_program;
    QString m_port;
};

TEST(CliServeCan, AnotherProgramHasAnAdapterWithTheEncodersBehindIt)
{
    ServedCan bus;
    EXPECT_THAT(bus.client(QStringLiteral("V S4 O +0.3 t60584004600000000000 +0.3 C")),
                testing::AllOf(Contains("V -> V1013"), Contains("t60584004600000000000 -> z"),
                               Contains("t58584304600088130000"), Contains("C -> ok")));
    bus.stop(SIGINT);
}

// Its cyclic timer is 100 ms; the second is that of the client.
TEST(CliServeCan, TimeIsReal)
{
    ServedCan bus;
    const auto lines = bus.client(QStringLiteral("S4 O +0.2 t00020105 +1.05 C"));
    const auto pdos =
        std::ranges::count_if(lines, [](const auto &line) { return line.starts_with("t1854"); });
    EXPECT_GE(pdos, 3); // a busy machine
    EXPECT_LE(pdos, 20);
}

TEST(CliServeCan, WhoComesNextFindsAClosedAdapter)
{
    ServedCan bus;
    EXPECT_THAT(bus.client(QStringLiteral("S4 Z1 O +0.3")), Contains("O -> ok"));
    EXPECT_THAT(bus.client(QStringLiteral("C O S4 O")),
                ElementsAre("C -> refused", "O -> refused", "S4 -> ok", "O -> ok"));
}

TEST(CliServeCan, PythonCanReadsAPosition)
{
    QProcess has;
    has.start(QStringLiteral(CODEWHEEL_DEBIAN_PYTHON), {QStringLiteral("-c"), QStringLiteral("import can")});
    if (!has.waitForFinished(patience) || has.exitCode() != 0)
        GTEST_SKIP() << "python3-can is not installed";
    ServedCan bus;
    EXPECT_THAT(bus.pythonCan(), ElementsAre("4304600088130000"));
}

TEST(CliServeCan, TheProgramItselfFindsReadsAndNumbers)
{
    ServedCan bus;
    const CliRun scan = bus.runLine(QStringLiteral("scan --ask --listen 1"));
    EXPECT_EQ(scan.exit, 0) << scan.err;
    EXPECT_THAT(scan.out, HasSubstr("can:5"));
    EXPECT_THAT(scan.out, HasSubstr("can:7"));
    EXPECT_THAT(bus.runLine(QStringLiteral("od can:5 read 6004")).out, HasSubstr("5000"));
    const CliRun node = bus.runLine(QStringLiteral("lss node 9 --yes"));
    EXPECT_EQ(node.exit, 0) << node.err;
    EXPECT_THAT(bus.runLine(QStringLiteral("read can:9 serial-number")).out, HasSubstr("1245205 (130015h)"));
    EXPECT_THAT(bus.client(QStringLiteral("S4 O t60984018100100000000 +0.3 C")), // kept for who comes next
                Contains(StartsWith("t5898431810010D010000")));
}

TEST(CliServeCan, QuirksSilentOnesAndRateAreOptions)
{
    ServedCan bus(QStringLiteral("--rate 500000 --silent 5,7 --quirk autostart,speed-off --damaged 5"));
    const CliRun scan = bus.runLine(QStringLiteral("scan --listen 1"), 500'000);
    EXPECT_THAT(scan.out, HasSubstr("can:6  operational"));
    EXPECT_THAT(scan.out, Not(HasSubstr("can:5")));
}

TEST(CliServeCan, OthersMayUseTheBusToo)
{
    ServedCan bus(QStringLiteral("--load 60 --master"));
    const QJsonObject json = bus.runLine(QStringLiteral("monitor can:6 --for 2 --json")).json();
    EXPECT_GT(json[u"figures"][u"load"].toDouble(), 0.3); // a busy machine
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("od can:6 read 6004 --json"))), "canopenOtherMaster");
}

TEST(CliServeCan, BadOptionsAreRefusedBeforeAnythingIsServed)
{
    const std::pair<const char *, const char *> rows[] = {
        {"serve canopen --slcan --interface can0", "slcanOrInterface"},
        {"serve canopen --interface nocan9", "canInterfaceMissing"},
        {"serve canopen --rate 300000", "optionNotAllowed"},
        {"serve canopen --quirk noisy", "optionNotAllowed"},
        {"serve canopen --silent 9", "optionNotAllowed"},
        {"serve canopen --lost 1001", "optionOutOfRange"},
        {"serve canopen --load 96", "optionOutOfRange"},
        {"serve canopen --echo", "optionOfOtherService"},
        {"serve esc --quirk autostart", "optionOfOtherService"},
    };
    for (const auto &[line, key] : rows) {
        const CliRun run = runLine(QString::fromLatin1(line) + QStringLiteral(" --json"));
        EXPECT_NE(run.exit, 0) << line;
        EXPECT_EQ(errorKey(run), key) << line;
    }
    EXPECT_THAT(runLine(QStringLiteral("serve canopen --quirk x")).err,
                HasSubstr("autostart, fixed-mapping"));
}

} // namespace
} // namespace codewheel
