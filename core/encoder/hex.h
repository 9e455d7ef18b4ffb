// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "words/k3_word.h"

#include <QString>

#include <optional>

namespace codewheel {

// Eight digits, upper case, as the manuals write them: "020000FF".
QString hexWord(Word word);

// "020000FF", "0x20000ff", "20000FFh", with spaces; at most 8 digits. Nothing for anything else.
std::optional<Word> parseHexWord(QStringView text);

// Decimal unless "0x.." or "..h". Nothing for anything else.
std::optional<std::int64_t> parseNumber(QStringView text);

} // namespace codewheel
