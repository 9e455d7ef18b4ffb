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

// The OUT word that IN of this row may answer. A read-out does not say what it answers: one that was already
// there before OUT changed may answer the previous word, and then there is none. `before`: the previous row,
// or null.
std::optional<Word> askedWord(const DeviceDescription &device, const Exchange &row, const Exchange *before);

// `asked`: the OUT word that IN answers, if known.
ExplainedExchange explainExchange(const DeviceDescription &device, const Exchange &row,
                                  std::optional<Word> asked);

// Both in one sentence like the manual's: "Parameter 1 steps = 255: confirmed".
QString exchangeText(const DeviceDescription &device, const Exchange &row, std::optional<Word> asked);

} // namespace codewheel
