// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/ring/link_figures.h"
#include "kinds/interbus/ring/master_status.h"
#include "kinds/interbus/ring/ring_refusals.h"
#include "kinds/interbus/ring/told_ring.h"
#include "vocabulary/reading.h"
#include "vocabulary/refusal.h"

#include <memory>
#include <optional>
#include <vector>

namespace codewheel {

// What concerns the ring as a whole.
struct RingState
{
    unsigned generation = 0;          // counts the rings used since the link was opened; 0: none yet
    bool connected = false;           // false: the link is lost
    std::optional<Refusal> whyLost{}; // while it is lost
    std::uint64_t cycle = 0;
    Instant at{};
    MasterState state = MasterState::ready;
    bool operate = false;           // writing is allowed
    bool zerosAreDue = false;       // of an ALARM STOP: they have not arrived yet
    bool outputsAreBlocked = false; // by the gateway, it seems: its watchdog has tripped
    std::optional<ToldRing> told{}; // by a gateway; empty: it does not tell
    // The fault that the last start met in READY, where the master does not look at the ring.
    std::optional<Refusal> refusedStart{};
    Instant awakeSince{};              // the computer slept until then; 0: not since the bus was opened
    Instant linkBackSince{};           // it was lost before; 0: never since the bus was opened
    std::uint64_t lateCycles = 0;      // counted by the paced thread since it started
    std::chrono::nanoseconds period{}; // of the paced thread; 0 when cycles are driven by hand
    std::uint64_t droppedRows = 0;     // trace rows lost because nobody took them
    // What the master says, created anew when it changes; null: the link reaches no master.
    std::shared_ptr<const MasterStatus> master{};
    std::shared_ptr<const LinkFigures> figures{}; // null: the link keeps none
};

// The ring after one cycle, with the bits that changed in any cycle since the last snapshot was taken.
struct Snapshot : RingState
{
    struct Device
    {
        Word out = 0;
        Word in = 0;
        Word outEdges = 0;
        Word inEdges = 0;
        Reading reading;
        bool heldByJob = false;
        bool outIsKnown = true; // false: the peer does not tell it, and we sent none yet
        Word outBefore =
            0; // the word before this one: it is in OUT still if one that was acknowledged got lost
        bool outIsFound = false; // it was there when the link was opened, and nobody has sent another since
        std::optional<Word> leftOut{}; // of a job that lost its link: OUT may still hold it
        bool inIsKnown = false;        // a word has come from it
        bool inRing = true; // false: switched off with its segment, or behind a fault; its IN is an old one
    };

    std::vector<Device> devices; // in ring order

    // Becomes the newer one, which only has the edges of its own cycle, and keeps its own edges. Allocates
    // nothing unless that one is of another ring.
    void giveWayTo(const Snapshot &newer);
    // A gateway is read, and no two reads of the device's word agree.
    bool isUnsettled(std::size_t device) const
    {
        return figures != nullptr && !(told && told->stands()) && device < devices.size() &&
               !devices[device].inRing;
    }
    // Why nothing can be sent to the device or read from it.
    Refusal whyOutOfSight(std::size_t device, const QString &place) const
    {
        return {RefusalKind::link,
                isUnsettled(device) ? RefusalCode(GatewayRefusalId::wordNotSteady) : RingRefusalId::notInRing,
                {place}};
    }
};

} // namespace codewheel
