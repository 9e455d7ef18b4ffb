// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus/places.h"

namespace codewheel {

// What an encoder is taken for where nobody knows better: multi-turn.
QString usualDeviceOnNode();
// By its device type (1000h): the form of encoder that CiA 406 has there. Empty: it is none of these.
QString deviceOfType(std::uint32_t deviceType);

// The device that --device names, or else that of the project; empty: nobody has named it.
Checked<QString> deviceOnNode(const Call &call, Place place);

} // namespace codewheel
