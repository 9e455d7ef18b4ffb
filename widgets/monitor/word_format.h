// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/word.h"

#include <QString>

namespace codewheel {

// How the fields of a monitor write a word. Numbers are those of the lowest `bits` bits: 25 for D24..D0 of a
// K3, or 16 or 32 for the whole word. They have no group separators, since they are pasted into other
// programs.
QString decimalText(Word word, int bits);
QString signedText(Word word, int bits); // two's complement
QString grayText(Word word, int bits);   // the bits read as Gray code
QString binaryText(Word word, int bits); // "0000 0010 ...", by nibbles

// Notations of a word of 16 or 32 bits for other programs: "020000FF", "16#0200_00FF", "16#0200 16#00FF" (the
// two words of a PLC, high word first), "33554687", "2#0000_0010_...". The sequence reads back all but the
// last two.
enum class WordNotation : std::uint8_t { hexadecimal, plc, plcWords, decimal, binary };
QString copiedText(Word word, int bits, WordNotation notation);

// Why a text is no hexadecimal word, in a sentence; empty if it is one.
QString hexProblem(const QString &text);

} // namespace codewheel
