// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/bus_fault.h"
#include "vocabulary/refusal.h"

#include <cstdint>
#include <optional>

namespace codewheel {

// What a gateway says of its ring, by the bits of its status register.
struct ToldRing
{
    std::uint16_t status = 0; // the register
    bool runs = true;
    bool hasFailed = false;
    std::optional<std::uint16_t> place{}; // of the fault (faultPlaceOf()); empty: not told

    // What it shows is old then, and what is sent to it does not arrive.
    bool stands() const { return !runs || hasFailed; }
    Refusal whyItStands() const;

    friend bool operator==(const ToldRing &, const ToldRing &) = default;
};

} // namespace codewheel
