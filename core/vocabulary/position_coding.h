// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel {

// How a position is coded.
enum class PositionCoding : std::uint8_t { binary, signedBinary, gray };

} // namespace codewheel
