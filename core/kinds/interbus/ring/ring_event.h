// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_work.h"
#include "bus/wall_time.h"
#include "kinds/interbus/ring/master_link.h"
#include "vocabulary/event.h"
#include "vocabulary/message.h"

#include <memory>
#include <variant>
#include <vector>

namespace codewheel {

// Creating the configuration from the ring is progressing.
struct ReadInProgress
{
    int devices = 0; // found so far
};
// It has ended. If the ring is a different one, that was reported before.
struct ReadInEnded
{
    Result<void> result;
};
// The ring that is there: the first one after the link was opened, or a different one than before. Nothing is
// exchanged until UseRing.
struct RingFound
{
    RingStructure structure;
    std::vector<Word> out; // as they are on the peer
    // What the master says about it; null: the link reaches no master.
    std::shared_ptr<const MasterStatus> master{};
    bool outIsKnown = true;                       // false: the peer does not tell it
    std::shared_ptr<const LinkFigures> figures{}; // of the link; null: it keeps none
};
// What the master stores; empty: no configuration.
struct KeptConfigurationTold
{
    std::optional<KeptConfiguration> configuration;
};
// A request to the ring was refused, or its link is lost.
struct RingRefused
{
    Refusal why;
};
// The word of a SetOut is on the bus.
struct WordWritten
{
    Word word;
};
// A guest of the ring has changed the word (ring_guests.h).
struct GuestWrote
{
    Word word;
};
// A SetDriver was carried out: what comes from the device from now on is from its new driver.
struct DriverTaken
{};
using MasterEvent = std::variant<ReadInProgress, ReadInEnded, KeptConfigurationTold>;

// What the bus thread reports to the window; a device is given by its index in the ring of that generation.
struct RingEvent
{
    std::size_t device = 0; // meaningless for what has no place
    std::variant<Event, Exchange, Message, MasterEvent, RingFound, RingRefused, WordWritten, GuestWrote,
                 DriverTaken, Slept, LinkOpened>
        what;
    Instant at{};
    unsigned generation = 0;

    bool isRow() const { return std::holds_alternative<Exchange>(what); } // for the trace
};

} // namespace codewheel
