// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/known.h"

#include <QString>

#include <optional>

namespace codewheel {

// How a value is known, in words, for window, command line and report alike.
namespace known_words {

// "read", "confirmed", "by hand"
QString word(Evidence evidence);
// "stored", "not stored"; empty: there is nothing to say, or it is not known.
QString word(Kept kept);
// "read, stored"
QString word(Evidence evidence, Kept kept);
// "unknown" if it is not.
QString word(const std::optional<Known> &known);
// In sentences, with what would make it more certain. reads: the encoder can be read.
QString explanation(const std::optional<Known> &known, bool reads);

} // namespace known_words

} // namespace codewheel
