// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/resolve_host.h"

#include "links/wait_for.h"

#include <cerrno>
#include <cstring>
#include <memory>
#include <netdb.h>
#include <poll.h>
#include <system_error>
#include <thread>

namespace codewheel {
namespace {

struct Lookup
{
    Lookup(const QString &name, int number)
        : host(name.toStdString())
        , port(std::to_string(number))
    {}

    const std::string host;
    const std::string port;
    std::vector<SocketAddress> addresses{};
    int error = 0; // of getaddrinfo
    int systemError = 0;
    WakeFlag done{};
};

void lookUp(Lookup &lookup, int flags)
{
    addrinfo hints = {};
    hints.ai_flags = AI_NUMERICSERV | flags;
    hints.ai_socktype = SOCK_STREAM;
    addrinfo *found = nullptr;
    lookup.error = ::getaddrinfo(lookup.host.c_str(), lookup.port.c_str(), &hints, &found);
    lookup.systemError = errno;
    if (lookup.error != 0)
        return;
    for (const addrinfo *one = found; one; one = one->ai_next) {
        SocketAddress address{.length = one->ai_addrlen};
        std::memcpy(&address.bytes, one->ai_addr, one->ai_addrlen);
        lookup.addresses.push_back(address);
    }
    ::freeaddrinfo(found);
}

Refusal lookupRefusal(const QString &host, const Lookup &lookup)
{
    if (lookup.error != EAI_SYSTEM && lookup.error != EAI_MEMORY)
        return {RefusalKind::link, RefusalId::hostNotFound, {host}};
    const char *text =
        lookup.error == EAI_SYSTEM ? std::strerror(lookup.systemError) : ::gai_strerror(lookup.error);
    return {RefusalKind::link,
            RefusalId::linkFailed,
            {QStringLiteral("%1: %2").arg(host, QString::fromLocal8Bit(text))}};
}

} // namespace

// A name server may take its time and getaddrinfo() cannot be ended, so it has a thread that nobody waits
// for, and that owns what it writes to.
Result<std::vector<SocketAddress>> resolveHost(const QString &host, int port, WakeFlag &wake)
{
    const auto lookup = std::make_shared<Lookup>(host, port);
    lookUp(*lookup, AI_NUMERICHOST);
    if (lookup->error == 0)
        return lookup->addresses;
    try {
        std::thread([lookup] {
            lookUp(*lookup, 0);
            lookup->done.raise();
        }).detach();
    } catch (const std::system_error &error) {
        return refuse(RefusalKind::link, RefusalId::linkFailed, {QString::fromLocal8Bit(error.what())});
    }
    if (waitFor(lookup->done.descriptor(), POLLIN, wake, std::chrono::steady_clock::time_point::max()) ==
        Waited::woken)
        return refuse(RefusalKind::stopped, RefusalId::cancelled);
    if (lookup->error != 0)
        return tl::unexpected(lookupRefusal(host, *lookup));
    return lookup->addresses;
}

} // namespace codewheel
