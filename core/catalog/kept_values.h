// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/known.h"

namespace codewheel {

// Whether an encoder keeps anything that is written to it without supply.
bool keepsValues(const DeviceDescription &device);

// How its value is kept, of which its driver says this.
Kept keptOf(const DeviceDescription &device, Parameter parameter, Kept told);

// A value in force that the encoder may lose without supply, although it can store it.
bool hasToBeStored(const DeviceDescription &device, const Known &known);

} // namespace codewheel
