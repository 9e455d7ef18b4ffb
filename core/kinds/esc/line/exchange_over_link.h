// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_exchange.h"
#include "serial/byte_link.h"

#include <atomic>

namespace codewheel {

// How a request over a link ended, and what passed on the line meanwhile.
struct EscLineExchange
{
    esc::ExchangeResult result;
    std::vector<esc::EscLineRow> rows;
};

// One request over a link of which nobody else makes use, from its first byte to its end.
//
// Refused as the link refuses. `isStopped`: nothing more is sent; ByteLink::interrupt() ends the present
// wait.
Result<EscLineExchange> exchangeOver(ByteLink &link, const esc::Request &request, const esc::Timing &timing,
                                     const std::atomic<bool> &isStopped);

} // namespace codewheel
