// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asked_snapshot.h"
#include "kinds/esc/line/esc_line_figures.h"
#include "serial/byte_link.h"

namespace codewheel {

// The line as it is, with what determines whether anything may be sent.
struct LineState : AskingState
{
    bool otherAdapter = false; // the port is gone, and there is one that is not known to be this line's
    LowLatency lowLatency = LowLatency::notApplicable;

    friend bool operator==(const LineState &, const LineState &) = default;
};
struct EscLineDevice : AskedDevice
{
    EscLineFigures figures{};
};

// The line after one exchange.
struct EscLineSnapshot : AskedSnapshot<LineState, EscLineDevice>
{
    bool scanning = false;
    EscLineFigures figures{};

    void giveWayTo(const EscLineSnapshot &newer) { *this = newer; }
};

} // namespace codewheel
