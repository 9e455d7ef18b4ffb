// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cams/cam_fields.h"
#include "vocabulary/word.h"

// The words for the values of a cam program (FRABA manual 10.5).
namespace codewheel {

// The word that sets the field, and the one that reads it out; only for fields a K3 has.
Word settingWord(CamField field, std::int64_t data);
Word readOutWord(CamField field);
// The field that OUT sets in cam mode, or reads out. Empty: none, or of a cam that does not exist.
std::optional<CamField> fieldSetBy(Word out);
std::optional<CamField> fieldReadBy(Word out);
// The data of a word that sets a field.
std::int64_t dataOf(CamField field, Word out);

} // namespace codewheel
