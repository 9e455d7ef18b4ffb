// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/connect_to_host.h"

#include "links/wait_for.h"

#include <cerrno>
#include <cstring>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/select.h>

namespace codewheel {
namespace {

using std::chrono::steady_clock;

// 0, or the system's error number; ECANCELED: the flag was raised.
int connectWithin(Descriptor &socket, const SocketAddress &address, WakeFlag &wake,
                  steady_clock::time_point until)
{
    socket = Descriptor(::socket(address.bytes.ss_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    if (!socket)
        return errno;
    if (socket.get() >= FD_SETSIZE) // the library waits by select(2), which has no place for more
        return EMFILE;
    const int on = 1;
    if (::setsockopt(socket.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on) != 0)
        return errno;
    if (::connect(socket.get(), reinterpret_cast<const sockaddr *>(&address.bytes), address.length) == 0)
        return 0;
    if (errno != EINPROGRESS)
        return errno;
    const Waited waited = waitFor(socket.get(), POLLOUT, wake, until);
    if (waited == Waited::woken)
        return ECANCELED;
    if (waited == Waited::timeOut)
        return ETIMEDOUT;
    int error = 0;
    socklen_t length = sizeof error;
    return ::getsockopt(socket.get(), SOL_SOCKET, SO_ERROR, &error, &length) == 0 ? error : errno;
}

Refusal connectRefusal(int error, const QString &name, Instant timeOut)
{
    if (error == ECONNREFUSED)
        return {RefusalKind::link, RefusalId::connectionRefused, {name}};
    if (error == ETIMEDOUT)
        return {RefusalKind::link,
                RefusalId::connectionSilent,
                {name, std::int64_t{std::chrono::ceil<std::chrono::seconds>(timeOut).count()}}};
    const QString text = QString::fromLocal8Bit(std::strerror(error));
    return {RefusalKind::link, RefusalId::linkFailed, {QStringLiteral("%1: %2").arg(name, text)}};
}

} // namespace

// An address that is silent gets its share of the time only, so that one behind it has a chance. The system
// has put the best one first, so what that one says is told.
Result<Descriptor> connectToHost(std::span<const SocketAddress> addresses, const QString &name,
                                 Instant timeOut, WakeFlag &wake)
{
    const steady_clock::time_point end = steady_clock::now() + timeOut;
    int firstError = 0;
    for (; !addresses.empty(); addresses = addresses.subspan(1)) {
        const auto share = (end - steady_clock::now()) / static_cast<int>(addresses.size());
        Descriptor socket;
        const int error = connectWithin(socket, addresses.front(), wake, steady_clock::now() + share);
        if (error == 0)
            return socket;
        if (error == ECANCELED)
            return refuse(RefusalKind::stopped, RefusalId::cancelled);
        firstError = firstError != 0 ? firstError : error;
    }
    return tl::unexpected(connectRefusal(firstError, name, timeOut));
}

} // namespace codewheel
