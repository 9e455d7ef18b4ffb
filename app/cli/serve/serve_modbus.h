// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/subcommand.h"

namespace codewheel {

// Offer simulated rings to Modbus clients until they are told to end: serve modbus-tcp, serve modbus-rtu.
Checked<Answer> serveModbusTcp(const Call &call);
Checked<Answer> serveModbusRtu(const Call &call);

} // namespace codewheel
