// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_object.h"

namespace codewheel {

// Reads a whole description (docs/device-descriptions.md) from its root. What it returns is of use only if
// `faults` has none afterwards.
DeviceDescription readDescription(const Json::Value &root, FaultKeeper &faults);

} // namespace codewheel
