// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/la66_word.h"
#include "vocabulary/meaning.h"

#include <optional>

namespace codewheel::la66 {

// Total: every one of the 2^32 words gets one meaning, undefined ones as undefinedOut / undefinedIn.
// `counterpart` is the word in the other direction in the same cycle, where known: it shows whether an answer
// belongs to an earlier service.
Explanation explain(Word word, WordDirection direction, std::optional<Word> counterpart) noexcept;

} // namespace codewheel::la66
