// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel {

// How a step of the test of a link ended.
enum class CheckOutcome : std::uint8_t {
    passed,
    failed,
    skipped, // because of what failed before, or because it does not apply
};

} // namespace codewheel
