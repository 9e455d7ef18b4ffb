// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_object.h"

namespace codewheel {

// Reads a whole description (docs/device-descriptions.md) from its root. What it returns is of use only if
// `faults` has none afterwards. Another of `catalog` may be named to share its tables.
DeviceDescription readDescription(const Json::Value &root, const Catalog &catalog, FaultKeeper &faults);

} // namespace codewheel
