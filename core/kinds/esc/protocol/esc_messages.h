// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"

namespace codewheel {

// What is told only of a serial line with ESC encoders. The comment beside each lists its arguments.
enum class EscMessageId : std::uint8_t {
    typedWritten,       // what was typed: see typedText() (esc_explain.h)
    lineOpened,         // port ("training": the simulated line), baud rate
    lineClosed,         // port; so for the other messages about one
    portLost,           // port
    portBack,           // port
    lowLatencyRefused,  // port
    suspectPosition,    // the position that jumped, the position before
    lineAddressChanged, // address before, address now
    baudRateChanged,    // baud rate before, baud rate now
    encodersFound,      // encoders, requests
};
extern const MessageFamily escMessages;
constexpr const MessageFamily &familyOf(EscMessageId)
{
    return escMessages;
}

} // namespace codewheel
