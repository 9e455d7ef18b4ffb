// SPDX-License-Identifier: GPL-3.0-or-later
// The real program on real pseudo terminals: against `serve esc`, and against
// tests/kinds/esc/line/esc_peer.py, which knows nothing of this program.
#include "kinds/esc/plan/esc_line_plan.h"
#include "project/project_file.h"
#include "tests/cli/cli_run.h"
#include "tests/support/pty_pair.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>

#include <csignal>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

// A process that prints the path of a port and serves it.
class Port
{
public:
    explicit Port(const QString &program, const QStringList &arguments)
    {
        m_process.start(program, arguments);
        while (!m_process.canReadLine())
            if (!m_process.waitForReadyRead(patience)) {
                ADD_FAILURE() << m_process.readAllStandardError().toStdString();
                return;
            }
        m_path = QString::fromLocal8Bit(m_process.readLine()).trimmed();
    }
    ~Port() { unplug(); }

    QString link() const { return QStringLiteral("esc:") + m_path; }
    void unplug()
    {
        if (m_process.state() == QProcess::NotRunning)
            return;
        m_process.kill();
        EXPECT_TRUE(m_process.waitForFinished(patience));
    }

private:
    QProcess m_process;
    QString m_path;
};

Port served(const QStringList &options = {})
{
    return Port(QStringLiteral(CODEWHEEL_CLI),
                QStringList{QStringLiteral("serve"), QStringLiteral("esc")} + options);
}

Port peer(const QString &options = {})
{
    return Port(QStringLiteral(CODEWHEEL_PYTHON),
                QStringList{QStringLiteral(CODEWHEEL_ESC_PEER)} + options.split(u' ', Qt::SkipEmptyParts));
}

class Call
{
public:
    Call(const QString &line, const QString &link)
    {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("XDG_DATA_HOME"), m_data.path()); // EEPROM writes are counted there
        m_process.setProcessEnvironment(environment);
        m_process.start(QStringLiteral(CODEWHEEL_CLI), line.split(u' ', Qt::SkipEmptyParts)
                                                           << QStringLiteral("--link") << link);
    }
    Call(const QString &line, const Port &port)
        : Call(line, port.link())
    {}
    void type(const QByteArray &text) { m_process.write(text); }
    QByteArray waitForLine()
    {
        while (!m_process.canReadLine())
            if (!m_process.waitForReadyRead(patience))
                return {};
        return m_process.readLine();
    }
    void interrupt() { ::kill(static_cast<pid_t>(m_process.processId()), SIGINT); }
    bool hasEnded(int milliseconds) { return m_process.waitForFinished(milliseconds) || !isRunning(); }
    CliRun end()
    {
        m_process.closeWriteChannel();
        EXPECT_TRUE(hasEnded(patience));
        EXPECT_EQ(m_process.exitStatus(), QProcess::NormalExit);
        return {m_process.exitCode(), m_process.readAllStandardOutput().toStdString(),
                m_process.readAllStandardError().toStdString()};
    }

private:
    bool isRunning() const { return m_process.state() != QProcess::NotRunning; }

    QTemporaryDir m_data;
    QProcess m_process;
};

CliRun call(const char *line, const Port &port)
{
    return Call(QString::fromLatin1(line), port).end();
}

TEST(CliLineProgram, ScansReadsWritesAndPresetsAtAServedLine)
{
    const Port port = served();
    EXPECT_THAT(call("scan --first 02 --last 06", port).out,
                HasSubstr("05           5  19200  1234340 (12D5A4h)"));
    EXPECT_EQ(call("read 05 serial-number steps", port).out,
              "serial-number  = 1234340 (12D5A4h)\nsteps          = 8192\n");
    const CliRun written = call("write 05 steps=864 --yes", port);
    EXPECT_EQ(written.exit, 0) << written.err;
    EXPECT_THAT(written.out, HasSubstr("steps  = 864  written, and read back"));
    EXPECT_THAT(call("preset 05 1000", port).out, HasSubstr("Position after:  1000\n"));
    EXPECT_EQ(call("read 05 steps", port).out, "steps  = 864\n"); // the port keeps its encoders
}

// Two lines at two ports, with the same addresses, from the search to the arguments of a call.
TEST(CliLineProgram, AProjectLeadsToAllItsLines)
{
    const Port left = served();
    const Port right = served({QStringLiteral("--silent"), QStringLiteral("03")});
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("gate.codewheel"));
    ASSERT_EQ(Call(QStringLiteral("scan --last 05 --save ") + file, left).end().exit, 0);
    Project project = *loadProject(file);
    ASSERT_EQ(project.buses.size(), 1U);
    EscLinePlan other = *linePlan(project, firstLine);
    EXPECT_EQ(QStringLiteral("esc:") + other.settings.port, left.link());
    other.settings.port = right.link().sliced(4);
    project.buses.push_back({{4}, QStringLiteral("esc"), QStringLiteral("Right"), KindData(other)});
    project.devices.push_back(project.devices.back());
    project.devices.back().bus = {4};
    ASSERT_TRUE(saveProject(project, file));

    const auto call = [&](const char *what) {
        return Call(QString::fromLatin1(what) + QStringLiteral(" --project ") + file,
                    QStringLiteral("project"))
            .end();
    };
    EXPECT_EQ(call("read 03 serial-number").out, "serial-number  = 1234321 (12D591h)\n")
        << "planned on one of them";
    EXPECT_THAT(call("read 05 serial-number").err,
                HasSubstr("Give one of these: Line/esc:05, Right/esc:05."));
    EXPECT_EQ(call("write Right/05 steps=864 --yes").exit, 0);
    EXPECT_EQ(call("read Right/05 steps").out, "steps  = 864\n");
    EXPECT_EQ(call("read Line/05 steps").out, "steps  = 8192\n");
}

// A project with two lines at these ports; each has the encoder 03, at the station "Left" or "Right".
QString savedLines(const QTemporaryDir &folder, const QString &left, const QString &right)
{
    Project project;
    project.buses.clear();
    for (const auto &[number, port, name] : {std::tuple{2, left, "Left"}, std::tuple{4, right, "Right"}}) {
        EscLinePlan plan;
        plan.settings.port = port;
        project.buses.push_back({{number}, QStringLiteral("esc"), QString::fromLatin1(name), KindData(plan)});
        ProjectDevice device;
        device.standAt({{number}, EscLineAddress{3}.node()});
        device.participant.deviceKey = QStringLiteral("kuebler-esc-rs485");
        device.station = QString::fromLatin1(name);
        project.devices.push_back(device);
    }
    const QString file = folder.filePath(QStringLiteral("lines.codewheel"));
    EXPECT_TRUE(saveProject(project, file));
    return file;
}

// Each at its full speed, beside the other.
TEST(CliLineProgram, TwoLinesAreRecordedAtOnce)
{
    const Port left = served();
    const Port right = served();
    const QTemporaryDir folder;
    const QString project = savedLines(folder, left.link().sliced(4), right.link().sliced(4));
    const CliRun run = Call(QStringLiteral("record --for 2 --json -o %1 --project %2")
                                .arg(folder.filePath(QStringLiteral("lines.cwrec")), project),
                            QStringLiteral("project"))
                           .end();
    EXPECT_EQ(run.exit, 0) << run.err;
    const QJsonArray encoders = run.json()[u"encoders"].toArray();
    ASSERT_EQ(encoders.size(), 2);
    EXPECT_EQ(encoders[0][u"key"], QStringLiteral("esc:03"));
    EXPECT_EQ(encoders[1][u"key"], QStringLiteral("4/esc:03"));
    for (const QJsonValue encoder : encoders)
        EXPECT_GT(QDateTime::fromString(encoder[u"from"].toString(), Qt::ISODateWithMs)
                      .msecsTo(QDateTime::fromString(encoder[u"to"].toString(), Qt::ISODateWithMs)),
                  1'000);
}

TEST(CliLineProgram, APortIsThatOfTheProjectByAnyOfItsNames)
{
    const Port port = peer();
    const QTemporaryDir folder;
    const QString byId = folder.filePath(QStringLiteral("usb-FTDI"));
    ASSERT_TRUE(QFile::link(port.link().sliced(4), byId));
    const QString project = savedLines(folder, byId, folder.filePath(QStringLiteral("none")));
    const CliRun same =
        Call(QStringLiteral("read Left serial-number --json --project ") + project, port.link()).end();
    EXPECT_EQ(same.exit, 0) << same.err;
    EXPECT_EQ(same.json()[u"busName"], QStringLiteral("Left"));
    EXPECT_EQ(same.err, "");
    const Port other = peer();
    const CliRun foreign =
        Call(QStringLiteral("read 03 serial-number --project ") + project, other.link()).end();
    EXPECT_EQ(foreign.exit, 0);
    EXPECT_THAT(foreign.err, HasSubstr("No bus of the project is at " + other.link().toStdString()));
}

TEST(CliLineProgram, TwoBusesAtOnePortAreToldAsSuch)
{
    const Port port = peer();
    const QTemporaryDir folder;
    const QString path = port.link().sliced(4);
    const CliRun scan = Call(QStringLiteral("scan --last 03 --project ") + savedLines(folder, path, path),
                             QStringLiteral("project"))
                            .end();
    EXPECT_EQ(scan.exit, 1);
    EXPECT_THAT(scan.out, HasSubstr("is in use: the project gives it to the bus \"Left\" too."));
    EXPECT_THAT(scan.out + scan.err, testing::Not(HasSubstr("another program")));
}

TEST(CliLineProgram, ASerialNumberThatWasTypedWrongIsToldAsSuch)
{
    const Port port = peer();
    const QTemporaryDir folder;
    const QString project =
        savedLines(folder, port.link().sliced(4), folder.filePath(QStringLiteral("none")));
    const CliRun run =
        Call(QStringLiteral("replace Left --serial 99 --yes --project ") + project, port.link()).end();
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("correct --serial"));
    EXPECT_EQ(run.out, "");
}

TEST(CliLineProgram, OfAnEncoderThatAnswersLateTheTimeOutIsTold)
{
    const Port port = peer(QStringLiteral("--delay 130"));
    const CliRun run = call("read 05 serial-number", port);
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("time-out=500"));
    EXPECT_EQ(Call(QStringLiteral("read 05 serial-number"), port.link() + QStringLiteral(",time-out=500"))
                  .end()
                  .exit,
              0);
}

TEST(CliLineProgram, UnderstandsAPeerThatSharesNoCodeWithIt)
{
    const Port port = peer(QStringLiteral("--garbage 3 --echo"));
    EXPECT_THAT(call("read 05 serial-number warnings", port).out,
                HasSubstr("serial-number  = 1234181 (12D505h)\nwarnings       = 8000h (standstill)\n"));
    EXPECT_THAT(call("preset 05 5200h", port).out,
                HasSubstr("Position before: 4661\nPosition after:  20992\n"));
    EXPECT_THAT(call("terminal 05P 03V --json", port).out,
                HasSubstr("\"version\":\"5882 PEER FOR TESTS V1.00\""));
}

// 1300h is close enough to 1235h for the shaft to have turned there.
TEST(CliLineProgram, APresetThatIsAcknowledgedAndNotDoneIsNoSuccess)
{
    const Port port = peer(QStringLiteral("--ignores GP"));
    const CliRun run = call("preset 05 1300h", port);
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("Preset was written as 4864 but read back as 1."));
}

TEST(CliLineProgram, ATerminalTakesLinesAsTheyAreTyped)
{
    const Port port = peer();
    Call terminal(QStringLiteral("terminal"), port);
    terminal.type("05P\n");
    EXPECT_THAT(terminal.waitForLine().toStdString(), HasSubstr("05: position?"));
    EXPECT_THAT(terminal.waitForLine().toStdString(), HasSubstr("1235h = 4661"));
    terminal.type("05U\n");
    EXPECT_THAT(terminal.waitForLine().toStdString(), HasSubstr("05: number of revolutions?"));
    EXPECT_EQ(terminal.end().exit, 0);
}

TEST(CliLineProgram, APortThatIsNotThereOrTakenIsSaid)
{
    const CliRun none = Call(QStringLiteral("scan"), QStringLiteral("esc:/dev/there-is-none")).end();
    EXPECT_EQ(none.exit, 1);
    EXPECT_THAT(none.err, HasSubstr("There is no serial port /dev/there-is-none."));

    const Port port = peer();
    Call first(QStringLiteral("terminal"), port);
    first.type("05P\n");
    first.waitForLine();
    const CliRun second = call("read 05", port);
    EXPECT_EQ(second.exit, 1);
    EXPECT_THAT(second.err, HasSubstr("is in use by the program codewheel-cli (process "));
    EXPECT_THAT(second.err, HasSubstr("\n    kill ")) << "a command to copy";
    EXPECT_EQ(first.end().exit, 0);
}

TEST(CliLineProgram, AnAdapterThatIsUnpluggedEndsTheCall)
{
    Port port = peer();
    Call monitor(QStringLiteral("monitor 05 --for 600 --every 10"), port);
    monitor.waitForLine();
    monitor.waitForLine();
    port.unplug();
    const CliRun run = monitor.end();
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("is gone: the adapter was unplugged"));
}

TEST(CliLineProgram, UnderAFloodItIsSaidThatBytesComeThatAreNoAnswers)
{
    PtyPair line;
    Call read(QStringLiteral("read 05 --json"), QStringLiteral("esc:") + line.path());
    while (!read.hasEnded(10))
        line.send(QByteArray(32, 'U'));
    const CliRun run = read.end();
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "noAnswerAmongBytes");
}

// Nobody answers, so the search would take its time.
TEST(CliLineProgram, CtrlCEndsASearchWithWhatWasFound)
{
    PtyPair line;
    Call search(QStringLiteral("scan --all-rates --json"), QStringLiteral("esc:") + line.path());
    EXPECT_EQ(line.receive(6), "\x1B" + QByteArray("01N\r\n"));
    search.interrupt();
    const CliRun run = search.end();
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "scanCancelled");
}

} // namespace
} // namespace codewheel
