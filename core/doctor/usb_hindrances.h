// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "doctor/hindrance.h"
#include "links/computer.h"

namespace codewheel {

// Adapters that are plugged in but have no port, and programs that get in the way of those that have one.
Hindrances usbHindrances(const Computer &computer);

} // namespace codewheel
