// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_map.h"

#include <vector>

namespace codewheel {

// Where a device of a ring that is offered is in the registers, for those who write a program for it.
struct ServedRegisters
{
    NodeId place;
    RegisterBlock in;        // input registers
    RegisterBlock inHolding; // the same as holding registers
    RegisterBlock out;       // holding registers

    friend bool operator==(const ServedRegisters &, const ServedRegisters &) = default;
};

// In ring order. Empty: the ring has more words than there are registers for.
std::vector<ServedRegisters> servedTable(const RingStructure &ring);

} // namespace codewheel
