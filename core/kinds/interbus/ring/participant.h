// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/participant.h"

#include <vector>

namespace codewheel {

using RingStructure = std::vector<Participant>;

// Whether both are the same ring as far as a master can tell: all but the makes.
bool isSameRing(const RingStructure &ring, const RingStructure &other);

} // namespace codewheel
