// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_device.h"
#include "kinds/interbus/words/bus_fault.h"

namespace codewheel {

// The cable that belongs to the place of a fault, given by the devices at its ends.
struct RingBreak
{
    NodeId before; // none: the master
    NodeId behind; // none: nothing is connected there
};

// For an outgoing interface the cable behind it; for a device the one before it. If both a local bus and a
// branch are connected to an outgoing local interface, it is the one that is `cutOff`.
RingBreak breakAt(const RingStructure &ring, const FaultPlace &place, const std::vector<bool> &cutOff);

} // namespace codewheel
