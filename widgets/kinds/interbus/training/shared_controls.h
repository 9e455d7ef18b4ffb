// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/training_controls.h"

#include <memory>

namespace codewheel {

// Those of a training panel, never null. Its parts look at the panel's own, which become others when it turns
// to another ring.
using SharedControls = std::shared_ptr<TrainingControls>;

} // namespace codewheel
