// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/mode.h"
#include "vocabulary/position_coding.h"
#include "vocabulary/word.h"

#include <optional>

namespace codewheel {

// What the reader of a word knows besides the word and whose it is. Whatever is not given widens the
// explanation to all possibilities.
struct WordContext
{
    WordDirection direction = WordDirection::in;
    std::optional<Mode> mode{};
    std::optional<PositionCoding> coding{}; // of positions
    std::optional<Word> counterpart{};      // the word in the other direction in the same cycle
};

} // namespace codewheel
