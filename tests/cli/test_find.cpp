// SPDX-License-Identifier: GPL-3.0-or-later
// Against tests/kinds/esc/line/esc_peer.py and a pymodbus server, which know nothing of this program.
#include "cli/call/command_line.h"
#include "cli/call/stop_signals.h"
#include "tests/cli/cli_run.h"
#include "tests/cli/kinds/interbus/gateway_peer.h"
#include "tests/support/pty_pair.h"
#include "vocabulary/shown_text.h"

#include <QFile>
#include <QJsonArray>
#include <QProcess>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <thread>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::Not;

class EscPeerOnLine
{
public:
    // "--addresses 12 --echo"
    explicit EscPeerOnLine(const QString &options)
    {
        m_peer.start(QStringLiteral(CODEWHEEL_PYTHON),
                     QStringList{QStringLiteral(CODEWHEEL_ESC_PEER)} + options.split(u' '));
        while (!m_peer.canReadLine() && m_peer.waitForReadyRead(60'000))
            ;
        m_port = QString::fromLocal8Bit(m_peer.readLine()).trimmed();
        EXPECT_FALSE(m_port.isEmpty());
    }
    ~EscPeerOnLine()
    {
        m_peer.closeWriteChannel();
        EXPECT_TRUE(m_peer.waitForFinished(60'000));
    }
    EscPeerOnLine(const EscPeerOnLine &) = delete;
    EscPeerOnLine &operator=(const EscPeerOnLine &) = delete;

    QString port() const { return m_port; }

private:
    QProcess m_peer;
    QString m_port;
};

bool wasSentAnything(const PtyPair &pty)
{
    pollfd waiting{pty.descriptor(), POLLIN, 0};
    return ::poll(&waiting, 1, 0) > 0;
}

TEST(FindCommand, FindsTheEncoderOfALineAndTheLinkThatLeadsThere)
{
    const EscPeerOnLine peer(QStringLiteral("--addresses 12"));
    const CliRun run = runLine(QStringLiteral("find --yes --json ") + peer.port());
    EXPECT_EQ(run.exit, 0) << run.err;
    const QJsonArray found = run.json()[u"found"].toArray();
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found[0][u"kind"].toString(), QStringLiteral("esc"));
    EXPECT_EQ(found[0][u"certainty"].toString(), QStringLiteral("certain"));
    EXPECT_THAT(found[0][u"text"].toString().toStdString(), HasSubstr("12h (18)"));
    const QString link = found[0][u"link"].toString();
    EXPECT_EQ(link, QStringLiteral("esc:%1,baud=19200").arg(peer.port()));
    EXPECT_EQ(runLine(QStringLiteral("read 12 --link ") + link).exit, 0) << "the link is right";
}

// What the adapter hears of itself is not taken for somebody else.
TEST(FindCommand, FindsAnEncoderBehindAnAdapterThatEchoes)
{
    const EscPeerOnLine peer(QStringLiteral("--addresses 12 --echo"));
    const CliRun run = runLine(QStringLiteral("find --yes --json ") + peer.port());
    EXPECT_EQ(run.exit, 0) << run.err;
    const QJsonArray found = run.json()[u"found"].toArray();
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found[0][u"link"].toString(), QStringLiteral("esc:%1,baud=19200").arg(peer.port()));
    EXPECT_EQ(found[0][u"certainty"].toString(), QStringLiteral("certain"));
    EXPECT_FALSE(found[0][u"masterAtWork"].toBool());
    EXPECT_THAT(run.out + run.err, Not(HasSubstr("A master")));
}

// At the others, stray bytes come: no more than when a line changes its direction.
TEST(FindCommand, FindsAnEncoderAtTheRateThatItHas)
{
    const EscPeerOnLine peer(QStringLiteral("--addresses 05 --baud 9600 --stray 2"));
    const CliRun run = runLine(QStringLiteral("find --yes --json ") + peer.port());
    EXPECT_EQ(run.exit, 0) << run.err;
    const QJsonArray found = run.json()[u"found"].toArray();
    ASSERT_EQ(found.size(), 1);
    const QString link = found[0][u"link"].toString();
    EXPECT_EQ(link, QStringLiteral("esc:%1,baud=9600").arg(peer.port()));
    EXPECT_FALSE(found[0][u"masterAtWork"].toBool());
    EXPECT_EQ(runLine(QStringLiteral("read 05 --link ") + link).exit, 0) << "the rate is right";
    EXPECT_EQ(runLine(QStringLiteral("read 05 --link esc:%1,baud=19200").arg(peer.port())).exit, 1);
}

// Somebody answers there, but nobody who makes sense: the other rates are still asked at.
TEST(FindCommand, FindsAnEncoderThoughGarbageComesAtAnotherRate)
{
    const EscPeerOnLine peer(QStringLiteral("--addresses 05 --baud 9600 --stray 12"));
    const QJsonArray found =
        runLine(QStringLiteral("find --yes --json ") + peer.port()).json()[u"found"].toArray();
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found[0][u"link"].toString(), QStringLiteral("esc:%1,baud=9600").arg(peer.port()));
}

TEST(FindCommand, FindsAGatewayOnASerialLine)
{
    GatewayPeer peer(QStringLiteral("--rtu"));
    const CliRun run = runLine(QStringLiteral("find --yes --json ") + peer.where());
    EXPECT_EQ(run.exit, 0) << run.err;
    const QJsonArray found = run.json()[u"found"].toArray();
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found[0][u"kind"].toString(), QStringLiteral("interbus"));
    EXPECT_FALSE(found[0][u"masterAtWork"].toBool());
    const QString link = found[0][u"link"].toString();
    EXPECT_EQ(link, peer.link());
    EXPECT_EQ(peer.writes(), 0);
    const RingProject ring;
    EXPECT_EQ(ring.run(QStringLiteral("monitor 1.0 --for 1"), link).exit, 0) << "the link is right";
}

TEST(FindCommand, SendsNothingUnlessThatIsAgreedTo)
{
    const PtyPair pty;
    const CliRun run = runLine(QStringLiteral("find ") + pty.path());
    EXPECT_EQ(run.exit, 2);
    EXPECT_THAT(run.out, HasSubstr("The line is silent."));
    EXPECT_THAT(run.out, HasSubstr("Only reads are sent:\nKübler ESC: "));
    EXPECT_THAT(run.err, HasSubstr("Add --yes to ask"));
    const CliRun declined = runLine(QStringLiteral("find ") + pty.path(), {.isThere = true, .types = "no\n"});
    EXPECT_EQ(declined.exit, 2);
    const CliRun listening = runLine(QStringLiteral("find --listen --json ") + pty.path());
    EXPECT_EQ(listening.exit, 1);
    EXPECT_EQ(errorKey(listening), "nobodyFound");
    EXPECT_FALSE(wasSentAnything(pty));
}

TEST(FindCommand, LeavesALineAloneOnWhichAMasterWorks)
{
    PtyPair pty;
    std::jthread master([&pty](const std::stop_token &stop) {
        while (!stop.stop_requested()) {
            pty.send("\x1B"
                     "05P\r\n\r\n00001235\r\n");
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
    });
    const CliRun run = runLine(QStringLiteral("find --yes --json ") + pty.path());
    master.request_stop();
    master.join();
    EXPECT_EQ(run.exit, 0);
    const QJsonArray found = run.json()[u"found"].toArray();
    ASSERT_EQ(found.size(), 1);
    EXPECT_TRUE(found[0][u"masterAtWork"].toBool());
    EXPECT_FALSE(wasSentAnything(pty));
}

// Sends, at a port whose path is a symbolic link of this name.
class MasterAtLink
{
public:
    explicit MasterAtLink(const QString &name)
        : m_path(m_folder.filePath(name))
    {
        QFile::link(m_pty.path(), m_path);
    }
    QString path() const { return m_path; }

private:
    QTemporaryDir m_folder;
    QString m_path;
    PtyPair m_pty;
    std::jthread m_master{[this](const std::stop_token &stop) {
        while (!stop.stop_requested()) {
            m_pty.send("\x1B"
                       "05P\r\n\r\n00001235\r\n");
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
    }};
};

TEST(FindCommand, SaysThatALinkCannotNameAPortWithAComma)
{
    const MasterAtLink master(QStringLiteral("left,right"));
    const CliRun run = runLine(QStringLiteral("find --listen ") + master.path());
    EXPECT_THAT(run.out, HasSubstr("--link cannot name " + master.path().toStdString() + ", since"));
    EXPECT_THAT(run.out, Not(HasSubstr("esc:" + master.path().toStdString())));
    const QJsonArray found =
        runLine(QStringLiteral("find --listen --json ") + master.path()).json()[u"found"].toArray();
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found[0][u"place"].toString(), master.path());
    EXPECT_TRUE(found[0][u"link"].isNull());
}

TEST(FindCommand, TheNameOfAPortStaysInItsLine)
{
    const QString port = QStringLiteral("/dev/tty\nlooks: like another line");
    const CliRun run = runWith({}, [&](const Terminal &terminal) {
        return runCommandLine({QStringLiteral("find"), QStringLiteral("--listen"), port}, terminal);
    });
    EXPECT_THAT(run.out, testing::StartsWith(shownInLine(port).toStdString() + ": "));
    EXPECT_THAT(run.out, Not(HasSubstr("\nlooks")));
    const PtyPair pty;
    const QTemporaryDir folder;
    const QString link = folder.filePath(QStringLiteral("tty\nlike another"));
    QFile::link(pty.path(), link);
    const CliRun asked = runWith({}, [&](const Terminal &terminal) {
        return runCommandLine({QStringLiteral("find"), link}, terminal);
    });
    EXPECT_THAT(asked.out, HasSubstr(shownInLine(link).toStdString() + " would be asked"));
}

TEST(FindCommand, SaysWhatToTypeInsteadOfALink)
{
    const CliRun port = runLine(QStringLiteral("find esc:/dev/pts/99,baud=9600"));
    EXPECT_EQ(port.exit, 2);
    EXPECT_THAT(port.err, HasSubstr("type only /dev/pts/99."));
    EXPECT_THAT(runLine(QStringLiteral("find modbus-tcp:[::1]:502")).err, HasSubstr("type only [::1]:502."));
    for (const char *link : {"esc:training", "training", "project"})
        EXPECT_THAT(runLine(QStringLiteral("find ") + QLatin1String(link)).err,
                    HasSubstr("takes serial ports and hosts"))
            << link;
}

// Ctrl+C after this time.
std::jthread interruptAfter(std::chrono::milliseconds time)
{
    return std::jthread([time] {
        std::this_thread::sleep_for(time);
        ::kill(::getpid(), SIGINT);
    });
}

TEST(FindCommand, CtrlCEndsTheLastStepAndSaysSo)
{
    StopSignals held; // so that only the command gets Ctrl+C
    const PtyPair pty;
    const auto begin = std::chrono::steady_clock::now();
    const std::jthread interrupt = interruptAfter(std::chrono::milliseconds(200));
    const CliRun run = runLine(QStringLiteral("find --listen ") + pty.path());
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(1'300)) << "at once";
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr(": The search was cancelled.\n"));
    EXPECT_THAT(run.out, Not(HasSubstr("silent")));
    EXPECT_THAT(run.err, HasSubstr("cancelled"));
    while (held.came()) {
    }
}

TEST(FindCommand, CtrlCLeavesWhatWasFound)
{
    StopSignals held;
    const MasterAtLink master(QStringLiteral("port"));
    const PtyPair pty;
    const auto begin = std::chrono::steady_clock::now();
    const std::jthread interrupt = interruptAfter(std::chrono::milliseconds(1'900));
    const CliRun run = runLine(QStringLiteral("find --listen --json %1 %2").arg(master.path(), pty.path()));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(2'900)) << "at once";
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "cancelled");
    EXPECT_EQ(run.json()[u"found"].toArray().size(), 1);
    while (held.came()) {
    }
}

TEST(FindCommand, FindsAGatewayAtAHost)
{
    GatewayPeer peer;
    const QString host = peer.link().section(u':', 1);
    const CliRun run = runLine(QStringLiteral("find --yes --json ") + host);
    EXPECT_EQ(run.exit, 0) << run.err;
    const QJsonArray found = run.json()[u"found"].toArray();
    ASSERT_GE(found.size(), 1);
    EXPECT_EQ(found[0][u"kind"].toString(), QStringLiteral("interbus"));
    EXPECT_EQ(found[0][u"link"].toString(), QStringLiteral("modbus-tcp:") + host);
    EXPECT_EQ(peer.writes(), 0);
}

TEST(FindCommand, SaysWhyAPlaceCannotBeUsed)
{
    const CliRun run = runLine(QStringLiteral("find --listen /dev/ttyNowhere"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("There is no serial port /dev/ttyNowhere."));
    EXPECT_EQ(runLine(QStringLiteral("find host:99999")).exit, 2);
}

} // namespace
} // namespace codewheel
