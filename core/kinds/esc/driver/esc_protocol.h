// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/protocol.h"

namespace codewheel {

// For encoders with the serial protocol of Kübler.
const Protocol &escProtocol();

} // namespace codewheel
