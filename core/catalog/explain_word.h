// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "catalog/value_text.h"
#include "vocabulary/meaning_text.h"
#include "vocabulary/word_context.h"

namespace codewheel {

// The meanings of a word of this device; what the context leaves out is taken from the description. Of an
// encoder without words: undefined.
Explanation explainWord(const DeviceDescription &device, Word word, const WordContext &context);

// The sentence for them, with the device's parameter names and choices: "Parameter 1 steps = 255",
// "Running, position 76 367". Several meanings are joined with "or".
QString explanationText(const DeviceDescription &device, const Explanation &explanation);

// What a single bit means, for tooltips: "D28..D25: parameter number". Empty for a bit outside 0..31.
QString bitText(const DeviceDescription &device, WordDirection direction, int bit);

} // namespace codewheel
