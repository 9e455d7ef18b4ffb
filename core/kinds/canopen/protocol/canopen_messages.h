// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"

namespace codewheel {

// What is told only of nodes on CANopen. The comment beside each lists its arguments.
enum class CanopenMessageId : std::uint8_t {
    emergency,        // Word error code, Word error register
    emergencyGone,    //
    nodeBooted,       // unasked
    speedStandsStill, // object: it is 0 while the position moves
    speedIsOpposite,  // object: its sign is not that of the position
    identifierKept,   // object, Word identifier, Word that which is predefined for the number of the node
};
extern const MessageFamily canopenMessages;
constexpr const MessageFamily &familyOf(CanopenMessageId)
{
    return canopenMessages;
}

} // namespace codewheel
