// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

#include <QJsonObject>

namespace codewheel {

// The manual's tables for a device: connectors, LEDs, supply, limits, ordering key. Empty if it has none.
QString deviceTablesText(const DeviceDescription &device);
// The same; texts in the user's language.
QJsonObject deviceTablesJson(const DeviceDescription &device);

} // namespace codewheel
