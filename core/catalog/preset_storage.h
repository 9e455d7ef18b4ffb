// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

namespace codewheel {

// Whether the word or command that sets the position may write to the EEPROM. A K3 of unknown make may be a
// FRABA, which stores the zero offset.
bool mayStorePreset(const DeviceDescription &device);

} // namespace codewheel
