// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/protocol.h"

namespace codewheel {

// For encoders of ENCOM profile K3, and for K1, K2 and K4, which have no jobs.
const Protocol &k3Protocol();

} // namespace codewheel
