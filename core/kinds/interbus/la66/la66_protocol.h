// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/protocol.h"

namespace codewheel {

// For the rods of the type LA-66.
const Protocol &la66Protocol();

} // namespace codewheel
