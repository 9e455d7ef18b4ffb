// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "drivers/make_driver.h"
#include "ring/bus_session.h"
#include "ring/crc_history.h"
#include "ring/paced_thread.h"
#include "ring/ring_encoder_session.h"
#include "ring/ring_outline.h"
#include "ring/ring_runner.h"

#include <deque>

namespace codewheel {

// What the files of the session share.
struct BusSession::Private
{
    Private(const BusSession &bus, std::unique_ptr<ProcessDataLink> usedLink, const Catalog &usedCatalog,
            DriverFactory factory)
        : outline(bus)
        , link(std::move(usedLink))
        , catalog(usedCatalog)
        , driverFor(factory ? std::move(factory) : DriverFactory(makeDriver))
    {}

    const DeviceDescription *describe(const Participant &participant) const;
    RingRunner::Drivers makeDevices(BusSession &bus);
    static std::unique_ptr<WordChannel> makeChannel(BusSession &bus, const Participant &participant);
    // The session at a place of the ring, for `description` if there is one, and its driver.
    std::unique_ptr<CyclicDriver> makeSession(BusSession &bus, std::size_t place,
                                              const DeviceDescription *description);
    Freshness::Circumstances circumstances(std::size_t place) const;
    bool isStale(std::size_t place) const { return renamings[place] > 0; }
    void fetch();
    void keepEepromWrites(const RingEvent &event);
    // The ring that was read in takes the place of this one (bus_session_ring.cpp).
    RingRunner::Drivers takeOver(BusSession &bus, RingStructure found, RingRunner::Drivers drivers);
    std::size_t indexOf(NodeId node) const; // structure.size(): no such device

    const RingOutline outline;
    std::unique_ptr<ProcessDataLink> link;
    const Catalog &catalog;
    DriverFactory driverFor;

    // What was found by open(), in ring order.
    RingStructure structure;
    std::deque<DeviceDescription> descriptions;                // of those that have a session
    std::vector<std::unique_ptr<RingEncoderSession>> sessions; // null: no driver
    std::vector<std::unique_ptr<WordChannel>> channels;
    // Of devices named, or of a ring read in, in the midst of pump().
    std::vector<std::unique_ptr<RingEncoderSession>> retired;
    std::vector<std::unique_ptr<WordChannel>> retiredChannels;
    std::vector<int> renamings;          // on their way to the bus thread: what comes is of the driver before
    std::unique_ptr<RingRunner> runner;  // null: closed
    std::unique_ptr<PacedThread> thread; // null: cycles by hand

    std::shared_ptr<const Snapshot> latest = std::make_shared<Snapshot>();
    bool latestIsNew = false;
    std::deque<RingEvent> events; // fetched, not told yet
    bool pumping = false;
    bool readingIn = false;
    CrcHistory crcHistory;
    std::optional<RingStructure> otherRing; // that the master has active now
    MasterState toldState = MasterState::ready;
    bool toldOperate = false;
};

} // namespace codewheel
