// SPDX-License-Identifier: GPL-3.0-or-later
// The real program offers rings; its clients are mbpoll and pymodbus, which share no code with it.
#include "kinds/interbus/plan/ring_plan.h"
#include "project/project_file.h"
#include "tests/cli/cli_run.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QTemporaryDir>

#include <csignal>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

constexpr int longestWait = 60'000; // ms

class ServeModbus : public testing::Test
{
protected:
    ~ServeModbus() override
    {
        if (m_program.state() != QProcess::NotRunning)
            end();
    }

    void start(const QString &options)
    {
        m_program.start(QStringLiteral(CODEWHEEL_CLI),
                        QStringList{QStringLiteral("serve")} + options.split(u' ', Qt::SkipEmptyParts));
        m_offer = line();
        ASSERT_FALSE(m_offer.isEmpty()) << m_program.readAllStandardError().toStdString();
    }
    QString line()
    {
        while (!m_program.canReadLine())
            if (!m_program.waitForReadyRead(longestWait))
                return {};
        return QString::fromUtf8(m_program.readLine()).trimmed();
    }
    // The next line that has this in it; what comes before it is passed over.
    std::string lineWith(const QString &text)
    {
        for (QString next = line(); !next.isEmpty(); next = line())
            if (next.contains(text))
                return next.toStdString();
        return "there is none";
    }
    CliRun end()
    {
        ::kill(static_cast<pid_t>(m_program.processId()), SIGINT);
        EXPECT_TRUE(m_program.waitForFinished(longestWait));
        EXPECT_EQ(m_program.exitStatus(), QProcess::NormalExit);
        return {m_program.exitCode(), m_program.readAllStandardOutput().toStdString(),
                m_program.readAllStandardError().toStdString()};
    }
    QString port() const { return m_offer.section(u':', -1); }

    CliRun client(const QString &program, const QStringList &arguments)
    {
        QProcess process;
        process.start(program, arguments);
        EXPECT_TRUE(process.waitForFinished(longestWait)) << process.errorString().toStdString();
        return {process.exitCode(), process.readAllStandardOutput().toStdString(),
                process.readAllStandardError().toStdString()};
    }
    // mbpoll, once; `what` are its options and, behind " -- ", the values to write.
    CliRun poll(const QString &what)
    {
        const QStringList parts = what.split(QStringLiteral(" -- "));
        const bool isTcp = !m_offer.startsWith(u'/');
        QStringList arguments{QStringLiteral("-0"), QStringLiteral("-1"), QStringLiteral("-o"),
                              QStringLiteral("9.9")};
        arguments +=
            isTcp ? QStringList{QStringLiteral("-m"), QStringLiteral("tcp"), QStringLiteral("-p"), port()}
                  : QStringList{QStringLiteral("-m"),    QStringLiteral("rtu"), QStringLiteral("-b"),
                                QStringLiteral("19200"), QStringLiteral("-P"),  QStringLiteral("even")};
        arguments += parts.first().split(u' ');
        arguments << (isTcp ? QStringLiteral("127.0.0.1") : m_offer);
        if (parts.size() > 1)
            arguments += parts.last().split(u' ');
        return client(QStringLiteral(CODEWHEEL_MBPOLL), arguments);
    }
    CliRun pymodbus(const QStringList &arguments)
    {
        return client(QStringLiteral(CODEWHEEL_DEBIAN_PYTHON),
                      QStringList{QStringLiteral(CODEWHEEL_MODBUS_CLIENT)} + arguments);
    }

    QProcess m_program;
    QString m_offer; // what it printed first: ADDRESS:PORT, or the path of a port
};

TEST_F(ServeModbus, AnyClientReadsAndWritesTheTrainingRing)
{
    start(QStringLiteral("modbus-tcp --port 0"));
    EXPECT_THAT(m_offer.toStdString(), testing::StartsWith("127.0.0.1:"));
    EXPECT_EQ(lineWith(QStringLiteral("LA-66")), "5.0    7, 8       4103, 4104   4, 5          TR LA-66");
    EXPECT_THAT(poll(QStringLiteral("-a 1 -r 8192 -c 2 -t 3:hex")).out, HasSubstr("0x00E0"));
    EXPECT_EQ(poll(QStringLiteral("-a 1 -r 0 -t 4 -- 512 255")).exit, 0);
    EXPECT_THAT(poll(QStringLiteral("-a 99 -r 0 -c 2 -t 4")).out, HasSubstr("512"))
        << "one ring for all units";
    EXPECT_EQ(pymodbus({QStringLiteral("tcp"), QStringLiteral("127.0.0.1"), port(), QStringLiteral("1")}).err,
              "");
    const CliRun ended = end();
    EXPECT_EQ(ended.exit, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr(" is connected.\n"));
    EXPECT_THAT(ended.out, HasSubstr(" has left: 1 requests, 0 of them refused; 1 writes.\n"));
    EXPECT_THAT(ended.out, HasSubstr(" has left: 1 requests, 0 of them refused; 0 writes.\n"));
    EXPECT_THAT(ended.out, HasSubstr(" has left: 14 requests, 4 of them refused; 3 writes.\n"));
    EXPECT_THAT(ended.out, HasSubstr("Clients: 4, and 0 that were refused."));
}

TEST_F(ServeModbus, ASerialClientIsServedAtAPseudoTerminal)
{
    start(QStringLiteral("modbus-rtu --json"));
    EXPECT_EQ(poll(QStringLiteral("-a 1 -r 0 -t 4 -- 512 255")).exit, 0);
    EXPECT_THAT(poll(QStringLiteral("-a 1 -r 0 -c 2 -t 4")).out, HasSubstr("512"));
    const CliRun python = pymodbus({QStringLiteral("rtu"), m_offer, QStringLiteral("1")});
    EXPECT_EQ(python.exit, 0) << python.err;
    const CliRun ended = end();
    EXPECT_EQ(ended.json()[u"clients"], 1);
    EXPECT_EQ(ended.json()[u"writes"], 4) << "what stood there already is none";
    EXPECT_EQ(ended.json()[u"port"], m_offer);
}

TEST_F(ServeModbus, EachSeatHasARingOfItsOwn)
{
    start(QStringLiteral("modbus-tcp --port 0 --seats 3"));
    EXPECT_EQ(poll(QStringLiteral("-a 1 -r 0 -t 4 -- 11 0")).exit, 0);
    EXPECT_EQ(poll(QStringLiteral("-a 3 -r 0 -t 4 -- 33 0")).exit, 0);
    EXPECT_THAT(poll(QStringLiteral("-a 1 -r 0 -c 1 -t 4")).out, HasSubstr("\t11"));
    EXPECT_THAT(poll(QStringLiteral("-a 2 -r 0 -c 1 -t 4")).out, HasSubstr("\t0"));
    EXPECT_THAT(poll(QStringLiteral("-a 3 -r 0 -c 1 -t 4")).out, HasSubstr("\t33"));
    EXPECT_THAT(poll(QStringLiteral("-a 4 -r 0 -c 1 -t 4")).err,
                HasSubstr("Target device failed to respond"));
}

TEST_F(ServeModbus, ReadOnlyNothingIsWritten)
{
    start(QStringLiteral("modbus-tcp --port 0 --read-only --json"));
    EXPECT_THAT(poll(QStringLiteral("-a 1 -r 0 -t 4 -- 11 0")).err, HasSubstr("Illegal function"));
    EXPECT_THAT(poll(QStringLiteral("-a 1 -r 0 -c 1 -t 4")).out, HasSubstr("\t0"));
    const CliRun ended = end();
    EXPECT_EQ(ended.json()[u"writes"], 0);
    EXPECT_EQ(ended.json()[u"refusedRequests"], 1);
}

// A drive between two K3, which the training ring does not have.
TEST_F(ServeModbus, TheRingOfAProjectIsSimulated)
{
    const QTemporaryDir folder;
    Project project;
    for (const auto &[place, code, key] :
         {std::tuple{"1.0", 0x0237U, "fraba-ocd-ib"}, std::tuple{"2.0", 0x0203U, ""},
          std::tuple{"3.0", 0x0237U, "baumer-gxp6w"}}) {
        ProjectDevice device;
        device.participant = RingDevice{.number = NodeId(place),
                                        .deviceCode = code,
                                        .inWords = 2,
                                        .outWords = 2,
                                        .deviceKey = QString::fromLatin1(key)};
        project.devices.push_back(device);
    }
    const QString file = folder.filePath(QStringLiteral("crane.codewheel"));
    ASSERT_TRUE(saveProject(project, file));
    start(QStringLiteral("modbus-tcp --port 0 --json --project ") + file);
    EXPECT_EQ(poll(QStringLiteral("-a 1 -r 2 -t 4 -- 4660 22136")).exit, 0);
    EXPECT_THAT(poll(QStringLiteral("-a 1 -r 2 -c 2 -t 3:hex")).out, HasSubstr("0x1234"));
    const QJsonArray registers = end().json()[u"rings"].toArray().at(0)[u"registers"].toArray();
    ASSERT_EQ(registers.size(), 3);
    EXPECT_EQ(registers[2][u"place"], QStringLiteral("3.0"));
    EXPECT_EQ(registers[2][u"in"], 4);

    RingPlan real;
    real.link.kind = QStringLiteral("modbus-tcp");
    setRingPlan(project, firstBus, real);
    ASSERT_TRUE(saveProject(project, file));
    const CliRun refused = runLine(QStringLiteral("serve modbus-tcp --json --project ") + file);
    EXPECT_EQ(refused.exit, 2);
    EXPECT_EQ(errorKey(refused), "nothingToServe");
}

// The wire before 2.0 is broken from the beginning: no data cycle is possible.
TEST_F(ServeModbus, TheFaultsOfAPlanHappen)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("plan.json"));
    QFile plan(file);
    ASSERT_TRUE(plan.open(QIODevice::WriteOnly));
    plan.write(R"({"format": "codewheel-faults", "version": 1, "title": "Broken", "steps": [
                   {"at": 0, "fault": "wireBreak", "place": "2.0"}]})");
    plan.close();
    start(QStringLiteral("modbus-tcp --port 0 --fault-plan ") + file);
    std::string refused;
    while (refused.empty()) // the fault comes with one of the first cycles
        refused = poll(QStringLiteral("-a 1 -r 0 -t 4 -- 1 1")).err;
    EXPECT_THAT(refused, HasSubstr("Slave device or server failure"));
}

TEST_F(ServeModbus, SeveralRingsOfAProjectAreUnits)
{
    const QTemporaryDir folder;
    Project project;
    for (const int ring : {1, 7}) {
        ProjectDevice device;
        device.bus = {ring};
        device.participant = RingDevice{
            .number = NodeId("1.0"), .deviceCode = 0x0203, .inWords = 2, .outWords = 2, .deviceKey = {}};
        project.devices.push_back(device);
    }
    setRingPlan(project, {7}, {});
    findBus(project, {7})->name = QStringLiteral("Gate");
    const QString file = folder.filePath(QStringLiteral("two.codewheel"));
    ASSERT_TRUE(saveProject(project, file));
    const QString serve = QStringLiteral("modbus-tcp --port 0 --project ") + file;
    EXPECT_EQ(errorKey(runLine(QStringLiteral("serve --json --seats 2 ") + serve)), "seatsOfSeveralRings");
    const CliRun unclear =
        runLine(QStringLiteral("serve --json --fault-plan resources/examples/faults.json ") + serve);
    EXPECT_EQ(errorKey(unclear), "faultPlanOfSeveralRings");
    EXPECT_THAT(unclear.err, HasSubstr("Gate"));
    start(serve);
    EXPECT_THAT(lineWith(QStringLiteral("Unit 2")), HasSubstr("Gate"));
    EXPECT_EQ(poll(QStringLiteral("-a 2 -r 0 -t 4 -- 22 0")).exit, 0);
    EXPECT_THAT(poll(QStringLiteral("-a 1 -r 0 -c 1 -t 4")).out, HasSubstr("\t0"));
    EXPECT_THAT(poll(QStringLiteral("-a 2 -r 0 -c 1 -t 4")).out, HasSubstr("\t22"));
}

TEST_F(ServeModbus, APortThatIsTakenIsSaid)
{
    start(QStringLiteral("modbus-tcp --port 0"));
    const CliRun second = runLine(QStringLiteral("serve modbus-tcp --json --port ") + port());
    EXPECT_EQ(second.exit, 1);
    EXPECT_EQ(errorKey(second), "serverPortTaken");
    EXPECT_THAT(second.err, HasSubstr("is used by another program"));
}

TEST(CliServeModbus, BadOptionsAreRefusedBeforeAnythingIsServed)
{
    const std::pair<const char *, const char *> rows[] = {
        {"serve modbus-tcp --port 65536", "optionOutOfRange"},
        {"serve modbus-tcp --port ttyUSB0", "optionOutOfRange"},
        {"serve modbus-tcp --seats 0", "optionOutOfRange"},
        {"serve modbus-tcp --lost 5", "optionOfOtherService"},
        {"serve modbus-rtu --address 0.0.0.0", "optionOfOtherService"},
        {"serve esc --port 7", "optionOfOtherService"},
        {"serve modbus-rtu --port ttyS0,baud=1", "linkSettingWrong"},
        {"serve modbus-rtu --port ,wings=2", "linkSettingUnknown"},
        {"serve modbus-tcp --fault-plan /there/is/none", "fileNotReadable"},
    };
    for (const auto &[line, key] : rows) {
        const CliRun run = runLine(QString::fromLatin1(line) + QStringLiteral(" --json"));
        EXPECT_EQ(run.exit, 2) << line;
        EXPECT_EQ(errorKey(run), key) << line;
    }
    const CliRun none = runLine(QStringLiteral("serve modbus-rtu --port /dev/there-is-none --json"));
    EXPECT_EQ(none.exit, 1);
    EXPECT_EQ(errorKey(none), "portNotFound");
    const CliRun address = runLine(QStringLiteral("serve modbus-tcp --port 0 --address 192.0.2.77 --json"));
    EXPECT_EQ(address.exit, 1);
    EXPECT_EQ(errorKey(address), "serverAddressNotOurs");
}

} // namespace
} // namespace codewheel
