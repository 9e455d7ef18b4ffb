// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_engine.h"
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "kinds/interbus/make_driver.h"
#include "kinds/interbus/ring/crc_history.h"
#include "kinds/interbus/ring/ring_checks.h"
#include "kinds/interbus/ring/ring_encoder_session.h"
#include "kinds/interbus/ring/ring_outline.h"
#include "kinds/interbus/ring/ring_runner.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/ring/word_doubts.h"

#include <deque>
#include <memory>
#include <vector>

namespace codewheel {

// What the files of the session share.
struct RingSession::Private
{
    Private(RingSession &bus, std::unique_ptr<ProcessDataLink> usedLink, const Catalog &usedCatalog,
            DriverFactory factory)
        : outline(bus)
        , link(std::move(usedLink))
        , catalog(usedCatalog)
        , driverFor(factory ? std::move(factory) : DriverFactory(makeDriver))
        , engine(bus)
    {}

    command::UseRing makeDevices(RingSession &bus, const RingFound &found);
    static std::unique_ptr<WordChannel> makeChannel(RingSession &bus, const RingDevice &participant);
    // The session at a place of the ring, for `description` if there is one, and its driver.
    std::unique_ptr<CyclicDriver> makeSession(RingSession &bus, std::size_t place,
                                              const DeviceDescription *description);
    const Snapshot &latest() const { return *engine.latest(); }
    bool isStale(std::size_t place) const { return renamings[place] > 0; }
    void retireAll();
    void forgetDevices();
    void endRetired(); // unless handlers may still be looking at them
    void keepEepromWrites(const RingEvent &event);
    // Another ring replaces this one (ring_session_ring.cpp).
    command::UseRing takeOver(RingSession &bus, const RingFound &found);
    std::vector<Word> outNow() const;
    void noteForeign(const Refusal &why);
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
    std::vector<std::deque<DeviceDescription>> retiredDescriptions;
    // Of devices named, or of a ring read in, in the middle of pump().
    std::vector<std::unique_ptr<RingEncoderSession>> retired;
    std::vector<std::unique_ptr<WordChannel>> retiredChannels;
    std::vector<int> renamings; // on their way to the bus thread: until then, the previous driver reports

    std::shared_ptr<RingGuests> guests; // null: none
    Start start = Start::watching;
    unsigned generation = 0; // of the ring; 0: none is used yet
    bool readingIn = false;
    StoppedBy stoppedBy = StoppedBy::other;
    std::optional<Instant> zerosAskedAt{}; // and nothing has been told of them yet; by the link's clock
    bool zerosAreLate = false;
    bool zerosAreBeforeRing = false;
    std::vector<Word> outBeforeZeros{}; // as last seen
    struct Foreign
    {
        Word word = 0;
        std::uint64_t cycle = 0; // a later one shows OUT
    };
    std::map<std::size_t, Foreign> foreign{}; // by device: what somebody else has written
    std::optional<Place> toBringBack{};       // once the ring operates
    CrcHistory crcHistory;
    WordDoubts doubts;
    MasterState toldState = MasterState::ready;
    BusEngine<RingRunner, RingSession> engine; // destroyed before what its drivers use
};

} // namespace codewheel
