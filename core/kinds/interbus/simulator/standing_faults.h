// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/fault_plan.h"

namespace codewheel {

// "1.0: Wire break before it, 3.0: Peripheral fault", in the user's language: the faults that stand in a ring
// with these places; empty: none. That a device without supply, or one that was replaced, is switched off too
// goes without saying.
QString standingFaultsText(const std::vector<TrainingPlace> &ring);

} // namespace codewheel
