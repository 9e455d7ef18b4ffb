// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/event.h"

#include <QString>

namespace codewheel {

struct DeviceDescription;

// What a step of a job does, whatever the bus: "Steps = 255", "Read steps", "Run: the values become valid",
// "Read the position of 05". Used by the wizard, the panels' job strip and the reports.
QString stepText(const DeviceDescription &device, const Step &step);

} // namespace codewheel
