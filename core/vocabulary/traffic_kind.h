// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace codewheel {

// Which way something passed on a bus, and whether it was what was being waited for.
enum class TrafficKind : std::uint8_t { sent, answer, echo, garbage, late };

// As recordings have it, whatever the language. Indexed by TrafficKind.
inline constexpr std::array trafficKindKeys{"sent", "answer", "echo", "garbage", "late"};

} // namespace codewheel
