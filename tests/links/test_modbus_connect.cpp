// SPDX-License-Identifier: GPL-3.0-or-later
// Why a port does not open, and how it is interrupted.
#include "kinds/interbus/gateway/register_texts.h"
#include "kinds/interbus/links/modbus_port.h"
#include "links/resolve_host.h"
#include "tests/links/crooked_peer.h"
#include "tests/support/port_holder.h"
#include "tests/support/pty_pair.h"
#include "tests/support/without_rights.h"

#include <QTemporaryFile>

#include <atomic>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <thread>
#include <tuple>
#include <unistd.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using Arguments = std::vector<RefusalArgument>;

GatewaySettings tcpTo(const QString &host, int port)
{
    return {.host = host, .tcpPort = port, .timeOut = 1h};
}

GatewaySettings lineAt(const QString &path)
{
    return {.transport = GatewaySettings::Transport::rtu, .serialPort = path, .timeOut = 1h};
}

Refusal refusalOfOpening(const GatewaySettings &settings)
{
    ModbusPort port(settings);
    const auto opened = port.open();
    return opened ? Refusal{} : opened.error();
}

sockaddr_in loopback(int port)
{
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

int bindToLoopback(int socket)
{
    sockaddr_in address = loopback(0);
    socklen_t length = sizeof address;
    EXPECT_EQ(::bind(socket, reinterpret_cast<sockaddr *>(&address), length), 0);
    ::getsockname(socket, reinterpret_cast<sockaddr *>(&address), &length);
    return ntohs(address.sin_port);
}

// Clients that take all places of a server, so that nobody else gets an answer when connecting.
class Crowd
{
public:
    explicit Crowd(int port)
    {
        const sockaddr_in address = loopback(port);
        for (int &client : m_clients) {
            client = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
            // It goes on by itself, or finds no place.
            std::ignore = ::connect(client, reinterpret_cast<const sockaddr *>(&address), sizeof address);
        }
    }
    ~Crowd()
    {
        for (const int client : m_clients)
            ::close(client);
    }
    Crowd(const Crowd &) = delete;
    Crowd &operator=(const Crowd &) = delete;

private:
    std::array<int, 16> m_clients{};
};

// A port on which nobody answers at all.
class BlackHole
{
public:
    BlackHole()
    {
        ::listen(m_listener, 0);
        m_crowd.emplace(m_port);
    }
    ~BlackHole() { ::close(m_listener); }
    BlackHole(const BlackHole &) = delete;
    BlackHole &operator=(const BlackHole &) = delete;

    int port() const { return m_port; }

private:
    int m_listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    int m_port = bindToLoopback(m_listener);
    std::optional<Crowd> m_crowd;
};

// A port on this computer that nobody listens at.
int deadPort()
{
    const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int port = bindToLoopback(socket);
    ::close(socket);
    return port;
}

TEST(ModbusConnect, AHostThatIsNotThereIsNamed)
{
    for (const auto &host : {QStringLiteral("no such host"), QStringLiteral("300.1.2.3"), QString()})
        EXPECT_EQ(refusalOfOpening(tcpTo(host, 502)),
                  (Refusal{RefusalKind::link, RefusalId::hostNotFound, {host}}));
}

TEST(ModbusConnect, ARefusedPortIsNamedWithItsAddress)
{
    const int port = deadPort();
    EXPECT_EQ(refusalOfOpening(tcpTo(QStringLiteral("127.0.0.1"), port)),
              (Refusal{RefusalKind::link,
                       RefusalId::connectionRefused,
                       {QStringLiteral("127.0.0.1:%1").arg(port)}}));
    EXPECT_EQ(refusalOfOpening(tcpTo(QStringLiteral("localhost"), port)).id, RefusalId::connectionRefused);
}

TEST(ModbusConnect, ASilentHostIsGivenAtLeastTwoSeconds)
{
    const BlackHole hole;
    GatewaySettings settings = tcpTo(QStringLiteral("127.0.0.1"), hole.port());
    settings.timeOut = 10ms;
    ModbusPort port(settings);
    const auto opened = port.open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error(), (Refusal{RefusalKind::link,
                                       RefusalId::connectionSilent,
                                       {QStringLiteral("127.0.0.1:%1").arg(hole.port()), std::int64_t{2}}}));
    EXPECT_GE(port.now(), 2s);
}

TEST(ModbusConnect, NamesAndIpv6AddressesConnect)
{
    CrookedPeer peer([](const SeenRequest &request) {
        return Reaction{
            CrookedPeer::tcpFrame(request.transaction, request.unit, rightAnswer(request.message))};
    });
    for (const auto &host : {QStringLiteral("localhost"), QStringLiteral("::ffff:127.0.0.1")}) {
        ModbusPort port(tcpTo(host, peer.port()));
        ASSERT_TRUE(port.open()) << host.toStdString();
        std::vector<Register> read(1);
        ASSERT_TRUE(port.read(RegisterArea::input, 77, read));
        EXPECT_EQ(read.front(), 77);
    }
}

TEST(ModbusConnect, APortIsNamedWithItsUnit)
{
    EXPECT_EQ(ModbusPort(tcpTo(QStringLiteral("gateway"), 502)).name(),
              QStringLiteral("gateway:502, unit 1"));
    EXPECT_EQ(ModbusPort(tcpTo(QStringLiteral("fe80::1"), 503)).name(),
              QStringLiteral("[fe80::1]:503, unit 1"));
    EXPECT_EQ(ModbusPort(lineAt(QStringLiteral("/dev/ttyUSB0"))).name(),
              QStringLiteral("/dev/ttyUSB0, unit 1"));
}

// The flag is up before the name server could answer.
TEST(ModbusConnect, InterruptEndsTheSearchForAName)
{
    WakeFlag wake;
    wake.raise();
    const auto resolved = resolveHost(QStringLiteral("localhost"), 502, wake);
    ASSERT_FALSE(resolved);
    EXPECT_EQ(resolved.error().kind, RefusalKind::stopped);
    EXPECT_TRUE(resolveHost(QStringLiteral("localhost"), 502, wake)) << "once";
}

TEST(ModbusConnect, InterruptEndsConnecting)
{
    const BlackHole hole;
    ModbusPort port(tcpTo(QStringLiteral("127.0.0.1"), hole.port()));
    const std::jthread other([&] { port.interrupt(); });
    const auto opened = port.open(); // would take an hour
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().kind, RefusalKind::stopped);
}

TEST(ModbusConnect, InterruptEndsTheNextCallOnce)
{
    CrookedPeer peer([](const SeenRequest &request) {
        return Reaction{
            CrookedPeer::tcpFrame(request.transaction, request.unit, rightAnswer(request.message))};
    });
    ModbusPort port(tcpTo(QStringLiteral("127.0.0.1"), peer.port()));
    port.interrupt();
    EXPECT_EQ(port.open().error().kind, RefusalKind::stopped);
    ASSERT_TRUE(port.open());
    port.interrupt();
    std::vector<Register> read(1);
    EXPECT_EQ(port.read(RegisterArea::input, 1, read).error().kind, RegisterError::Kind::stopped);
    EXPECT_TRUE(port.read(RegisterArea::input, 1, read));
    port.interrupt();
    port.wait(port.now() + 1h);
    EXPECT_TRUE(port.read(RegisterArea::input, 1, read));
}

// After a wrong answer the port connects anew, which takes an hour here: others have all places of the peer.
TEST(ModbusConnect, InterruptEndsConnectingAnewAndThePortGoesOn)
{
    std::atomic<bool> isWrong = true;
    CrookedPeer peer([&](const SeenRequest &request) {
        return Reaction{CrookedPeer::tcpFrame(request.transaction, isWrong ? 99 : request.unit,
                                              rightAnswer(request.message))};
    });
    ModbusPort port(tcpTo(QStringLiteral("127.0.0.1"), peer.port()));
    ASSERT_TRUE(port.open());
    std::vector<Register> read(1);
    EXPECT_EQ(port.read(RegisterArea::input, 1, read).error().kind, RegisterError::Kind::wrongAnswer);
    isWrong = false;
    {
        const Crowd crowd(peer.port());
        const std::jthread other([&] { port.interrupt(); });
        EXPECT_EQ(port.read(RegisterArea::input, 1, read).error().kind, RegisterError::Kind::stopped);
    }
    ASSERT_TRUE(port.read(RegisterArea::input, 1, read));
    EXPECT_EQ(read.front(), 1);
}

// Interrupts whoever waits for its answer, and sends only so many bytes of it.
class InterruptedWait : public testing::TestWithParam<int>
{
protected:
    Reaction interruptAndAnswer(const QByteArray &right)
    {
        if (++m_requests > 1)
            return {right};
        m_port.load()->interrupt();
        return {right.left(GetParam())};
    }
    void waits(const GatewaySettings &settings)
    {
        ModbusPort port(settings);
        m_port = &port;
        ASSERT_TRUE(port.open());
        std::vector<Register> read(2);
        EXPECT_EQ(port.read(RegisterArea::input, 5, read).error().kind, RegisterError::Kind::stopped);
        for (int tries = 0; !port.read(RegisterArea::input, 8, read); ++tries) // the other half never comes
            ASSERT_LT(tries, 200);
        EXPECT_EQ(read, (std::vector<Register>{8, 9}));
    }

    std::atomic<ModbusPort *> m_port = nullptr;
    int m_requests = 0;
};

TEST_P(InterruptedWait, EndsOnTcp)
{
    CrookedPeer peer([this](const SeenRequest &request) {
        return interruptAndAnswer(
            CrookedPeer::tcpFrame(request.transaction, request.unit, rightAnswer(request.message)));
    });
    GatewaySettings settings = tcpTo(QStringLiteral("127.0.0.1"), peer.port());
    if (GetParam() > 0)
        settings.timeOut = 500ms;
    waits(settings);
}

INSTANTIATE_TEST_SUITE_P(Bytes, InterruptedWait, testing::Values(0, 1, 7, 8, 12));

TEST(ModbusLine, InterruptEndsTheWaitForAnAnswerAndForQuiet)
{
    PtyPair pty;
    ModbusPort port(lineAt(pty.path()));
    CrookedPeer peer(
        [&](const SeenRequest &) {
            port.interrupt();
            return Reaction{};
        },
        pty.descriptor());
    ASSERT_TRUE(port.open());
    std::vector<Register> read(2);
    EXPECT_EQ(port.read(RegisterArea::input, 5, read).error().kind, RegisterError::Kind::stopped);
    const std::jthread other([&] { port.interrupt(); });
    EXPECT_EQ(port.read(RegisterArea::input, 5, read).error().kind, RegisterError::Kind::stopped);
}

TEST(ModbusLine, WhatIsNoPortIsNamed)
{
    EXPECT_EQ(refusalOfOpening(lineAt(QStringLiteral("/dev/ttyNONE0"))),
              (Refusal{RefusalKind::link, RefusalId::portNotFound, {QStringLiteral("/dev/ttyNONE0")}}));
    EXPECT_EQ(refusalOfOpening(lineAt(QStringLiteral("ttyNONE0"))).arguments,
              (Arguments{QStringLiteral("/dev/ttyNONE0")}));
    EXPECT_EQ(refusalOfOpening(lineAt(QStringLiteral("/dev/null"))).id, RefusalId::linkFailed);
    QTemporaryFile file;
    ASSERT_TRUE(file.open());
    EXPECT_EQ(refusalOfOpening(lineAt(file.fileName())).id, RefusalId::linkFailed);
}

TEST(ModbusLine, MissingRightsAreTold)
{
    PtyPair pty;
    ASSERT_EQ(::chmod(pty.path().toLocal8Bit().constData(), 0), 0);
    const WithoutRights rights;
    const Refusal refusal = refusalOfOpening(lineAt(pty.path()));
    EXPECT_EQ(refusal.id, RefusalId::portNoRights);
    EXPECT_EQ(refusal.arguments.size(), 3U);
}

TEST(ModbusLine, APortInUseKeepsItsSettings)
{
    PtyPair pty;
    const int owner = ::open(pty.path().toLocal8Bit().constData(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    ASSERT_EQ(::flock(owner, LOCK_EX | LOCK_NB), 0);
    ASSERT_EQ(::ioctl(owner, TIOCEXCL), 0);
    termios before = {};
    ASSERT_EQ(::tcgetattr(owner, &before), 0);
    EXPECT_EQ(refusalOfOpening(lineAt(pty.path())),
              (Refusal{RefusalKind::link, RefusalId::portInUse, {pty.path()}}));
    termios after = {};
    ASSERT_EQ(::tcgetattr(owner, &after), 0);
    EXPECT_EQ(::cfgetospeed(&after), ::cfgetospeed(&before));
    EXPECT_EQ(after.c_iflag, before.c_iflag);
    int isExclusive = 0;
    EXPECT_EQ(::ioctl(owner, TIOCGEXCL, &isExclusive), 0);
    EXPECT_NE(isExclusive, 0);
    ::ioctl(owner, TIOCNXCL);
    ::close(owner);
    EXPECT_EQ(refusalOfOpening(lineAt(pty.path())), Refusal{});
}

TEST(ModbusLine, APortThatAnotherProgramHasOpenIsRefused)
{
    const PtyPair pty;
    PortHolder holder(QStringLiteral(CODEWHEEL_PYTHON), pty.path());
    EXPECT_EQ(refusalOfOpening(lineAt(pty.path())).id, RefusalId::portInUse);
    holder.end();
    EXPECT_EQ(refusalOfOpening(lineAt(pty.path())), Refusal{});
}

TEST(ModbusLine, TwoPortsCannotHaveTheSameLine)
{
    PtyPair pty;
    ModbusPort one(lineAt(pty.path()));
    ASSERT_TRUE(one.open());
    EXPECT_EQ(refusalOfOpening(lineAt(pty.path())).id, RefusalId::portInUse);
    one.close();
    EXPECT_EQ(refusalOfOpening(lineAt(pty.path())), Refusal{});
}

TEST(ModbusLine, HasTheRateThatWasAskedFor)
{
    constexpr speed_t rateOfItsOwn = 0010000; // BOTHER, which <termios.h> lacks
    PtyPair pty;
    for (const auto &[rate, constant] :
         {std::pair{19'200, B19200}, {115'200, B115200}, {14'400, rateOfItsOwn}}) {
        GatewaySettings settings = lineAt(pty.path());
        settings.serial.baudRate = rate;
        ModbusPort port(settings);
        ASSERT_TRUE(port.open());
        termios now = {};
        ASSERT_EQ(::tcgetattr(pty.descriptor(), &now), 0);
        EXPECT_EQ(::cfgetospeed(&now), constant) << rate;
    }
}

TEST(ModbusLine, AnUnpluggedAdapterIsClosedAndItsPortIsGone)
{
    PtyPair pty;
    ModbusPort port(lineAt(pty.path()));
    ASSERT_TRUE(port.open());
    std::jthread adapter([&] {
        pty.receive(8);
        pty.unplug();
    });
    std::vector<Register> read(2);
    EXPECT_EQ(port.read(RegisterArea::input, 5, read).error().kind, RegisterError::Kind::unplugged);
    adapter.join();
    EXPECT_EQ(port.read(RegisterArea::input, 5, read).error().kind, RegisterError::Kind::closed);
    EXPECT_EQ(port.open().error().id, RefusalId::portNotFound);
}

TEST(ModbusLine, AnAdapterThatWasUnpluggedBetweenTwoRequestsIsClosed)
{
    PtyPair pty;
    ModbusPort port(lineAt(pty.path()));
    ASSERT_TRUE(port.open());
    pty.unplug();
    std::vector<Register> read(2);
    EXPECT_EQ(port.read(RegisterArea::input, 5, read).error().kind, RegisterError::Kind::unplugged);
}

TEST(ModbusLine, ALineThatNeverIsQuietIsTold)
{
    PtyPair pty;
    GatewaySettings settings = lineAt(pty.path());
    settings.timeOut = 100ms;
    ModbusPort port(settings);
    ASSERT_TRUE(port.open());
    const std::jthread chatter([&](const std::stop_token &stop) {
        while (!stop.stop_requested()) {
            pty.send("\x55");
            std::this_thread::sleep_for(1ms);
        }
    });
    std::vector<Register> read(2);
    RegisterError error;
    for (int tries = 0; tries < 200 && error.text != wrongAnswerKey(WrongAnswer::noPause); ++tries)
        error = port.read(RegisterArea::input, 5, read).error();
    EXPECT_EQ(error.kind, RegisterError::Kind::wrongAnswer);
}

} // namespace
} // namespace codewheel
