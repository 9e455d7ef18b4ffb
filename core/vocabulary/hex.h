// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/word.h"

#include <QString>

#include <optional>

namespace codewheel {

// Eight digits, upper case, as the manuals write them: "020000FF".
QString hexWord(Word word);

// "1388h", with no fewer digits.
QString hexNumber(std::uint32_t number, int digits = 0);

// "020000FF", "0x20000ff", "20000FFh", also with spaces, "16#0200_00FF", the words of a PLC "16#0200
// 16#00FF"; 1 to 8 digits. Empty for anything else: no sign, not both prefix and suffix.
std::optional<Word> parseHexWord(QStringView text);

// Exactly 1 to `longest` hexadecimal digits, at most 15. Empty for anything else.
std::optional<std::int64_t> parseHexDigits(QStringView digits, qsizetype longest);

// A whole number, 0 or more: decimal, or hexadecimal as "0x.." or "..h". Spaces around it are allowed, signs
// are not. Empty for anything else.
std::optional<std::int64_t> parseNumber(QStringView text);

} // namespace codewheel
