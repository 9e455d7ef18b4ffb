// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/fault.h"

#include <optional>

namespace codewheel {

class CanopenSession;

// What is wrong with a CAN bus with CANopen: its link, then its encoders, in the order of their numbers.
std::vector<Fault> canopenFaults(const CanopenSession &bus);
std::optional<Fault> canopenFaultOf(const CanopenSession &bus, Place place);

} // namespace codewheel
