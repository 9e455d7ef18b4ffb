// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/explain_word.h"
#include "vocabulary/exchange.h"

namespace codewheel {

// What both words of a row of a handshake trace mean.
struct ExplainedExchange
{
    Explanation out;
    Explanation in;
};

// `asked`: the OUT word that IN answers, if known (vocabulary/asked_word.h).
ExplainedExchange explainExchange(const DeviceDescription &device, const Exchange &row,
                                  std::optional<Word> asked);

// Both in one sentence like the manual's: "Parameter 1 steps = 255: confirmed".
QString exchangeText(const DeviceDescription &device, const Exchange &row, std::optional<Word> asked);

} // namespace codewheel
