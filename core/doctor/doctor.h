// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "doctor/hindrance.h"
#include "links/computer.h"
#include "links/serial_ports.h"

namespace codewheel {

// What on this computer keeps links from working: serial ports, adapters, programs in the way, CAN
// interfaces. What prevents most comes first. Only looks: opens nothing and sends nothing.
Hindrances examine(const std::vector<PortInfo> &ports, const Computer &computer = Computer());

} // namespace codewheel
