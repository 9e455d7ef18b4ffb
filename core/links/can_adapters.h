// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/can_interface.h"
#include "links/serial_ports.h"

namespace codewheel {

// Where a CAN bus may be connected to this computer.
struct CanAdapters
{
    std::vector<CanInterface> interfaces{};
    std::vector<PortInfo> ports{}; // of adapters that may speak SLCAN; only asking them tells
};

CanAdapters canAdapters(const std::vector<PortInfo> &ports, const Computer &computer = Computer(),
                        const CanStatusOf &statusOf = canStatus);

} // namespace codewheel
