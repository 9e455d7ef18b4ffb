// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

namespace codewheel {

// What the manual says about a device, as a page to read and search: supply, pins, LEDs, limits, ordering
// key, parameters, errors, assumptions. Used by DevicePanel.
QString deviceHtml(const DeviceDescription &device);

} // namespace codewheel
