// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel {

// A process-data word, D31 the most significant bit.
using Word = std::uint32_t;

// Seen from the bus master: OUT = master to encoder, IN = encoder to master.
enum class WordDirection { in, out };

} // namespace codewheel
