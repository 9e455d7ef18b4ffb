// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_object.h"
#include "project/word_list.h"

namespace codewheel {

class JsonWriter;

// The members "holdCycles" and "words" of sequence files and projects.
WordList readWordList(const JsonObject &json);
void writeWordList(JsonWriter &json, const WordList &list);

} // namespace codewheel
