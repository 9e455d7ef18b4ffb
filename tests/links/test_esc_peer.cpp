// SPDX-License-Identifier: GPL-3.0-or-later
// A few exchanges with tests/kinds/esc/line/esc_peer.py, which knows nothing of this program, over a real
// pseudo terminal. Requests and expected answers are literal.
#include "links/serial_port_link.h"

#include <QProcess>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class EscPeer : public testing::Test
{
protected:
    ~EscPeer() override
    {
        m_peer.closeWriteChannel();
        EXPECT_TRUE(m_peer.waitForFinished(20'000));
    }
    void start(const QString &options = {})
    {
        m_peer.start(QStringLiteral(CODEWHEEL_PYTHON), QStringList{QStringLiteral(CODEWHEEL_ESC_PEER)} +
                                                           options.split(u' ', Qt::SkipEmptyParts));
        while (!m_peer.canReadLine())
            ASSERT_TRUE(m_peer.waitForReadyRead(60'000)) << m_peer.readAllStandardError().toStdString();
        m_link = std::make_unique<SerialPortLink>(QString::fromLocal8Bit(m_peer.readLine()).trimmed());
        ASSERT_TRUE(m_link->open({}));
    }
    // Returns this many bytes of the answer.
    QByteArray ask(const char *text, qsizetype count)
    {
        EXPECT_TRUE(m_link->write("\x1B" + QByteArray(text) + "\r\n"));
        QByteArray answer;
        while (answer.size() < count) {
            const auto more = m_link->read(m_link->now() + 60s);
            if (!more || more->isEmpty())
                break;
            answer += *more;
        }
        return answer;
    }

    QProcess m_peer;
    std::unique_ptr<SerialPortLink> m_link;
};

TEST_F(EscPeer, AnswersReadsWritesAndRefusals)
{
    start();
    EXPECT_EQ(ask("05P", 12), "\r\n00001235\r\n");
    EXPECT_EQ(ask("12U", 8), "\r\n1000\r\n");
    EXPECT_EQ(ask("03V", 29), "\r\n5882 PEER FOR TESTS V1.00\r\n");
    EXPECT_EQ(ask("05GP00005200", 2), "\r\n");
    EXPECT_EQ(ask("05P", 12), "\r\n00005200\r\n");
    EXPECT_EQ(ask("05C", 12), "\r\n00003FCB\r\n");
    EXPECT_EQ(ask("05GP52", 4), "05\r\n");
    EXPECT_EQ(ask("05Q", 4), "03\r\n");
    EXPECT_EQ(ask("05GD1", 2), "\r\n");
    EXPECT_EQ(ask("05O", 8), "\r\n2001\r\n");
    EXPECT_EQ(ask("05X07", 2), "\r\n");
    EXPECT_EQ(ask("07P", 12), "\r\n00005200\r\n");
}

TEST_F(EscPeer, TheMasterAddressIsForOneAlone)
{
    start(QStringLiteral("--addresses 05"));
    EXPECT_EQ(ask("00P", 12), "\r\n00001235\r\n");
}

TEST_F(EscPeer, EchoesAndAddsGarbage)
{
    start(QStringLiteral("--echo --garbage 3"));
    const QByteArray heard = ask("05P", 6 + 3 + 12 + 3);
    EXPECT_TRUE(heard.startsWith("\x1B"
                                 "05P\r\n"));
    EXPECT_EQ(heard.indexOf("\r\n00001235\r\n"), 9);
    EXPECT_LT(heard.back(), 0);
}

TEST_F(EscPeer, SilentOnesSayNothing)
{
    start(QStringLiteral("--silent 05 --delay 1 --byte-time 573"));
    EXPECT_EQ(ask("05P", 0), "");
    EXPECT_EQ(ask("12D", 8), "\r\n2000\r\n"); // the first answer to come
}

TEST_F(EscPeer, ItsEndIsNoticed)
{
    start();
    m_peer.kill();
    const auto gone = m_link->read(m_link->now() + 60s);
    ASSERT_FALSE(gone);
    EXPECT_EQ(gone.error().id, RefusalId::portLost);
}

} // namespace
} // namespace codewheel
