// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_word.h"
#include "vocabulary/meaning.h"
#include "vocabulary/mode.h"
#include "vocabulary/position_coding.h"

#include <optional>

namespace codewheel::k3 {

// The makes differ in what D29, the errors and the manufacturer's words mean. An encoder of unknown make may
// be FRABA, and in any of its modes.
enum class Dialect : std::uint8_t { generic, fraba, baumer };

// What the reader of a word knows besides the word. Whatever is not given widens the explanation to all
// possibilities.
struct ExplainContext
{
    WordDirection direction = WordDirection::in;
    Dialect dialect = Dialect::generic;
    std::optional<Mode> mode;             // fraba, generic
    std::optional<PositionCoding> coding; // position words
    std::optional<Word> counterpart;      // the word in the other direction in the same cycle
};

// Total: every one of the 2^32 words gets at least one meaning, undefined ones as undefinedOut / undefinedIn.
Explanation explain(Word word, const ExplainContext &context) noexcept;

} // namespace codewheel::k3
