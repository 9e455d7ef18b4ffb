// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/descriptor.h"
#include "links/resolve_host.h"
#include "vocabulary/instant.h"

#include <span>

namespace codewheel {

// Connects to the first of these addresses that accepts within the time; `name` is for the sentences. The
// socket never blocks and sends at once. Refused: connectionRefused, connectionSilent, linkFailed, or
// `stopped` by the flag.
Result<Descriptor> connectToHost(std::span<const SocketAddress> addresses, const QString &name,
                                 Instant timeOut, WakeFlag &wake);

} // namespace codewheel
