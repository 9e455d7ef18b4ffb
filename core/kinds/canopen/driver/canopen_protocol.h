// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/protocol.h"

namespace codewheel {

// For encoders on CANopen.
const Protocol &canopenProtocol();

} // namespace codewheel
