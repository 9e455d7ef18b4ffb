// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_work.h"
#include "bus/wall_time.h"
#include "encoder/event.h"
#include "encoder/message.h"
#include "ring/master_link.h"

#include <memory>
#include <variant>
#include <vector>

namespace codewheel {

// Creating the configuration from the ring goes on.
struct ReadInProgress
{
    int devices = 0; // found so far
};
// It has ended. Another ring was told before.
struct ReadInEnded
{
    Result<void> result;
};
// The ring there is: the first one after the link was opened, or another than before. Nothing is exchanged
// until UseRing.
struct RingFound
{
    RingStructure structure;
    std::vector<Word> out; // as they stand on the peer
    // What the master says of it; null: the link reaches no master.
    std::shared_ptr<const MasterStatus> master{};
};
// What the master keeps; nothing: no configuration.
struct KeptConfigurationTold
{
    std::optional<KeptConfiguration> configuration;
};
// What was asked of the ring was refused, or its link is lost.
struct RingRefused
{
    Refusal why;
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

// What the bus thread tells the window; a device is given by its place in the ring of that generation.
struct RingEvent
{
    std::size_t device = 0; // meaningless for what has no place
    std::variant<Event, Exchange, Message, MasterEvent, RingFound, RingRefused, WordWritten, DriverTaken,
                 Slept, LinkOpened>
        what;
    Instant at{};
    unsigned generation = 0;

    bool isRow() const { return std::holds_alternative<Exchange>(what); } // of the trace
};

} // namespace codewheel
