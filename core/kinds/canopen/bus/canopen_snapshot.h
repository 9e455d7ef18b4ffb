// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link.h"
#include "kinds/canopen/bus/other_master.h"
#include "kinds/canopen/protocol/node_watch.h"
#include "vocabulary/reading.h"

#include <cstdint>
#include <vector>

namespace codewheel {

// What determines whether anything may be sent.
struct CanopenState
{
    bool connected = false;           // false: the adapter is gone, or has left the bus
    std::optional<Refusal> whyLost{}; // while it is
    bool running = false;             // drivers are asked
    bool operate = false;             // frames may be sent
    OtherMaster otherMaster{};
    bool besideOthers = false; // the user agrees to that
    bool scanning = false;
    bool stopsWait = false; // those of an ALARM STOP are not sent yet

    bool isHeldBack() const { return otherMaster.isHeard() && !besideOthers; }
    friend bool operator==(const CanopenState &, const CanopenState &) = default;
};

// Why nothing may be sent to `place` now; it may be empty.
Result<void> maySend(const CanopenState &bus, const QString &place);
// Nor a job started there.
Result<void> mayStart(const CanopenState &bus, const QString &place);

// Since the bus was opened.
struct CanopenFigures
{
    std::uint64_t received = 0;
    std::uint64_t sent = 0;
    std::uint64_t notSent = 0;         // refused by the adapter
    std::uint64_t errorFrames = 0;     //
    std::uint64_t notAcknowledged = 0; // among them, those since a frame was last received
    std::uint64_t extended = 0;        // of 29 bits
    std::uint64_t answersOfOthers = 0; // SDO answers that we did not ask for
    std::uint64_t lateAnswers = 0;
    double load = 0; // share of the last second

    friend bool operator==(const CanopenFigures &, const CanopenFigures &) = default;
};

// The bus as it is now.
struct CanopenSnapshot : CanopenState
{
    struct Device
    {
        int node = 0;
        Reading reading{};
        bool hasJob = false;
        bool present = true; // false: it has been removed
        bool answers = true; // its last request was answered
    };
    // Of one that was heard.
    struct Node
    {
        int node = 0;
        std::optional<canopen::NmtState> state{};
        canopen::Heartbeat heartbeat = canopen::Heartbeat::notHeard;
        bool isDoubled = false;
        bool sendsPdos = false;
        int bootUps = 0;
        std::optional<canopen::Emcy> error{}; // the newest that stands
        std::uint32_t otherIdentifier = 0;    // of a PDO, as read, where it is not predefined
        Instant heardAt{};
    };

    Instant at{};
    Instant awakeSince{}; // the computer slept until then; 0: not since the bus was opened
    CanStatus status{};
    CanopenFigures figures{};
    std::uint64_t droppedRows = 0; // rows lost because nobody took them
    std::vector<Device> devices;
    std::vector<Node> nodes; // by number

    const Node *heard(int node) const; // null: it was not
    void giveWayTo(const CanopenSnapshot &newer) { *this = newer; }
};

} // namespace codewheel
