// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/links/faulty_relay.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <span>
#include <sys/socket.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace codewheel::test {
namespace {

constexpr std::size_t headerSize = 6; // transaction, protocol, length of the rest
constexpr int lookMs = 20;            // whether it is to end
constexpr int longestDelayMs = 250;
constexpr auto betweenPieces = std::chrono::milliseconds(2);
constexpr auto longestFlood = std::chrono::milliseconds(300);

sockaddr_in loopbackAt(int port)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    return address;
}

void require(int result)
{
    if (result != 0)
        throw std::system_error(errno, std::system_category(), "relay");
}

bool isReadable(int descriptor, int milliseconds)
{
    pollfd one{descriptor, POLLIN, 0};
    return ::poll(&one, 1, milliseconds) > 0;
}

bool receiveAll(int from, std::uint8_t *to, std::size_t count)
{
    return ::recv(from, to, count, MSG_WAITALL) == static_cast<ssize_t>(count);
}

std::vector<std::uint8_t> receiveMessage(int from)
{
    std::vector<std::uint8_t> message(headerSize);
    if (!receiveAll(from, message.data(), headerSize))
        return {};
    const std::size_t rest = static_cast<std::size_t>(message[4]) << 8 | message[5];
    message.resize(headerSize + rest);
    return receiveAll(from, message.data() + headerSize, rest) ? message : std::vector<std::uint8_t>();
}

bool sendAll(int to, std::span<const std::uint8_t> bytes)
{
    return ::send(to, bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
}

bool sendInPieces(int to, std::span<const std::uint8_t> message)
{
    for (; !message.empty(); message = message.subspan(std::min<std::size_t>(message.size(), 5))) {
        if (!sendAll(to, message.first(std::min<std::size_t>(message.size(), 5))))
            return false;
        std::this_thread::sleep_for(betweenPieces);
    }
    return true;
}

// For a while, whatever is asked meanwhile.
bool sendEndlessly(int to, std::span<const std::uint8_t> message)
{
    const auto end = std::chrono::steady_clock::now() + longestFlood;
    while (std::chrono::steady_clock::now() < end)
        if (!sendAll(to, message))
            return false;
    return true;
}

void sendAtOnce(int socket)
{
    const int on = 1;
    ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
}

} // namespace

FaultyRelay::FaultyRelay(int serverPort, unsigned seed)
    : m_serverPort(serverPort)
    , m_random(seed)
    , m_listener(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
{
    sockaddr_in address = loopbackAt(0);
    socklen_t size = sizeof(address);
    require(::bind(m_listener, reinterpret_cast<sockaddr *>(&address), size));
    require(::listen(m_listener, 8));
    require(::getsockname(m_listener, reinterpret_cast<sockaddr *>(&address), &size));
    m_port = ntohs(address.sin_port);
    m_thread = std::jthread([this](const std::stop_token &stop) { serve(stop); });
}

FaultyRelay::~FaultyRelay()
{
    m_thread.request_stop();
    m_thread.join();
    ::close(m_listener);
}

void FaultyRelay::serve(const std::stop_token &stop)
{
    while (!stop.stop_requested()) {
        if (!isReadable(m_listener, lookMs))
            continue;
        const int client = ::accept4(m_listener, nullptr, nullptr, SOCK_CLOEXEC);
        sendAtOnce(client);
        relay(client, stop);
        ::close(client);
    }
}

void FaultyRelay::relay(int client, const std::stop_token &stop)
{
    const int server = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sendAtOnce(server);
    const sockaddr_in address = loopbackAt(m_serverPort);
    bool goesOn = ::connect(server, reinterpret_cast<const sockaddr *>(&address), sizeof(address)) == 0;
    while (goesOn && !stop.stop_requested()) {
        std::array<pollfd, 2> ends{pollfd{client, POLLIN, 0}, pollfd{server, POLLIN, 0}};
        if (::poll(ends.data(), ends.size(), lookMs) <= 0)
            continue;
        if (ends[0].revents != 0)
            goesOn = pass(client, server, false);
        if (goesOn && ends[1].revents != 0)
            goesOn = pass(server, client, true);
    }
    ::close(server);
}

bool FaultyRelay::isMade(Kind kind)
{
    if (static_cast<int>(m_random() % 1000) >= m_ofThousand)
        return false;
    ++m_made[kind];
    return true;
}

// False: the connection is to be closed.
bool FaultyRelay::pass(int from, int to, bool isAnswer)
{
    const auto message = receiveMessage(from);
    if (message.empty() || isMade(closed))
        return false;
    if (isMade(dropped))
        return true;
    if (isMade(delayed))
        std::this_thread::sleep_for(std::chrono::milliseconds(m_random() % longestDelayMs));
    if (isMade(cut)) {
        sendAll(to, std::span(message).first(message.size() / 2));
        return false;
    }
    if (isMade(strayByte) && !sendAll(to, std::span(message).last(1)))
        return false;
    const bool isSent = sendOn(to, message);
    if (isAnswer && isMade(flood))
        return isSent && sendEndlessly(to, message);
    return isMade(doubled) ? isSent && sendAll(to, message) : isSent;
}

bool FaultyRelay::sendOn(int to, const std::vector<std::uint8_t> &message)
{
    if (isMade(inPieces))
        return sendInPieces(to, message);
    const std::span whole(message);
    return m_splitsAll ? sendAll(to, whole.first(headerSize)) && sendAll(to, whole.subspan(headerSize))
                       : sendAll(to, whole);
}

} // namespace codewheel::test
