// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/training_bus.h"
#include "project/project.h"

namespace codewheel {

// The ring of a project, simulated: its devices at their places, as their descriptions and labels say, with
// factory settings, and turning slowly. A K3 that is neither FRABA nor Baumer, or whose make nobody has
// said, is simulated as a FRABA; a device without a
// simulator shows its OUT word in IN.
TrainingBus makePlannedRing(const Project &project, BusId ring, const Catalog &catalog);

} // namespace codewheel
