// SPDX-License-Identifier: GPL-3.0-or-later
// The port against a server of pymodbus (tests/links/pymodbus_server.py), over TCP and over pseudo terminals.
#include "kinds/interbus/links/modbus_port.h"
#include "tests/support/pty_pair.h"

#include <QProcess>

#include <array>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <thread>
#include <unistd.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

// The wire between two pseudo terminals.
class NullModem
{
public:
    NullModem()
        : m_thread([this] { carry(); })
    {}
    ~NullModem()
    {
        ::eventfd_write(m_ended, 1);
        m_thread.join();
        ::close(m_ended);
    }
    NullModem(const NullModem &) = delete;
    NullModem &operator=(const NullModem &) = delete;

    QString path() const { return m_one.path(); }
    QString otherPath() const { return m_other.path(); }

private:
    void carry()
    {
        const std::array<int, 2> ends{m_one.descriptor(), m_other.descriptor()};
        for (;;) {
            std::array<pollfd, 3> waited{{{ends[0], POLLIN, 0}, {ends[1], POLLIN, 0}, {m_ended, POLLIN, 0}}};
            ::poll(waited.data(), waited.size(), -1);
            if (waited[2].revents != 0)
                return;
            for (std::size_t i = 0; i < ends.size(); ++i) {
                std::array<char, 512> bytes{};
                const auto count = waited[i].revents != 0 ? ::read(ends[i], bytes.data(), bytes.size()) : 0;
                if (count > 0 && ::write(ends[1 - i], bytes.data(), static_cast<std::size_t>(count)) != count)
                    return;
            }
        }
    }

    PtyPair m_one;
    PtyPair m_other;
    int m_ended = ::eventfd(0, EFD_CLOEXEC);
    std::thread m_thread;
};

class Pymodbus : public testing::Test
{
protected:
    ~Pymodbus() override
    {
        m_server.closeWriteChannel();
        EXPECT_TRUE(m_server.state() == QProcess::NotRunning || m_server.waitForFinished(60'000));
    }
    // Its first line.
    QString start(const QStringList &arguments = {})
    {
        m_server.start(QStringLiteral(CODEWHEEL_DEBIAN_PYTHON),
                       QStringList{QStringLiteral(CODEWHEEL_PYMODBUS_SERVER)} + arguments);
        while (!m_server.canReadLine())
            if (!m_server.waitForReadyRead(60'000)) {
                ADD_FAILURE() << m_server.readAllStandardError().toStdString();
                return {};
            }
        return QString::fromLocal8Bit(m_server.readLine()).trimmed();
    }
    GatewaySettings onTcp()
    {
        return {.host = QStringLiteral("127.0.0.1"), .tcpPort = start().toInt(), .unit = 5, .timeOut = 30s};
    }
    static void readsWritesAndIsRefused(ModbusPort &port)
    {
        ASSERT_TRUE(port.open());
        std::vector<Register> read(125);
        ASSERT_TRUE(port.read(RegisterArea::input, 200, read));
        EXPECT_EQ(read.front(), 1'200);
        EXPECT_EQ(read.back(), 1'324);
        EXPECT_TRUE(port.write(10, std::vector<Register>{0xFFFF, 0, 0x8001}));
        std::vector<Register> written(4);
        ASSERT_TRUE(port.read(RegisterArea::holding, 9, written));
        EXPECT_EQ(written, (std::vector<Register>{9, 0xFFFF, 0, 0x8001}));
        ASSERT_TRUE(port.writeAndRead(20, std::vector<Register>{7}, 20, std::span(written).first(2)));
        EXPECT_EQ(written, (std::vector<Register>{7, 21, 0, 0x8001}));
        const auto refused = port.read(RegisterArea::input, 399, std::span(written).first(2));
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error(), (RegisterError{RegisterError::Kind::exception, 2, {}}));
        EXPECT_TRUE(port.read(RegisterArea::input, 399, std::span(written).first(1)));
    }

    NullModem m_line;
    QProcess m_server;
};

TEST_F(Pymodbus, OnTcp)
{
    ModbusPort port(onTcp());
    readsWritesAndIsRefused(port);
}

TEST_F(Pymodbus, OnALine)
{
    start({m_line.otherPath()});
    ModbusPort port({.transport = GatewaySettings::Transport::rtu,
                     .serialPort = m_line.path(),
                     .unit = 5,
                     .timeOut = 30s});
    readsWritesAndIsRefused(port);
}

TEST_F(Pymodbus, ThatEndsHasClosed)
{
    ModbusPort port(onTcp());
    ASSERT_TRUE(port.open());
    std::vector<Register> read(1);
    EXPECT_TRUE(port.read(RegisterArea::input, 0, read));
    m_server.closeWriteChannel();
    ASSERT_TRUE(m_server.waitForFinished(60'000));
    EXPECT_EQ(port.read(RegisterArea::input, 0, read).error().kind, RegisterError::Kind::closed);
    EXPECT_EQ(port.open().error().id, RefusalId::connectionRefused);
}

} // namespace
} // namespace codewheel
