// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"
#include "simulator/training_bus.h"

namespace codewheel {

// The ring of a project, simulated: its devices at their places, as their descriptions and labels say, with
// factory settings, and turning slowly. A K3 of which nobody has said the make is a FRABA; a device without a
// simulator shows its OUT word in IN.
TrainingBus makePlannedRing(const Project &project, BusId ring, const Catalog &catalog);

} // namespace codewheel
