// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_device.h"

#include <cstddef>

namespace codewheel {

// The devices, by their indices in ring order, that take no part in the data cycles while a segment is off:
// its remote-bus device with its local bus, and all that follow on that line with their branches. Empty:
// there is no such segment.
std::vector<std::size_t> placesBehindSegment(const RingStructure &ring, int segment);

} // namespace codewheel
