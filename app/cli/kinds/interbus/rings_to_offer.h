// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"
#include "kinds/interbus/offered_rings.h"

namespace codewheel {

// What serve offers, with the fault plan of the call: the training ring; the rings of the project that are
// linked to a simulated one; or one ring for each seat.
Checked<OfferedRings> ringsToOffer(const Call &call);

// One ring to all units, several to the units from 1 on.
ServedUnits unitsOf(const OfferedRings &rings, ServedUnits::Writing writing);

} // namespace codewheel
