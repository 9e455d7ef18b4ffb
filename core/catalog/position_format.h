// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "words/position_word.h"

namespace codewheel {

// K1, K2 and K4: encoders of which a word tells the position and nothing else that a source describes.
bool onlyTellsPosition(Profile profile);

// How such an encoder puts its position into IN.
PositionWord positionFormat(const DeviceDescription &device);

} // namespace codewheel
