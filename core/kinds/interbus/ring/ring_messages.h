// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"

namespace codewheel {

// What is told only of a ring, its master or its gateway. The comment beside each lists its arguments.
enum class RingMessageId : std::uint8_t {
    alarmStop,        // all OUT words set to 0
    zerosAsked,       // on a gateway: they are on their way
    zerosReadBack,    // of the ALARM STOP, on a gateway
    zerosOverwritten, // they were sent, but something else was read back: text of what is where
    zerosSent,        // and cannot be read back
    zerosWait,        // the link is lost: they go out first once it is back
    zerosLate,        // they were asked for a second ago, and have not arrived: what was in OUT before
    zerosUnheard,     // sent over a lost link; nobody knows whether they arrived
    zerosBeforeRing,  // they are on the gateway, whose ring stands still
    zerosGivenUp,     // disconnected before they arrived
    busFault,         // error code (Word), diagnostic parameter (Word): see bus_fault.h
    busFaultGone,     //
    peripheralFault,  // error code (Word), diagnostic parameter (Word)
    peripheralFaultConfirmed, //
    segmentOff,               // segment
    segmentOn,                // segment
    diagnosticsConfirmed,     //
    ringRead,                 // devices
    configurationActivated,   // file name
    configurationKept,        // file name, devices
    configurationFound,       // file name, devices
    configurationNone,        //
    ringAsConfigured,         // devices
    ringDiffers,              // differences
    faultPlan,                // the step: a TrainingAct
    linkBack,                 // of a ring
    ringRunsAgain,            // as its gateway says
    watchdogAcknowledged,     // of a gateway
};
extern const MessageFamily ringMessages;
constexpr const MessageFamily &familyOf(RingMessageId)
{
    return ringMessages;
}

} // namespace codewheel
