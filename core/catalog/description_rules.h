// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "catalog/json_object.h"

namespace codewheel {

// What of its capabilities the protocol of an encoder does not allow (docs/device-descriptions.md, "What
// belongs together"): reported to its object. Parameters must have been read.
void checkCapabilities(const JsonObject &json, const DeviceDescription &device);

} // namespace codewheel
