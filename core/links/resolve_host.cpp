// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/resolve_host.h"

#include "links/wait_for.h"

#include <cerrno>
#include <cstring>
#include <future>
#include <memory>
#include <netdb.h>
#include <poll.h>
#include <string>
#include <system_error>
#include <thread>

namespace codewheel {
namespace {

struct Found
{
    std::vector<SocketAddress> addresses{};
    int error = 0; // of getaddrinfo
    int systemError = 0;
};

Found lookUp(const std::string &host, int port, int flags)
{
    addrinfo hints = {};
    hints.ai_flags = AI_NUMERICSERV | flags;
    hints.ai_socktype = SOCK_STREAM;
    addrinfo *list = nullptr;
    Found found;
    found.error = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &list);
    found.systemError = errno;
    if (found.error != 0)
        return found;
    for (const addrinfo *one = list; one; one = one->ai_next) {
        SocketAddress address{.length = one->ai_addrlen};
        std::memcpy(&address.bytes, one->ai_addr, one->ai_addrlen);
        found.addresses.push_back(address);
    }
    ::freeaddrinfo(list);
    return found;
}

Result<std::vector<SocketAddress>> addressesOf(const QString &host, Found found)
{
    if (found.error == 0)
        return std::move(found.addresses);
    if (found.error != EAI_SYSTEM && found.error != EAI_MEMORY)
        return refuse(RefusalKind::link, RefusalId::hostNotFound, {host});
    const char *text =
        found.error == EAI_SYSTEM ? std::strerror(found.systemError) : ::gai_strerror(found.error);
    return refuse(RefusalKind::link, RefusalId::linkFailed,
                  {QStringLiteral("%1: %2").arg(host, QString::fromLocal8Bit(text))});
}

// What the thread leaves behind, whether anybody still waits for it or not.
struct Lookup
{
    std::promise<Found> found{};
    WakeFlag done{};
};

} // namespace

// A name server may take its time and getaddrinfo() cannot be ended, so it has a thread that nobody waits
// for, and that owns what it writes to.
Result<std::vector<SocketAddress>> resolveHost(const QString &host, int port, WakeFlag &wake)
{
    const std::string name = host.toStdString();
    if (auto found = lookUp(name, port, AI_NUMERICHOST); found.error == 0)
        return addressesOf(host, std::move(found));
    const auto lookup = std::make_shared<Lookup>();
    try {
        std::thread([lookup, name, port] {
            lookup->found.set_value(lookUp(name, port, 0));
            lookup->done.raise();
        }).detach();
    } catch (const std::system_error &error) {
        return refuse(RefusalKind::link, RefusalId::linkFailed, {QString::fromLocal8Bit(error.what())});
    }
    if (waitFor(lookup->done.descriptor(), POLLIN, wake, std::chrono::steady_clock::time_point::max()) ==
        Waited::woken)
        return refuse(RefusalKind::stopped, RefusalId::cancelled);
    return addressesOf(host, lookup->found.get_future().get());
}

} // namespace codewheel
