// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_explain.h"

#include <span>
#include <vector>

namespace codewheel {

// What happens to the encoder before a row of the appendix is tested.
enum class Happening { nothing, turnsAt1500Rpm, turnsAt6000Rpm, losesItsParameters, startsUp };

// A row of the FRABA manual's appendix (10.1 to 10.6): OUT, and the answer in IN.
//
// The encoder is multi-turn with 8192 steps and stands at 00003039h = 12345; its serial number is 4711, and
// it has been in operation for 990 minutes.
struct AppendixRow
{
    const char *section;
    const char *name;     // as printed
    const char *printed;  // its hexadecimal column, x: any digit
    WordDirection column; // which of the two words the column shows
    Mode mode;            // in which the encoder answers
    Happening happening;
    std::vector<Word> before; // bring the encoder to where the row applies
    Word out;
    Word in;
    Meaning outMeans;
    Meaning inMeans;
    const char *outText;
    const char *inText;
    int cycles = 6; // that OUT is held before IN is read
};

// Contains every row at least once.
std::span<const AppendixRow> frabaAppendix();

} // namespace codewheel
