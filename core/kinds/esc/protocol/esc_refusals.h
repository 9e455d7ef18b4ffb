// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

namespace codewheel {

// What only an ESC encoder or its line refuses. The comment beside each lists its arguments.
enum class EscRefusalId : std::uint8_t {
    lineAddressWrong,    // the text given
    lineAddressNotAlone, // address, text of another encoder of the line
    commandUnknown,      // command: the encoder answered 03
    outOfRange,          // command with its data: the encoder answered 05
    notSentInTime,       // seconds without an answer since it was confirmed
    readsDisagree,       // Parameter, one value, the other
    writeUnknown,        // command: no answer, and what the encoder has now could not be read
    writeNotDone,        // command: no answer, and the encoder has the old value
    presetUnproven,      // command, preset: accepted, but neither S nor the position shows it
    notFoundAgain,       // where it was looked for
    factorFitsNothing,   // factor, steps, measuring range, as reported by the encoder
};
extern const RefusalFamily escRefusals;
constexpr const RefusalFamily &familyOf(EscRefusalId)
{
    return escRefusals;
}

} // namespace codewheel
