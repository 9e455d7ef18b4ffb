// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_device.h"
#include "vocabulary/refusal.h"

#include <map>

namespace codewheel {

class Catalog;

// The configured devices that are not certain to be the connected ones at their numbers: notInRing, or
// ringDiffers, which says where the configured one is now. The number alone does not tell: if a device before
// them is missing or additional, all those behind it have another number.
std::map<NodeId, Refusal> strangersInRing(const RingStructure &configured, const RingStructure &connected,
                                          const Catalog &catalog);

} // namespace codewheel
