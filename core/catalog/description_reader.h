// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "catalog/device_tables.h"
#include "catalog/json_object.h"
#include "catalog/ordering_key.h"

namespace codewheel {

// Reads a whole description (docs/device-descriptions.md) from its root. The result is only usable if
// `faults` holds none afterwards. The description may name another one in `catalog` to share its tables.
DeviceDescription readDescription(const Json::Value &root, const Catalog &catalog, FaultKeeper &faults);

// The member "orderingKey" of a description (docs/device-descriptions.md). Its example must itself be valid.
OrderingKey readOrderingKey(const JsonObject &json);

// The members "connectors", "leds", "supply" and "limits" of a description (docs/device-descriptions.md).
std::vector<Connector> readConnectors(const JsonObject &json);
Leds readLeds(const JsonObject &json);
Supply readSupply(const JsonObject &json);
std::vector<LimitTable> readLimits(const JsonObject &json);

// What of its capabilities the protocol of an encoder does not allow (docs/device-descriptions.md, "What
// belongs together"): reported to its object. Parameters must have been read.
void checkCapabilities(const JsonObject &json, const DeviceDescription &device);

} // namespace codewheel
