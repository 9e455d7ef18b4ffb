// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/word_step.h"
#include "vocabulary/event.h"

#include <vector>

namespace codewheel {

// How long an LA-66 driver waits, and for what. All of it can be set.
struct La66Timing
{
    // How many bus cycles service and data stay in OUT before the service bit. The manual says one cycle of
    // the PLC (4, note 2); one more covers a gateway that copies OUT in two parts.
    int dataCycles = 2;
    Instant timeOut = std::chrono::seconds(2); // after that the encoder "does not answer" (assumed)
};

// A step as the driver carries it out: the word, and what ends it. A service takes three: service and data,
// the service bit, and the service bit back to 0 (toNormal).
struct La66Step : Step
{
    std::int64_t value = 0;               // serviceBit that writes: the value
    std::optional<std::int64_t> expected; // serviceBit that reads back: what must be read
    int holdCycles = 0;                   // word that is not acknowledged
};
using La66Steps = std::vector<La66Step>;

} // namespace codewheel
