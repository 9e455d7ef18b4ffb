// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus/places.h"
#include "kinds/canopen/protocol/device_of_type.h"

namespace codewheel {

// The device that --device names, or else that of the project; empty: nobody has named it.
Checked<QString> deviceOnNode(const Call &call, Place place);

} // namespace codewheel
