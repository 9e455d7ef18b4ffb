// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel {

// Which way something passed on a bus, and whether it was what was being waited for.
enum class TrafficKind : std::uint8_t { sent, answer, echo, garbage, late };

} // namespace codewheel
