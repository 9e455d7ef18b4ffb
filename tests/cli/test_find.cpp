// SPDX-License-Identifier: GPL-3.0-or-later
// Against tests/line/esc_peer.py and a pymodbus server, which know nothing of this program.
#include "tests/cli/cli_run.h"
#include "tests/cli/gateway_peer.h"
#include "tests/support/pty_pair.h"

#include <QJsonArray>
#include <QProcess>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <thread>

namespace codewheel {
namespace {

using testing::HasSubstr;

class EscPeerOnLine
{
public:
    explicit EscPeerOnLine(const QString &addresses)
    {
        m_peer.start(QStringLiteral(CODEWHEEL_PYTHON),
                     {QStringLiteral(CODEWHEEL_ESC_PEER), QStringLiteral("--addresses"), addresses});
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
    const EscPeerOnLine peer(QStringLiteral("12"));
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

TEST(FindCommand, SaysWhatToTypeInsteadOfALink)
{
    const CliRun port = runLine(QStringLiteral("find esc:/dev/pts/99,baud=9600"));
    EXPECT_EQ(port.exit, 2);
    EXPECT_THAT(port.err, HasSubstr("type only /dev/pts/99."));
    EXPECT_THAT(runLine(QStringLiteral("find modbus-tcp:[::1]:502")).err, HasSubstr("type only [::1]:502."));
    EXPECT_THAT(runLine(QStringLiteral("find esc:training")).err, HasSubstr("takes serial ports and hosts"));
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
