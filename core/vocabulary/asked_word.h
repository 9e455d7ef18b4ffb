// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_word.h"
#include "vocabulary/exchange.h"

namespace codewheel {

// The OUT word that IN of this row may answer. A read-out does not say what it answers: one that was already
// there before OUT changed may answer the previous word, and then there is none. `before`: the previous row,
// or null.
inline std::optional<Word> askedWord(const Exchange &row, const Exchange *before)
{
    const bool isOldReadOut =
        before != nullptr && before->in == row.in && before->out != row.out && k3::isReadOutAnswer(row.in);
    return isOldReadOut ? std::nullopt : std::optional(row.out);
}

} // namespace codewheel
