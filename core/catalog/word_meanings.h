// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/word_form.h"
#include "vocabulary/meaning.h"
#include "vocabulary/word_context.h"

#include <QStringList>

namespace codewheel {

struct DeviceDescription;

// What the words of an encoder mean, as its protocol knows it. One object per protocol that has words; views
// ask explain_word.h.
class WordMeanings
{
public:
    virtual ~WordMeanings() = default;

    // Total: every word gets at least one meaning. What the context leaves out is taken from the description.
    virtual Explanation explain(const DeviceDescription &device, Word word,
                                const WordContext &context) const = 0;
    // The parts of a meaning's sentence (vocabulary/meaning_text.h) as this device calls them.
    virtual QStringList parts(const DeviceDescription &device, const Meaning &meaning) const = 0;
    // What a single bit means, 0..31.
    virtual QString bitText(const DeviceDescription &device, WordDirection direction, int bit) const = 0;
    // How the word of 32 bits is divided.
    virtual WordForm form() const { return {}; }
    // Whether this IN word does not say which OUT word it answers.
    virtual bool answersUnnamed(Word in) const = 0;
};

} // namespace codewheel
