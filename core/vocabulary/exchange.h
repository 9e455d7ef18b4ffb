// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"
#include "vocabulary/mode.h"
#include "vocabulary/position_coding.h"
#include "vocabulary/word.h"

#include <optional>

namespace codewheel {

// One row of a handshake trace: what OUT and IN held in one cycle. A row is kept when OUT changed, when
// D31..D25 of IN changed, or when IN changed while it held anything but a position.
struct Exchange
{
    std::uint64_t cycle = 0;
    Instant at{};
    Word out = 0;
    Word in = 0;
    std::optional<Mode> mode;
    std::optional<PositionCoding> coding;
    bool outIsKnown = true; // a gateway may not show it
    bool isAnswered = true; // false: the link was lost in this cycle; `in` is the last word seen

    friend bool operator==(const Exchange &, const Exchange &) = default;
};

} // namespace codewheel
