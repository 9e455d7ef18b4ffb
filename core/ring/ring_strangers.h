// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/refusal.h"
#include "ring/participant.h"

#include <map>

namespace codewheel {

class Catalog;

// Of the configured devices those that are not for certain the connected ones at their numbers: notInRing, or
// ringDiffers, which tells where the configured one stands now. The number alone does not tell: where a
// device before them is missing or additional, all behind it have another number.
std::map<NodeId, Refusal> strangersInRing(const RingStructure &configured, const RingStructure &connected,
                                          const Catalog &catalog);

} // namespace codewheel
