// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/wall_time.h"
#include "encoder/event.h"
#include "encoder/message.h"
#include "ring/master_link.h"

#include <variant>

namespace codewheel {

// Creating the configuration from the ring goes on.
struct ReadInProgress
{
    int devices = 0; // found so far
};
// It has ended: the ring the master has active now, or why not.
struct ReadInEnded
{
    Result<RingStructure> found;
};
// What the master keeps; nothing: no configuration.
struct KeptConfigurationTold
{
    std::optional<KeptConfiguration> configuration;
};
// The word of a SetOut stands on the bus.
struct WordWritten
{
    Word word;
};
// A SetDriver was carried out: what comes of the device from now on is of its new driver.
struct DriverTaken
{};
using MasterEvent = std::variant<ReadInProgress, ReadInEnded, KeptConfigurationTold>;

// What the bus thread tells the window; a device is given by its place in the ring.
struct RingEvent
{
    std::size_t device = 0; // meaningless for what has no place
    std::variant<Event, Exchange, Message, MasterEvent, WordWritten, DriverTaken, Slept> what;
    Instant at{};

    bool isRow() const { return std::holds_alternative<Exchange>(what); } // of the trace
};

} // namespace codewheel
