// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/kinds/link_kind.h"

namespace codewheel {

// Offer simulated rings to Modbus clients: serve modbus-tcp, serve modbus-rtu.
std::span<const Service> modbusServices();

} // namespace codewheel
