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

// Whether a K3 of this make can have sent a word, whatever it was asked: explain() is total and says what a
// word would mean, this says whether it comes from an encoder at all. For checking how words are put together
// from registers. In operation D29..D25 are 0; in the other states number and data are those the manuals know
// (FRABA manual 5.2, 10.1 to 10.6; Baumer manual 2.3, 7).
bool canSend(Word in, Dialect dialect) noexcept;

} // namespace codewheel::k3
