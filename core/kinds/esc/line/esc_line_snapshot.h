// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/esc_line_figures.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "serial/byte_link.h"
#include "vocabulary/freshness.h"
#include "vocabulary/reading.h"
#include "vocabulary/refusal.h"

#include <optional>
#include <vector>

namespace codewheel {

// What determines whether anything may be sent.
struct LineState
{
    bool connected = false;           // false: the port is gone
    std::optional<Refusal> whyLost{}; // while it is gone
    bool otherAdapter = false;        // there is one that is not known to be this line's
    LowLatency lowLatency = LowLatency::notApplicable;
    bool polling = false;
    bool operate = false; // writing is allowed

    friend bool operator==(const LineState &, const LineState &) = default;
};

// The line after one exchange.
struct EscLineSnapshot : LineState
{
    struct Device
    {
        EscLineAddress address;
        Reading reading;
        bool hasJob = false;
        bool present = true; // false: it has been removed
        EscLineFigures figures;
        Instant lateAfter = Freshness::lateAfter; // by the pace at which its positions come
        bool answers = true;                      // its last request was answered
    };

    Instant at{};
    Instant awakeSince{}; // the computer slept until then; 0: not since the line was opened
    bool scanning = false;
    EscLineFigures figures;
    std::uint64_t droppedRows = 0; // terminal rows lost because nobody took them
    std::vector<Device> devices;

    void giveWayTo(const EscLineSnapshot &newer) { *this = newer; }
};

} // namespace codewheel
