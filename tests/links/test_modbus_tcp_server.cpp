// SPDX-License-Identifier: GPL-3.0-or-later
// The server against peers that share no code with it: libmodbus, mbpoll, pymodbus, and plain sockets.
#include "catalog/catalog.h"
#include "kinds/interbus/links/modbus_tcp_server.h"
#include "tests/links/modbus_client.h"
#include "tests/support/offered_ring.h"
#include "tests/support/scripted_link.h"
#include "vocabulary/refusal_text.h"

#include <QFile>
#include <QProcess>

#include <arpa/inet.h>
#include <future>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <random>
#include <sys/socket.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;
using test::ModbusClient;
using test::OfferedRing;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr int longestAnswer = 60'000; // ms

// What each device was sent, without repetitions.
using Histories = std::vector<std::vector<Word>>;

std::unique_ptr<ScriptedLink> recordedRing(std::size_t devices, Histories &sent)
{
    sent.assign(devices, {0});
    auto link = std::make_unique<ScriptedLink>(devices);
    link->answerWith([&sent](std::size_t device, Word out) {
        if (sent[device].back() != out)
            sent[device].push_back(out);
        return out;
    });
    return link;
}

// A plain socket to the server.
class Peer
{
public:
    explicit Peer(int port)
        : m_socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
    {
        sockaddr_in address = {};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        // NOLINTNEXTLINE(*-reinterpret-cast)
        m_isConnected =
            ::connect(m_socket.get(), reinterpret_cast<sockaddr *>(&address), sizeof address) == 0;
    }
    bool isConnected() const { return m_isConnected; }
    // False: the server has closed the connection.
    bool send(const QByteArray &bytes)
    {
        return ::send(m_socket.get(), bytes.constData(), static_cast<std::size_t>(bytes.size()),
                      MSG_NOSIGNAL) == bytes.size();
    }
    // As many bytes; fewer if the server closes the connection before.
    QByteArray receive(int count)
    {
        QByteArray bytes;
        pollfd waited{m_socket.get(), POLLIN, 0};
        while (bytes.size() < count && ::poll(&waited, 1, longestAnswer) == 1) {
            char byte = 0;
            if (::recv(m_socket.get(), &byte, 1, 0) != 1)
                break;
            bytes.append(byte);
        }
        return bytes;
    }
    bool isClosedByServer() { return receive(1).isEmpty(); }
    // Sends no more, and takes what comes until the server closes the connection too.
    bool endsWithServer()
    {
        ::shutdown(m_socket.get(), SHUT_WR);
        pollfd waited{m_socket.get(), POLLIN, 0};
        std::array<char, 512> bytes{};
        while (::poll(&waited, 1, longestAnswer) == 1)
            if (::recv(m_socket.get(), bytes.data(), bytes.size(), 0) <= 0)
                return true;
        return false;
    }
    // Without a goodbye.
    void vanish()
    {
        const linger atOnce{1, 0};
        ::setsockopt(m_socket.get(), SOL_SOCKET, SO_LINGER, &atOnce, sizeof atOnce);
        m_socket.close();
    }

private:
    Descriptor m_socket;
    bool m_isConnected = false;
};

class ModbusTcpServerTest : public testing::Test
{
protected:
    void SetUp() override { serve(4); }
    void serve(std::size_t devices, ModbusTcpServer::Limits limits = {})
    {
        m_server.reset();
        m_ring.reset();
        m_ring = std::make_unique<OfferedRing>(recordedRing(devices, m_sent), m_catalog);
        auto server = ModbusTcpServer::start({}, ServedUnits(m_ring->guests()), limits);
        ASSERT_TRUE(server) << refusalText(server.error()).toStdString();
        m_server = *std::move(server);
    }
    int port() const { return m_server->place().port; }
    ServedClients &clients() const { return m_server->clients(); }
    bool nobodyIsThere()
    {
        return m_ring->waitFor([this] { return clients().clients().empty(); });
    }
    void expectToServe()
    {
        ModbusClient client(port());
        EXPECT_EQ(client.write(0, {0x1234, 0x5678}), 0);
        EXPECT_THAT(client.readHolding(0, 2), ElementsAre(0x1234, 0x5678));
    }
    // The words of a device from now on are those of the past.
    const Histories &sentUntilNow()
    {
        m_ring->bus().close();
        return m_sent;
    }

    Catalog m_catalog = Catalog::builtIn();
    Histories m_sent;
    std::unique_ptr<OfferedRing> m_ring;
    std::unique_ptr<ModbusTcpServer> m_server;
};

struct Ended
{
    int exit;
    std::string out;
};

Ended run(const QString &program, const QStringList &arguments)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    if (!process.waitForFinished(longestAnswer))
        return {-1, process.errorString().toStdString()};
    return {process.exitCode(), process.readAll().toStdString()};
}

TEST_F(ModbusTcpServerTest, ServesLibmodbus)
{
    ModbusClient client(port());
    ASSERT_TRUE(client.isConnected());
    EXPECT_EQ(client.write(2, {0x0102, 0x0304}), 0);
    EXPECT_EQ(client.writeOne(3, 0xFFFF), 0);
    EXPECT_THAT(client.readHolding(2, 2), ElementsAre(0x0102, 0xFFFF));
    EXPECT_THAT(client.readInput(2, 2), ElementsAre(0x0102, 0xFFFF));
    EXPECT_THAT(client.readHolding(4'098, 2), ElementsAre(0x0102, 0xFFFF));
    EXPECT_EQ(client.write(8, {1}), EMBXILADD);
    EXPECT_THAT(sentUntilNow()[1], ElementsAre(0U, 0x01020304U, 0x0102FFFFU));
}

TEST_F(ModbusTcpServerTest, ServesMbpoll)
{
    const QStringList server{QStringLiteral("-m"),    QStringLiteral("tcp"), QStringLiteral("-p"),
                             QString::number(port()), QStringLiteral("-0"),  QStringLiteral("-1"),
                             QStringLiteral("-r"),    QStringLiteral("0")};
    const QString host = QStringLiteral("127.0.0.1");
    const Ended written = run(QStringLiteral(CODEWHEEL_MBPOLL),
                              server + QStringList{QStringLiteral("-t"), QStringLiteral("4"), host,
                                                   QStringLiteral("4660"), QStringLiteral("22136")});
    EXPECT_EQ(written.exit, 0) << written.out;
    const Ended read = run(QStringLiteral(CODEWHEEL_MBPOLL),
                           server + QStringList{QStringLiteral("-t"), QStringLiteral("3:hex"),
                                                QStringLiteral("-c"), QStringLiteral("2"), host});
    EXPECT_THAT(read.out, HasSubstr("0x1234"));
    EXPECT_THAT(read.out, HasSubstr("0x5678"));
    EXPECT_THAT(sentUntilNow()[0], ElementsAre(0U, 0x12345678U)) << "both halves in one cycle";
}

TEST_F(ModbusTcpServerTest, ServesPymodbus)
{
    const Ended ended = run(QStringLiteral(CODEWHEEL_DEBIAN_PYTHON),
                            {QStringLiteral(CODEWHEEL_MODBUS_CLIENT), QStringLiteral("tcp"),
                             QStringLiteral("127.0.0.1"), QString::number(port()), QStringLiteral("7")});
    EXPECT_EQ(ended.exit, 0) << ended.out;
}

// As a word, its low half is the complement of its high half: a torn one is none of them.
TEST_F(ModbusTcpServerTest, EachOfManyClientsFindsEachOfItsWritesOnTheBusOnce)
{
    constexpr int clientCount = 32;
    constexpr std::uint16_t writes = 1'000;
    serve(clientCount);
    std::vector<std::future<int>> acknowledged;
    acknowledged.reserve(clientCount);
    for (int i = 0; i < clientCount; ++i)
        acknowledged.push_back(std::async(std::launch::async, [i, port = port()] {
            ModbusClient client(port);
            int count = 0;
            for (std::uint16_t word = 1; word <= writes; ++word)
                count += client.write(2 * i, {word, static_cast<std::uint16_t>(~word)}) == 0 ? 1 : 0;
            return count;
        }));
    for (auto &client : acknowledged) {
        ASSERT_TRUE(m_ring->waitFor([&] { return client.wait_for(0ms) == std::future_status::ready; }));
        EXPECT_EQ(client.get(), writes);
    }
    std::vector<Word> wanted{0};
    for (Word word = 1; word <= writes; ++word)
        wanted.push_back((word << 16) | (~word & 0xFFFF));
    for (const std::vector<Word> &sent : sentUntilNow())
        EXPECT_EQ(sent, wanted);
}

// How long the slowest of so many requests took.
std::chrono::microseconds slowestOf(int requests, ModbusClient &client)
{
    steady_clock::duration slowest{};
    for (int i = 1; i <= requests; ++i) {
        const auto begin = steady_clock::now();
        EXPECT_EQ(client.write(0, {0, static_cast<std::uint16_t>(i)}), 0);
        slowest = std::max(slowest, steady_clock::now() - begin);
    }
    return std::chrono::duration_cast<std::chrono::microseconds>(slowest);
}

// They would wait for the time-out, if they did at all.
TEST_F(ModbusTcpServerTest, AClientThatSendsHalfARequestDelaysNobody)
{
    constexpr int requests = 300;
    serve(4, {.halfRequest = 60s});
    ModbusClient client(port());
    const auto before = slowestOf(requests, client);
    std::vector<std::unique_ptr<Peer>> halves;
    for (int i = 1; i <= 11; ++i) {
        halves.push_back(std::make_unique<Peer>(port()));
        halves.back()->send(QByteArray("\0\1\0\0\0\6\1\3\0\0\0\2", 12).first(i));
    }
    ASSERT_TRUE(m_ring->waitFor([&] { return clients().clients().size() == 12; }));
    const auto with = slowestOf(requests, client);
    std::cout << "slowest of " << requests << " writes: " << before.count() << " us alone, " << with.count()
              << " us beside 11 half requests\n";
    RecordProperty("slowestAloneMicroseconds", std::to_string(before.count()));
    RecordProperty("slowestBesideMicroseconds", std::to_string(with.count()));
    EXPECT_LT(with, 10s);
}

TEST_F(ModbusTcpServerTest, HalfARequestAndALongSilenceAreGivenUp)
{
    serve(4, {.halfRequest = 50ms, .idle = 60s});
    Peer half(port());
    half.send(QByteArray("\0\1\0\0\0", 5));
    EXPECT_TRUE(half.isClosedByServer());
    serve(4, {.halfRequest = 60s, .idle = 50ms});
    Peer silent(port());
    EXPECT_TRUE(silent.isClosedByServer());
    EXPECT_TRUE(nobodyIsThere());
}

TEST_F(ModbusTcpServerTest, WhoSendsNoModbusIsDisconnected)
{
    for (const QByteArray &garbage :
         {QByteArray("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"), QByteArray(600, '\xFF'),
          QByteArray("\0\1\0\0\0\0\1\3", 8), QByteArray("\0\1\0\0\xFF\xFF\1\3", 8),
          QByteArray("\0\1\0\1\0\6\1\3\0\0\0\2", 12)}) {
        Peer peer(port());
        peer.send(garbage);
        EXPECT_TRUE(peer.isClosedByServer());
    }
    expectToServe();
}

TEST_F(ModbusTcpServerTest, AnyBytesAreSurvived)
{
    std::minstd_rand random(11);
    for (int i = 0; i < 200; ++i) {
        Peer peer(port());
        QByteArray bytes;
        for (auto count = random() % 400; count > 0; --count)
            bytes.append(static_cast<char>(random()));
        if (i % 2 == 0) // as a frame, so that its contents are looked at
            bytes.prepend(QByteArray("\0\0\0\0\0", 5) + char(2 + random() % 250));
        peer.send(bytes);
        EXPECT_TRUE(peer.endsWithServer());
    }
    EXPECT_TRUE(nobodyIsThere());
    expectToServe();
}

// Several requests at once, in pieces; of a function nobody has the next one is understood all the same.
TEST_F(ModbusTcpServerTest, RequestsAreSeparatedByTheLengthInTheirHeader)
{
    Peer peer(port());
    peer.send(QByteArray("\0\1\0\0\0\5\1\x2B\x0E\1\0", 11) + QByteArray("\0\2\0\0\0\6\1\4\x20\0\0\1", 12) +
              QByteArray("\0\3\0\0\0\6", 6));
    EXPECT_EQ(peer.receive(9), QByteArray("\0\1\0\0\0\3\1\xAB\1", 9));
    EXPECT_EQ(peer.receive(11), QByteArray("\0\2\0\0\0\5\1\4\2\0\xE0", 11));
    peer.send(QByteArray("\1\4\x20\0\0\1", 6));
    EXPECT_EQ(peer.receive(11), QByteArray("\0\3\0\0\0\5\1\4\2\0\xE0", 11));
}

TEST_F(ModbusTcpServerTest, WhoFetchesNoAnswersIsDisconnected)
{
    Peer peer(port());
    const QByteArray request("\0\1\0\0\0\6\1\4\0\0\0\x08", 12);
    while (peer.send(request.repeated(1'000))) // until all buffers are full, and for a while
        ;
    EXPECT_TRUE(nobodyIsThere());
    expectToServe();
}

TEST_F(ModbusTcpServerTest, AThousandConnectionsOneAfterTheOther)
{
    for (int i = 0; i < 1'000; ++i) {
        Peer peer(port());
        ASSERT_TRUE(peer.isConnected()) << i;
    }
    EXPECT_TRUE(
        m_ring->waitFor([&] { return clients().everCame() + clients().refusedConnections() == 1'000; }));
    EXPECT_TRUE(nobodyIsThere());
    expectToServe();
}

TEST_F(ModbusTcpServerTest, MoreThanItServesAtOnceAreDisconnectedAndCounted)
{
    serve(4, {.clients = 8});
    std::vector<std::unique_ptr<Peer>> peers;
    peers.reserve(8);
    for (int i = 0; i < 8; ++i)
        peers.push_back(std::make_unique<Peer>(port()));
    ASSERT_TRUE(m_ring->waitFor([&] { return clients().clients().size() == 8; }));
    for (int i = 0; i < 50; ++i)
        EXPECT_TRUE(Peer(port()).isClosedByServer());
    EXPECT_EQ(clients().refusedConnections(), 50U);
    peers.front()->send(QByteArray("\0\2\0\0\0\6\1\4\x20\0\0\1", 12));
    EXPECT_EQ(peers.front()->receive(11).size(), 11) << "those that are there are served";
    peers.clear();
    EXPECT_TRUE(nobodyIsThere());
    expectToServe();
}

TEST_F(ModbusTcpServerTest, AClientThatVanishesIsForgotten)
{
    Peer peer(port());
    peer.send(QByteArray("\0\1\0\0\0\x0B\1\x10\0\0\0\2\4\x12\x34\x56\x78", 17));
    peer.vanish();
    EXPECT_TRUE(m_ring->waitFor([&] { return clients().everCame() == 1 && clients().clients().empty(); }));
    expectToServe();
}

TEST_F(ModbusTcpServerTest, TellsWhoIsConnected)
{
    ModbusClient client(port(), 9);
    client.write(2, {0x00AA, 0x00BB});
    client.write(99, {1});
    ASSERT_TRUE(m_ring->waitFor(
        [&] { return clients().clients().size() == 1 && clients().clients()[0].requests == 2; }));
    const ServedClient told = clients().clients().front();
    EXPECT_THAT(told.address.toStdString(), testing::StartsWith("127.0.0.1:"));
    EXPECT_EQ(told.unit, 9);
    EXPECT_EQ(told.writes, 1U);
    EXPECT_EQ(told.refused, 1U);
    ASSERT_TRUE(told.written);
    EXPECT_EQ(told.written->word.place, NodeId("2.0"));
    EXPECT_EQ(told.written->word.word, 0x00AA00BBU);
}

TEST_F(ModbusTcpServerTest, EndsWhileClientsAreConnected)
{
    ModbusClient client(port());
    ASSERT_TRUE(m_ring->waitFor([&] { return clients().clients().size() == 1; }));
    Peer half(port());
    half.send("half");
    m_server.reset();
    EXPECT_TRUE(half.isClosedByServer());
    EXPECT_THAT(client.readHolding(0, 1), testing::IsEmpty());
}

TEST_F(ModbusTcpServerTest, RefusesWhereItCannotListen)
{
    const auto whyNot = [&](const ServerPlace &place) {
        const auto server = ModbusTcpServer::start(place, ServedUnits(m_ring->guests()));
        EXPECT_FALSE(server);
        return server ? std::string() : refusalText(server.error()).toStdString();
    };
    EXPECT_THAT(whyNot({.port = port()}), HasSubstr("is used by another program"));
    EXPECT_THAT(whyNot({.host = QStringLiteral("192.0.2.77")}),
                HasSubstr("does not have the address 192.0.2.77"));
}

// Where the system has ports for administrators at all.
TEST_F(ModbusTcpServerTest, APortForAdministratorsIsRefusedToOthers)
{
    QFile file(QStringLiteral("/proc/sys/net/ipv4/ip_unprivileged_port_start"));
    if (!file.open(QIODevice::ReadOnly) || file.readAll().trimmed().toInt() <= 502)
        GTEST_SKIP() << "here everybody may use any port";
    constexpr uid_t nobody = 65534;
    const bool isRoot = ::geteuid() == 0;
    if (isRoot) {
        ASSERT_EQ(::seteuid(nobody), 0);
    }
    const auto server = ModbusTcpServer::start({.port = 502}, ServedUnits(m_ring->guests()));
    if (isRoot) {
        ASSERT_EQ(::seteuid(0), 0);
    }
    ASSERT_FALSE(server);
    EXPECT_EQ(server.error().id, RefusalId::serverPortPrivileged);
    EXPECT_THAT(refusalText(server.error()).toStdString(), HasSubstr("port 502"));
}

TEST_F(ModbusTcpServerTest, ListensOnThisComputerOnlyUnlessAnAddressIsNamed)
{
    EXPECT_EQ(m_server->place().host, QStringLiteral("127.0.0.1"));
    const auto server =
        ModbusTcpServer::start({.host = QStringLiteral("0.0.0.0")}, ServedUnits(m_ring->guests()));
    ASSERT_TRUE(server);
    EXPECT_EQ((*server)->place().host, QStringLiteral("0.0.0.0"));
    EXPECT_TRUE(ModbusClient((*server)->place().port).isConnected());
}

} // namespace
} // namespace codewheel
