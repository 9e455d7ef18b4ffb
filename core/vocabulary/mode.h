// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel {

// What an encoder shows; most know position only.
enum class Mode : std::uint8_t { position, velocity, cam };

} // namespace codewheel
