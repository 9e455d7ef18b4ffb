// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_object.h"

namespace codewheel {

// Reads a whole description (docs/device-descriptions.md) from its root. The result is only usable if
// `faults` holds none afterwards. The description may name another one in `catalog` to share its tables.
DeviceDescription readDescription(const Json::Value &root, const Catalog &catalog, FaultKeeper &faults);

} // namespace codewheel
