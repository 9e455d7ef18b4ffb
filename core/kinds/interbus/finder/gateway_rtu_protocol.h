// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/spoken_protocol.h"

namespace codewheel {

// Gateways and other devices with Modbus RTU. The standard asks for 19200 Bd, 8E1 (Modbus over Serial Line
// V1.02, 2.5.1); 9600 Bd and other formats are usual too.
std::unique_ptr<const SpokenProtocol> makeRtuProtocol();

} // namespace codewheel
