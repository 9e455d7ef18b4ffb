// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_work.h"
#include "bus/wall_time.h"
#include "can/can_link.h"
#include "kinds/canopen/protocol/lss_client.h"
#include "kinds/canopen/protocol/node_scan.h"
#include "kinds/canopen/protocol/sdo_client.h"
#include "vocabulary/event.h"
#include "vocabulary/message.h"

#include <variant>

namespace codewheel {

// A frame that passed.
struct CanopenRow
{
    CanFrame frame{};
    bool isSent = false;      // by us
    bool isTyped = false;     // likewise, by hand
    bool isAutomatic = false; // likewise, to ask what is asked again and again; or the answer
};
// How ended what was sent by hand. Refused: nothing of it was sent.
struct FrameSent
{
    CanFrame frame;
    CanFate fate = CanFate::refused;
    std::optional<Refusal> refused{};
};
struct TransferEnded
{
    canopen::SdoRequest request;
    canopen::SdoOutcome outcome{.kind = canopen::SdoOutcome::Kind::notSent};
    std::optional<Refusal> refused{};
};
struct Configured
{
    canopen::LssRequest request;
    canopen::LssOutcome outcome{.kind = canopen::LssOutcome::Kind::notSent};
    std::optional<Refusal> refused{};
};
struct NodesScanned
{
    int asked = 0; // numbers, of 127
    std::vector<canopen::FoundNode> found{};
    bool isDone = false;
    bool isCancelled = false; // and done with that
};
// It cannot be watched without perhaps acknowledging frames, unless the user agrees.
struct WatchNotSure
{
    Refusal why;
};

// What the thread of a bus reports to the window.
struct CanopenEvent
{
    static constexpr std::size_t mostRows = 60'000; // of a full bus in almost six seconds

    std::size_t device = 0; // for an Event; meaningless otherwise
    std::variant<Event, Message, CanopenRow, FrameSent, TransferEnded, Configured, NodesScanned, WatchNotSure,
                 Slept, LinkOpened>
        what;
    Instant at{};

    bool isRow() const { return std::holds_alternative<CanopenRow>(what); }
};

} // namespace codewheel
