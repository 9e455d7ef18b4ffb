// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"

namespace codewheel {

// What is told of a simulated ring that is offered to others as a gateway. The comment beside each lists its
// arguments.
enum class OfferMessageId : std::uint8_t {
    offerBegun,              // where a simulated ring is offered to others: "127.0.0.1:1502"
    offerEnded,              // where it was offered; so for the next four
    offerEndedWithRing,      // the ring was closed
    offerEndedWithStructure, // another ring was read in
    offerEndedWithProject,   // another project was opened
    offerEndedWithRealRing,  // a real ring is used now
    clientCame,              // address of a client of the offered ring
    clientLeft,              // address, requests, writes
    clientRefused,           // address
    clientsPassed,           // of many in a short time: how many came, left, were refused
    seatRestarted,           // unit
};
extern const MessageFamily offerMessages;
constexpr const MessageFamily &familyOf(OfferMessageId)
{
    return offerMessages;
}

} // namespace codewheel
