// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/meaning.h"

#include <QStringList>

namespace codewheel {

// Language-neutral name for JSON: "parameterRequest".
QString meaningKey(MeaningId id);

// The sentence for a meaning in the user's language, with its parts as texts. Which parts a meaning has, and
// what a device calls them, is the business of catalog/explain_word.h, which is what views use.
QString meaningSentence(MeaningId id, const QStringList &parts);

// A parameter word outside cam mode, whatever the encoder makes of its number and value.
bool asksForParameter(MeaningId id);

// The positions, speeds and cams of an encoder in operation; their sentences continue "Running, ...".
bool isOfOperation(MeaningId id);
bool isOfOperation(const Explanation &explanation); // all of them

} // namespace codewheel
