// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "words/meaning.h"

#include <QStringList>

namespace codewheel {

// Language-neutral name for JSON: "parameterRequest".
QString meaningKey(MeaningId id);

// The sentence of a meaning in the user's language, with its parts as texts. Which parts a meaning has, and
// how a device calls them, is known to catalog/explain_word.h, which is what views ask.
QString meaningSentence(MeaningId id, const QStringList &parts);

// A parameter word outside cam mode, whatever the encoder makes of its number and its value.
bool asksForParameter(MeaningId id);

// The positions, speeds and cams of an encoder in operation; their sentences go on from "Running, ...".
bool isOfOperation(MeaningId id);

} // namespace codewheel
