// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/wake_flag.h"
#include "vocabulary/refusal.h"

#include <sys/socket.h>
#include <vector>

namespace codewheel {

struct SocketAddress
{
    sockaddr_storage bytes{};
    socklen_t length = 0;
};

// The addresses of a TCP port, the best one first. `host` is a name, or an address of IPv4 or IPv6. Refused:
// hostNotFound, linkFailed, or `stopped` by the flag.
Result<std::vector<SocketAddress>> resolveHost(const QString &host, int port, WakeFlag &wake);

} // namespace codewheel
