// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"

namespace codewheel {

// What is told only of a bus with CANopen. The comment beside each lists its arguments.
enum class CanopenBusMessageId : std::uint8_t {
    opened,           // link ("training": the simulated bus), rate
    closed,           // link; so for the next one
    back,             //
    otherMasterHeard, // what was heard of it
    nodeDoubled,      //
    heartbeatLost,    //
    heartbeatBack,    //
    loadHigh,         // percent
    nodesFound,       // nodes
    nodesStopped,     // their numbers
    allNodesStopped,  //
    stopsNotSent,     //
    nodeNumbered,     // number before, number now
    deviceNumbered,   // number
    nodeRateStored,   // kBit/s, node, as from then on
    objectWritten,    // object, value
    objectInDoubt,    // object, value
    nmtSent,          // NmtCommand, node; 0: all
    nmtInDoubt,       // likewise
};
extern const MessageFamily canopenBusMessages;
constexpr const MessageFamily &familyOf(CanopenBusMessageId)
{
    return canopenBusMessages;
}

} // namespace codewheel
