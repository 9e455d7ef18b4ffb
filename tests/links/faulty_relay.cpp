// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/links/faulty_relay.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

namespace codewheel::test {
namespace {

constexpr std::size_t headerSize = 6; // transaction, protocol, length of the rest
constexpr int lookMs = 20;            // whether it is to end
constexpr int longestDelayMs = 250;

sockaddr_in loopbackAt(int port)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    return address;
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

bool sendAll(int to, const std::vector<std::uint8_t> &message, std::size_t count)
{
    return ::send(to, message.data(), count, MSG_NOSIGNAL) == static_cast<ssize_t>(count);
}

} // namespace

FaultyRelay::FaultyRelay(int serverPort, unsigned seed)
    : m_serverPort(serverPort)
    , m_random(seed)
    , m_listener(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
{
    sockaddr_in address = loopbackAt(0);
    socklen_t size = sizeof(address);
    EXPECT_EQ(::bind(m_listener, reinterpret_cast<sockaddr *>(&address), size), 0);
    EXPECT_EQ(::listen(m_listener, 8), 0);
    EXPECT_EQ(::getsockname(m_listener, reinterpret_cast<sockaddr *>(&address), &size), 0);
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
        relay(client, stop);
        ::close(client);
    }
}

void FaultyRelay::relay(int client, const std::stop_token &stop)
{
    const int server = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in address = loopbackAt(m_serverPort);
    bool goesOn = ::connect(server, reinterpret_cast<const sockaddr *>(&address), sizeof(address)) == 0;
    while (goesOn && !stop.stop_requested()) {
        std::array<pollfd, 2> ends{pollfd{client, POLLIN, 0}, pollfd{server, POLLIN, 0}};
        if (::poll(ends.data(), ends.size(), lookMs) <= 0)
            continue;
        if (ends[0].revents != 0)
            goesOn = pass(client, server);
        if (goesOn && ends[1].revents != 0)
            goesOn = pass(server, client);
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
bool FaultyRelay::pass(int from, int to)
{
    const auto message = receiveMessage(from);
    if (message.empty() || isMade(closed))
        return false;
    if (isMade(dropped))
        return true;
    if (isMade(delayed))
        std::this_thread::sleep_for(std::chrono::milliseconds(m_random() % longestDelayMs));
    if (isMade(cut)) {
        sendAll(to, message, message.size() / 2);
        return false;
    }
    const bool isSent = sendAll(to, message, message.size());
    return isMade(doubled) ? isSent && sendAll(to, message, message.size()) : isSent;
}

} // namespace codewheel::test
