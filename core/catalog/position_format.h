// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/interbus/words/position_word.h"

namespace codewheel {

// K1, K2 and K4: encoders whose word holds the position and nothing else that any source describes.
bool onlyTellsPosition(Profile profile);

// How such an encoder places its position in IN.
PositionWord positionFormat(const DeviceDescription &device);

} // namespace codewheel
