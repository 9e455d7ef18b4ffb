// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_tables.h"
#include "catalog/json_object.h"

namespace codewheel {

// The members "connectors", "leds", "supply" and "limits" of a description (docs/device-descriptions.md).
std::vector<Connector> readConnectors(const JsonObject &json);
Leds readLeds(const JsonObject &json);
Supply readSupply(const JsonObject &json);
std::vector<LimitTable> readLimits(const JsonObject &json);

} // namespace codewheel
