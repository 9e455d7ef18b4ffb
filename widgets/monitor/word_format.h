// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "words/k3_word.h"

#include <QString>

namespace codewheel {

// How the fields of a monitor write a word. Numbers are those of the lowest `bits` bits: 25 for D24..D0 of a
// K3, or 16 or 32 for the whole word. They have no group separators, since they are copied into other
// programs.
QString decimalText(Word word, int bits);
QString signedText(Word word, int bits); // two's complement
QString grayText(Word word, int bits);   // what the bits give when they are read as Gray code
QString binaryText(Word word, int bits); // "0000 0010 ...", by nibbles

// As a PLC sees a 32-bit word, high word first: "0200 00FF".
QString plcWordsText(Word word);

// Why a text is no hexadecimal word, in a sentence; empty where it is one.
QString hexProblem(const QString &text);

} // namespace codewheel
