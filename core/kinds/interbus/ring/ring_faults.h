// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/fault.h"

namespace codewheel {

class RingSession;

// What is wrong with a ring: what its master says, then what its encoders show, in ring order. The master's
// codes name no cause except where its manual is known to name one; the sentence follows from the place.
std::vector<Fault> ringFaults(const RingSession &bus);

} // namespace codewheel
