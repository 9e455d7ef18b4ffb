// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"

namespace codewheel {

// The bus of this number; if the project has none, a new one of this kind, with this name or, where another
// has it, the next: "Ring 2".
PlannedBus &planBus(Project &project, BusId bus, const char *kind, const char *name);

} // namespace codewheel
