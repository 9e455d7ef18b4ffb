// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/rod_scale.h"

namespace codewheel {

double millimetresPerStep(const RodScale &scale);

// "0.010 mm per step"
QString resolution(double mmPerStep);

} // namespace codewheel
