// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

namespace codewheel {

// What only an encoder that is spoken to in words refuses: a K3 or an LA-66. The comment beside each lists
// its arguments.
enum class WordRefusalId : std::uint8_t {
    readOutUnknown,         // A4xxxxxx: code, Word IN
    unknownState,           // Word IN
    restarted,              // Word IN: parameterization ended without run
    camWordRefused,         // Word OUT, Word IN: the text says what the word does
    camsInParameterization, // Word OUT, Word IN: a parameterization that was already open before the job
    camPositionAboveRange,  // cam, Word IN; or Word IN alone if the cam is not known
    lostInCamMode,          // error 3 in cam mode: Word IN
    camVerificationFailed,  // program
    serviceRefused,         // service number, Word IN
    wordsTorn,              // Word IN: one of the answers that do not agree
};
extern const RefusalFamily wordRefusals;
constexpr const RefusalFamily &familyOf(WordRefusalId)
{
    return wordRefusals;
}

} // namespace codewheel
