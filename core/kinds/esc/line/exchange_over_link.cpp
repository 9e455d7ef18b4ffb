// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/exchange_over_link.h"

#include <algorithm>

namespace codewheel {

Result<EscLineExchange> exchangeOver(ByteLink &link, const esc::Request &request, const esc::Timing &timing,
                                     const std::atomic<bool> &isStopped)
{
    esc::Exchange exchange(request, timing);
    for (;;) {
        const auto action = exchange.next(link.now());
        if (std::holds_alternative<esc::Exchange::Done>(action) || isStopped)
            break;
        if (const auto *send = std::get_if<esc::Exchange::Send>(&action)) {
            if (auto written = link.write(send->bytes); !written)
                return tl::unexpected(written.error());
            continue;
        }
        const Instant until = std::get<esc::Exchange::Wait>(action).until;
        const auto bytes = link.read(until);
        if (!bytes)
            return tl::unexpected(bytes.error());
        if (!bytes->isEmpty())
            exchange.received(*bytes, std::min(link.now(), until)); // a computer that is busy reads late
    }
    return EscLineExchange{exchange.result(), exchange.takeRows()};
}

} // namespace codewheel
