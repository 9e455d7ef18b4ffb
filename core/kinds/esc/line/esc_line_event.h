// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_work.h"
#include "bus/wall_time.h"
#include "kinds/esc/line/esc_line_scan.h"
#include "vocabulary/event.h"
#include "vocabulary/message.h"

#include <variant>

namespace codewheel {

struct ScanProgress
{
    int asked = 0;
    int total = 0;
    std::vector<FoundEncoder> found;
};
struct ScanEnded
{
    std::vector<FoundEncoder> found;
    int requests = 0;
    bool cancelled = false;
};
// How a typed request ended. Sent zero times: it was refused, or dropped.
struct TypedAnswered
{
    esc::Request request;
    esc::ExchangeResult result;
    std::optional<Refusal> refused{};
};
// In place of the adapter that is gone there is one that is not known to be the same.
struct OtherAdapter
{
    Refusal which; // portOfOther
};

// What the line thread reports to the window.
struct EscLineEvent
{
    std::size_t device = 0; // for an Event; meaningless otherwise
    std::variant<Event, Message, esc::EscLineRow, ScanProgress, ScanEnded, TypedAnswered, OtherAdapter, Slept,
                 LinkOpened>
        what;
    Instant at{};

    bool isRow() const { return std::holds_alternative<esc::EscLineRow>(what); } // for the terminal
};

} // namespace codewheel
