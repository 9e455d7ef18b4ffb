// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asked_snapshot.h"
#include "can/can_link.h"
#include "kinds/canopen/bus/other_master.h"
#include "kinds/canopen/bus/sync_heard.h"
#include "kinds/canopen/protocol/kept_identifier.h"
#include "kinds/canopen/protocol/node_watch.h"
#include "kinds/canopen/protocol/pdo_mapping.h"
#include "vocabulary/find_by.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace codewheel {

// The adapter may be gone, or have left the bus.
struct CanopenState : AskingState
{
    OtherMaster otherMaster{};
    bool onlyJ1939 = false;    // is heard: what is there is of another variant
    bool besideOthers = false; // the user agrees to sending all the same
    bool scanning = false;
    bool stopsWait = false; // those of an ALARM STOP are not sent yet

    // Nothing is sent, for the sake of others.
    bool isHeldBack() const { return (otherMaster.isHeard() || onlyJ1939) && !besideOthers; }
    friend bool operator==(const CanopenState &, const CanopenState &) = default;
};

// For whose sake; empty: it is not held back.
std::optional<Refusal> whyHeldBack(const CanopenState &bus);
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

    // What is there is of another variant.
    bool isOnlyJ1939() const { return received > 0 && extended == received; }
    // The rate may be wrong, or nobody there.
    bool isNothingHeard() const { return received == 0; }
    static constexpr double highLoad = 0.85; // from here on frames of low priority may not come

    friend bool operator==(const CanopenFigures &, const CanopenFigures &) = default;
};

// The bus as it is now.
struct CanopenSnapshot : AskedSnapshot<CanopenState, AskedDevice>
{
    // Of one that was heard.
    struct Node
    {
        int node = 0;
        std::optional<canopen::NmtState> state{};     // as it has shown
        std::optional<canopen::NmtState> commanded{}; // otherwise, as it was told to
        canopen::Heartbeat heartbeat = canopen::Heartbeat::notHeard;
        bool isDoubled = false;
        int secondAnswers = 0; // more SDO answers than requests
        bool sendsPdos = false;
        bool hasBooted = false; // and neither shown its state nor been commanded since
        int bootUps = 0;
        int unaskedBootUps = 0;                      // without a reset before
        std::optional<canopen::Emcy> error{};        // the newest that stands
        std::optional<canopen::PdoTerms> position{}; // when the PDO with its position comes, as read
        std::optional<std::uint32_t> deviceType{};   // 1000h, as read
        std::optional<Instant> heartbeatTime{};      // 1017h, likewise; 0: it has none
        std::vector<canopen::KeptIdentifier> kept{}; // likewise, that are not those of its number
        Instant heardAt{};
        std::optional<Instant> pdoAt{}; // the last one, since it was operational

        std::optional<canopen::NmtState> stateOrCommanded() const { return state ? state : commanded; }
    };

    CanStatus status{};
    CanopenFigures figures{};
    SyncHeard sync{};
    std::vector<Node> nodes;  // by number
    std::vector<int> stopped; // last known as such, whether they were heard or not

    const Node *heard(int node) const { return findBy(nodes, node, &Node::node); } // null: it was not
    // It answers nothing, and is there all the same.
    bool isStopped(int node) const { return std::ranges::count(stopped, node) != 0; }
    void giveWayTo(const CanopenSnapshot &newer) { *this = newer; }
};

} // namespace codewheel
