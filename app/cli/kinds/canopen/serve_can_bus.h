// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/kinds/link_kind.h"

namespace codewheel {

// Offers the simulated CAN bus behind an SLCAN adapter, or on an interface: serve canopen.
extern const Service canBusService;

} // namespace codewheel
