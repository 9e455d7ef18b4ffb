// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"

namespace codewheel {

class BusKind;

// The bus of this number; without one a new bus of this kind, with a name that no other has.
PlannedBus &planBus(Project &project, BusId bus, const BusKind &kind);

} // namespace codewheel
