// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/fault.h"

#include <optional>

namespace codewheel {

class RingSession;

// What an encoder of a running ring shows, or leaves in doubt; by its index in the ring.
std::optional<Fault> encoderFault(const RingSession &bus, std::size_t device);

} // namespace codewheel
