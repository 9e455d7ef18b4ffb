// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

namespace codewheel {

// What the manual says of a device, as a page to read and to search: supply, pins, LEDs, limits, ordering
// key, parameters, errors, assumptions. Used by DevicePanel.
QString deviceHtml(const DeviceDescription &device);

} // namespace codewheel
