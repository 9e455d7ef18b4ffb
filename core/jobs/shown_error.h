// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/reading.h"

namespace codewheel {

// What to say about an encoder that shows an error by itself: no job asked it for anything.
Refusal shownError(const DeviceDescription &device, const Reading &reading);

} // namespace codewheel
