// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/event.h"
#include "encoder/message.h"

#include <variant>

namespace codewheel {

// What the bus thread tells the window; a device is given by its place in the ring.
struct RingEvent
{
    std::size_t device = 0; // meaningless for messages without a place
    std::variant<Event, Exchange, Message> what;
    Instant at{};
};

} // namespace codewheel
