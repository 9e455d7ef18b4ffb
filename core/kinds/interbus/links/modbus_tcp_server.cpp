// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/links/modbus_tcp_server.h"

#include "kinds/interbus/links/tcp_requests.h"
#include "links/wake_flag.h"

#include <array>
#include <atomic>
#include <list>
#include <poll.h>
#include <sys/socket.h>
#include <thread>

namespace codewheel {
namespace {

constexpr int pauseWithoutSockets = 100; // ms, until the next try

using std::chrono::system_clock;

bool sendAll(int descriptor, const ModbusBytes &bytes)
{
    std::size_t sent = 0;
    while (sent < bytes.size()) {
        const auto count = ::send(descriptor, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
        if (count <= 0)
            return false;
        sent += static_cast<std::size_t>(count);
    }
    return true;
}

} // namespace

struct ModbusTcpServer::Private
{
    // Its socket is closed once its thread has ended.
    struct Connection
    {
        Connection(Descriptor connected, unsigned itsId)
            : socket(std::move(connected))
            , id(itsId)
        {}

        Descriptor socket;
        const unsigned id;
        std::atomic<bool> hasEnded = false;
        std::jthread thread{};
    };

    void accept(const std::stop_token &stop);
    void takeClient();
    void disconnect(unsigned client);
    void serve(Connection &connection);
    void removeEnded();

    Descriptor listening;
    ServedUnits units;
    Limits limits;
    ServedClients clients;
    WakeFlag wake{};                     // the thread that accepts: somebody left, or it is over
    std::list<Connection> connections{}; // used by that thread
    std::jthread accepting{};
};

void ModbusTcpServer::Private::accept(const std::stop_token &stop)
{
    std::array<pollfd, 2> waited{{{wake.descriptor(), POLLIN, 0}, {listening.get(), POLLIN, 0}}};
    while (!stop.stop_requested()) {
        ::poll(waited.data(), waited.size(), -1);
        wake.lower();
        removeEnded();
        if ((waited[1].revents & POLLIN) != 0 && !stop.stop_requested())
            takeClient();
    }
}

// A client that cannot be served is accepted all the same, so that it learns of it.
void ModbusTcpServer::Private::takeClient()
{
    auto [socket, address] = acceptClient(listening);
    if (!socket) {
        pollfd waited{wake.descriptor(), POLLIN, 0};
        if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM)
            ::poll(&waited, 1, pauseWithoutSockets);
        return;
    }
    if (const auto leaving = clients.giveWay(system_clock::now()))
        disconnect(*leaving);
    const auto id = clients.come(address, system_clock::now());
    if (!id)
        return;
    Connection &connection = connections.emplace_back(std::move(socket), *id);
    connection.thread = std::jthread([this, &connection] { serve(connection); });
}

// Its thread ends then.
void ModbusTcpServer::Private::disconnect(unsigned client)
{
    for (const Connection &connection : connections)
        if (connection.id == client)
            ::shutdown(connection.socket.get(), SHUT_RDWR);
}

void ModbusTcpServer::Private::serve(Connection &connection)
{
    TcpRequests requests(connection.socket.get(), {limits.halfRequest, limits.idle});
    while (const auto request = requests.next()) {
        const ServedUnits::Answer answer = units.answer(request->unit, request->pdu);
        clients.took(connection.id, request->unit, answer, system_clock::now());
        if (!sendAll(connection.socket.get(), request->answer(answer.pdu)))
            break;
    }
    clients.leave(connection.id);
    connection.hasEnded = true;
    wake.raise();
}

void ModbusTcpServer::Private::removeEnded()
{
    std::erase_if(connections, [](const Connection &connection) { return connection.hasEnded.load(); });
}

Result<std::unique_ptr<ModbusTcpServer>> ModbusTcpServer::start(const ServerPlace &place, ServedUnits units,
                                                                Limits limits)
{
    auto listening = listenAt(place);
    if (!listening)
        return tl::unexpected(listening.error());
    std::unique_ptr<Private> made(
        new Private{*std::move(listening), std::move(units), limits, ServedClients(limits.clients)});
    return std::unique_ptr<ModbusTcpServer>(new ModbusTcpServer(std::move(made)));
}

ModbusTcpServer::ModbusTcpServer(std::unique_ptr<Private> made)
    : d(std::move(made))
{
    d->accepting = std::jthread([this](const std::stop_token &stop) { d->accept(stop); });
}

ModbusTcpServer::~ModbusTcpServer()
{
    d->accepting.request_stop();
    d->wake.raise();
    d->accepting.join();
    for (const Private::Connection &connection : d->connections)
        ::shutdown(connection.socket.get(), SHUT_RDWR); // ends what its thread waits for
    d->connections.clear();
}

ServerPlace ModbusTcpServer::place() const
{
    return placeOf(d->listening);
}

ServedClients &ModbusTcpServer::clients() const
{
    return d->clients;
}

} // namespace codewheel
