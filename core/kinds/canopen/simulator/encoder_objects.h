// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/simulator/canopen_encoder_plan.h"
#include "kinds/canopen/simulator/object_dictionary.h"

namespace codewheel::canopen {

// The objects that a simulated encoder has, as delivered; some depend on its node number.
ObjectDictionary encoderObjects(const CanopenEncoderPlan &plan, int node);

inline constexpr int camCount = 8;
inline constexpr int transmitPdoCount = 2;
inline constexpr int mostMapped = 8;     // objects in a PDO
inline constexpr int mostErrorsKept = 8; // 1003h

} // namespace codewheel::canopen
