// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

namespace codewheel {

// What is refused only at a gateway, or where a ring is offered as one. The comment beside each lists its
// arguments.
enum class GatewayRefusalId : std::uint8_t {
    linkSettingWrong,     // setting, the text given, what is allowed
    linkSettingUnknown,   // setting, the settings there are
    registerMapWrong,     // sentence about what is wrong
    gatewayHasNoDevices,  //
    watchdogNotSet,       //
    outNotReadBack,       //
    noIdCycle,            //
    outNotOurs,           // place, Word OUT of ours, Word OUT found there
    wordNotSteady,        // place
    ringStands,           // status register of the gateway
    ringFailed,           // the same
    ringFailedAt,         // status register of the gateway, text of the place
    realRingNotOffered,   //
    closedRingNotOffered, //
    closedUnanswered,     // link
    registersUnanswered,  // link, registers (registersKey()), tries
    registersLate,        // the same; answers come too late
    registersRefused,     // link, registers, code of the exception
    registersGarbled,     // link, registers, what was wrong (wrongAnswerKey())
    outAreaTooShort,      // link, registers
    outputsBlocked,       // link, registers
    outsOfOther,          // somebody else writes to the outputs of the bus
};
extern const RefusalFamily gatewayRefusals;
constexpr const RefusalFamily &familyOf(GatewayRefusalId)
{
    return gatewayRefusals;
}

} // namespace codewheel
