// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/spoken_protocol.h"
#include "kinds/esc/line/exchange_over_link.h"

namespace codewheel {

// What came with a request to one encoder besides its echo and its answer. Strangers: a request of somebody
// else, an answer to one, more than an answer, or bytes at a time at which no answer comes.
OtherBytes othersAround(const esc::Request &request, const EscLineExchange &exchange);

// With a request at the master address, where any number of encoders answers, one over the other or one after
// the other. `after`: what came from the end of the exchange to the end of the time for answers.
OtherBytes othersAtMaster(const EscLineExchange &exchange, const QByteArray &after);

} // namespace codewheel
