// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/data_check.h"
#include "bus/fault.h"

#include <optional>

namespace codewheel {

class RingSession;

// What stopped the ring, as far as this program knows.
enum class StoppedBy : std::uint8_t { other, program, alarmStop, fault };

// Why there is no data of a device of the ring, or, without a node, of the ring itself.
DataChecks ringChecks(const RingSession &bus, StoppedBy stopped, NodeId node,
                      const std::vector<Participant> &planned);

// What is wrong with a ring: what its master says, then what its encoders show, in ring order. The master's
// codes name no cause except where its manual is known to name one; the sentence follows from the place.
std::vector<Fault> ringFaults(const RingSession &bus);

// What an encoder of a running ring shows, or leaves in doubt; by its index in the ring.
std::optional<Fault> encoderFault(const RingSession &bus, std::size_t device);

} // namespace codewheel
