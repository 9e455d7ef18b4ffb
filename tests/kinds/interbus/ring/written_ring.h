// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_device.h"

namespace codewheel {

// A ring in the notation of tests: "K3 BT .K3L /K1 K2". K1, K2, K3: encoders; K3L: on Loop 2; LA: linear
// encoder; BT: bus terminal; DI, DI2: digital inputs of one and two words. A leading dot: on the local bus;
// each slash: one level deeper.
RingStructure writtenRing(const char *text);

} // namespace codewheel
