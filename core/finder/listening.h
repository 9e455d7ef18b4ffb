// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "serial/byte_link.h"

#include <atomic>

namespace codewheel {

// All that comes by then. Refused as the link refuses.
inline Result<QByteArray> hearUntil(ByteLink &link, Instant until, const std::atomic<bool> &isStopped)
{
    QByteArray heard;
    while (link.now() < until && !isStopped) {
        const auto bytes = link.read(until);
        if (!bytes)
            return tl::unexpected(bytes.error());
        heard += *bytes;
    }
    return heard;
}

} // namespace codewheel
