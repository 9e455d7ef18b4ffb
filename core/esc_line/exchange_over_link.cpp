// SPDX-License-Identifier: GPL-3.0-or-later
#include "esc_line/exchange_over_link.h"

namespace codewheel {

Result<esc::ExchangeResult> exchangeOver(ByteLink &link, const esc::Request &request,
                                         const esc::Timing &timing, const std::atomic<bool> &isStopped)
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
        const auto bytes = link.read(std::get<esc::Exchange::Wait>(action).until);
        if (!bytes)
            return tl::unexpected(bytes.error());
        if (!bytes->isEmpty())
            exchange.received(*bytes, link.now());
    }
    return exchange.result();
}

} // namespace codewheel
