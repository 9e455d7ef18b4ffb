// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/word.h"

namespace codewheel {

// What a single bit of a word means, 0..31: "D28..D25: parameter number".
QString k3BitText(const DeviceDescription &device, WordDirection direction, int bit);
QString la66BitText(WordDirection direction, int bit);
QString positionBitText(const DeviceDescription &device, WordDirection direction, int bit);

} // namespace codewheel
