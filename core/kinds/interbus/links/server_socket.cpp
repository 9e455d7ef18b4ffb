// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/links/server_socket.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

namespace codewheel {
namespace {

constexpr int sendSeconds = 2; // until a client that fetches no answers is given up

using Addresses = std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)>;

Addresses lookUp(const ServerPlace &place)
{
    addrinfo hints = {};
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_PASSIVE;
    addrinfo *found = nullptr;
    const int error = ::getaddrinfo(place.host.toUtf8().constData(),
                                    QByteArray::number(place.port).constData(), &hints, &found);
    return {error == 0 ? found : nullptr, &::freeaddrinfo};
}

void setOption(int descriptor, int level, int option)
{
    const int on = 1;
    ::setsockopt(descriptor, level, option, &on, sizeof on);
}

tl::unexpected<Refusal> refusedBySystem(int error, const ServerPlace &place)
{
    const auto port = static_cast<std::int64_t>(place.port);
    switch (error) {
    case EADDRINUSE:
        return refuse(RefusalKind::link, RefusalId::serverPortTaken, {port});
    case EACCES:
        return refuse(RefusalKind::link, RefusalId::serverPortPrivileged, {port});
    case EADDRNOTAVAIL:
        return refuse(RefusalKind::link, RefusalId::serverAddressNotOurs, {place.host});
    default:
        return refuse(RefusalKind::link, RefusalId::linkFailed,
                      {QString::fromLocal8Bit(std::strerror(error))});
    }
}

ServerPlace placeIn(const sockaddr_storage &address, socklen_t length)
{
    std::array<char, NI_MAXHOST> host{};
    std::array<char, NI_MAXSERV> port{};
    // NOLINTNEXTLINE(*-reinterpret-cast): the interface of sockets
    ::getnameinfo(reinterpret_cast<const sockaddr *>(&address), length, host.data(), host.size(), port.data(),
                  port.size(), NI_NUMERICHOST | NI_NUMERICSERV);
    return {QString::fromLatin1(host.data()), QByteArray(port.data()).toInt()};
}

} // namespace

Result<Descriptor> listenAt(const ServerPlace &place)
{
    const Addresses addresses = lookUp(place);
    if (!addresses)
        return refuse(RefusalKind::link, RefusalId::hostNotFound, {place.host});
    int error = 0;
    for (const addrinfo *one = addresses.get(); one != nullptr; one = one->ai_next) {
        Descriptor socket(::socket(one->ai_family, one->ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
        if (socket) {
            setOption(socket.get(), SOL_SOCKET, SO_REUSEADDR); // what is left of a server that ended
            if (::bind(socket.get(), one->ai_addr, one->ai_addrlen) == 0 &&
                ::listen(socket.get(), SOMAXCONN) == 0)
                return socket;
        }
        error = error == 0 ? errno : error; // of the first one
    }
    return refusedBySystem(error, place);
}

ServerPlace placeOf(const Descriptor &listening)
{
    sockaddr_storage address = {};
    socklen_t length = sizeof address;
    // NOLINTNEXTLINE(*-reinterpret-cast)
    ::getsockname(listening.get(), reinterpret_cast<sockaddr *>(&address), &length);
    return placeIn(address, length);
}

std::pair<Descriptor, QString> acceptClient(const Descriptor &listening)
{
    sockaddr_storage address = {};
    socklen_t length = sizeof address;
    // NOLINTNEXTLINE(*-reinterpret-cast)
    Descriptor client(
        ::accept4(listening.get(), reinterpret_cast<sockaddr *>(&address), &length, SOCK_CLOEXEC));
    if (!client)
        return {std::move(client), QString()};
    setOption(client.get(), IPPROTO_TCP, TCP_NODELAY);
    const timeval longest{sendSeconds, 0};
    ::setsockopt(client.get(), SOL_SOCKET, SO_SNDTIMEO, &longest, sizeof longest);
    return {std::move(client), shownAddress(placeIn(address, length))};
}

QString shownAddress(const ServerPlace &place)
{
    const bool isSix = place.host.contains(u':');
    return (isSix ? QStringLiteral("[%1]:%2") : QStringLiteral("%1:%2")).arg(place.host).arg(place.port);
}

} // namespace codewheel
