// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_explain.h"

namespace codewheel::k3 {

// Whether a K3 of this make can have sent a word, whatever it was asked: explain() is total and says what a
// word would mean, this says whether it comes from an encoder at all. For checking how words are put together
// from registers. In operation D29..D25 are 0; in the other states number and data are those the manuals know
// (FRABA manual 5.2, 10.1 to 10.6; Baumer manual 2.3, 7).
bool canSend(Word in, Dialect dialect) noexcept;

} // namespace codewheel::k3
