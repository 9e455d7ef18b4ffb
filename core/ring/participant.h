// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/participant.h"

#include <vector>

namespace codewheel {

struct DeviceDescription;

inline constexpr unsigned busTerminalIdCode = 0x0C;

using RingStructure = std::vector<Participant>;

// Whether both are the same ring as far as a master can tell: all but the makes.
bool isSameRing(const RingStructure &ring, const RingStructure &other);

// What to call it: the name of its description, or without one (null) "bus terminal" or "device not known".
QString participantName(const Participant &participant, const DeviceDescription *description);

} // namespace codewheel
