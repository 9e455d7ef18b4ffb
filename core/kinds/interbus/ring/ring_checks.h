// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/data_check.h"

namespace codewheel {

class RingSession;

// What stopped the ring, as far as this program knows.
enum class StoppedBy : std::uint8_t { other, program, alarmStop, fault };

// Why there is no data of a device of the ring, or, without a node, of the ring itself.
DataChecks ringChecks(const RingSession &bus, StoppedBy stopped, NodeId node,
                      const std::vector<Participant> &planned);

} // namespace codewheel
