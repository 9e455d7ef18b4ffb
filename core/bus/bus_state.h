// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel {

// The state of a bus with regard to its link.
enum class BusState : std::uint8_t {
    closed,
    opening, // its thread is working on it
    open,
    lost, // was open, and the link is gone: retried every second
};

} // namespace codewheel
