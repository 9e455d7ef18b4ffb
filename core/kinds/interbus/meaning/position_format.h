// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/interbus/words/position_word.h"

namespace codewheel {

// How a K1, K2 or K4, whose word holds the position and nothing else that any source describes, places it in
// IN.
PositionWord positionFormat(const DeviceDescription &device);

} // namespace codewheel
