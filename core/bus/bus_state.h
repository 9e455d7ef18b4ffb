// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel {

// How a bus stands to its link.
enum class BusState : std::uint8_t {
    closed,
    opening, // its thread is at it
    open,
    lost, // open, and the link has gone: it is tried again each second
};

} // namespace codewheel
