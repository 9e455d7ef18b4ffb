// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/links/crooked_peer.h"

#include <array>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

namespace codewheel {
namespace {

int numberAt(const QByteArray &bytes, qsizetype at)
{
    return static_cast<quint8>(bytes[at]) << 8 | static_cast<quint8>(bytes[at + 1]);
}

QByteArray number(int value)
{
    const std::array<char, 2> bytes{static_cast<char>(value >> 8 & 0xFF), static_cast<char>(value & 0xFF)};
    return {bytes.data(), bytes.size()};
}

void sendAll(int descriptor, const QByteArray &bytes)
{
    for (qsizetype sent = 0; sent < bytes.size();) {
        const auto more =
            ::write(descriptor, bytes.constData() + sent, static_cast<std::size_t>(bytes.size() - sent));
        if (more <= 0)
            return;
        sent += more;
    }
}

} // namespace

CrookedPeer::CrookedPeer(React react)
    : m_react(std::move(react))
    , m_listener(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
    , m_ended(::eventfd(0, EFD_CLOEXEC))
{
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof address;
    EXPECT_EQ(::bind(m_listener, reinterpret_cast<sockaddr *>(&address), length), 0);
    ::listen(m_listener, 8);
    ::getsockname(m_listener, reinterpret_cast<sockaddr *>(&address), &length);
    m_port = ntohs(address.sin_port);
    m_thread = std::thread([this] { serveClients(); });
}

CrookedPeer::CrookedPeer(React react, int line)
    : m_react(std::move(react))
    , m_ended(::eventfd(0, EFD_CLOEXEC))
{
    m_thread = std::thread([this, line] { serve(line); });
}

CrookedPeer::~CrookedPeer()
{
    ::eventfd_write(m_ended, 1);
    m_thread.join();
    if (m_listener >= 0)
        ::close(m_listener);
    ::close(m_ended);
}

void CrookedPeer::reactBy(React react)
{
    const std::scoped_lock lock(m_mutex);
    m_react = std::move(react);
}

int CrookedPeer::connections()
{
    const std::scoped_lock lock(m_mutex);
    return m_connections;
}

bool CrookedPeer::waitFor(int descriptor) const
{
    std::array<pollfd, 2> waited{{{descriptor, POLLIN, 0}, {m_ended, POLLIN, 0}}};
    return ::poll(waited.data(), waited.size(), -1) > 0 && waited[1].revents == 0;
}

void CrookedPeer::serveClients()
{
    while (waitFor(m_listener)) {
        const int client = ::accept4(m_listener, nullptr, nullptr, SOCK_CLOEXEC);
        {
            const std::scoped_lock lock(m_mutex);
            ++m_connections;
        }
        serve(client);
        ::close(client);
    }
}

void CrookedPeer::serve(int descriptor)
{
    SeenRequest request;
    while (m_listener >= 0 ? receiveOverTcp(descriptor, request) : receiveOverLine(descriptor, request)) {
        const Reaction reaction = [&] {
            const std::scoped_lock lock(m_mutex);
            return m_react(request);
        }();
        send(descriptor, reaction);
        std::this_thread::sleep_for(reaction.deafFor);
        if (reaction.hangsUp)
            return;
    }
}

void CrookedPeer::send(int descriptor, const Reaction &reaction) const
{
    for (const char byte : reaction.inPieces ? reaction.bytes : QByteArray()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        sendAll(descriptor, QByteArray(1, byte));
    }
    if (!reaction.inPieces && !reaction.endlessly)
        sendAll(descriptor, reaction.bytes);
    while (reaction.endlessly) {
        std::array<pollfd, 2> waited{{{descriptor, POLLIN | POLLOUT, 0}, {m_ended, POLLIN, 0}}};
        ::poll(waited.data(), waited.size(), -1);
        if ((waited[0].revents & ~POLLOUT) != 0 || waited[1].revents != 0)
            return;
        const auto size = static_cast<std::size_t>(reaction.bytes.size());
        if (::send(descriptor, reaction.bytes.constData(), size, MSG_NOSIGNAL | MSG_DONTWAIT) < 0 &&
            errno == ENOTSOCK)
            (void)!::write(descriptor, reaction.bytes.constData(), size);
    }
}

QByteArray CrookedPeer::receive(int descriptor, qsizetype count) const
{
    QByteArray bytes(count, 0);
    for (qsizetype received = 0; received < count;) {
        const auto more = waitFor(descriptor) ? ::read(descriptor, bytes.data() + received,
                                                       static_cast<std::size_t>(count - received))
                                              : 0;
        if (more <= 0)
            return {};
        received += more;
    }
    return bytes;
}

bool CrookedPeer::receiveOverTcp(int descriptor, SeenRequest &request) const
{
    const QByteArray header = receive(descriptor, 7);
    if (header.isEmpty())
        return false;
    request = {static_cast<quint16>(numberAt(header, 0)), static_cast<quint8>(header[6]),
               receive(descriptor, numberAt(header, 4) - 1)};
    return !request.message.isEmpty();
}

bool CrookedPeer::receiveOverLine(int descriptor, SeenRequest &request) const
{
    const QByteArray begin = receive(descriptor, 7);
    if (begin.isEmpty())
        return false;
    QByteArray rest;
    if (begin[1] == 16)
        rest = receive(descriptor, static_cast<quint8>(begin[6]) + 2);
    else
        rest = receive(descriptor, 1); // functions 3 and 4
    const QByteArray frame = begin + rest;
    request = {0, static_cast<quint8>(frame[0]), frame.mid(1, frame.size() - 3)};
    return !rest.isEmpty();
}

QByteArray CrookedPeer::tcpFrame(quint16 transaction, quint8 unit, const QByteArray &message)
{
    return number(transaction) + number(0) + number(static_cast<int>(message.size()) + 1) +
           static_cast<char>(unit) + message;
}

QByteArray CrookedPeer::lineFrame(quint8 unit, const QByteArray &message)
{
    const QByteArray frame = static_cast<char>(unit) + message;
    unsigned crc = 0xFFFF; // MODBUS over Serial Line V1.02, 6.2.2
    for (const char byte : frame) {
        crc ^= static_cast<quint8>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc & 1 ? crc >> 1 ^ 0xA001 : crc >> 1;
    }
    return frame + static_cast<char>(crc & 0xFF) + static_cast<char>(crc >> 8);
}

QByteArray rightAnswer(const QByteArray &message)
{
    if (message[0] == 16)
        return message.left(5);
    const int first = numberAt(message, 1);
    const int count = numberAt(message, 3);
    QByteArray answer = message.left(1) + static_cast<char>(2 * count);
    for (int i = 0; i < count; ++i)
        answer += number(first + i);
    return answer;
}

} // namespace codewheel
