// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/data_check.h"
#include "bus/fault.h"

#include <optional>

namespace codewheel {

class CanopenSession;

// Why there is no data of an encoder on the bus, or, without a node, of the bus itself: as far as listening
// tells.
DataChecks canopenChecks(const CanopenSession &bus, NodeId node, const std::vector<Participant> &planned);

// Whether the node sends its position by itself, or why not, by what it told of its PDO (CiA 301, 7.5.2.37;
// CiA 406).
DataCheck canopenPdoCheck(const CanopenSession &bus, int number);

// What is wrong with a CAN bus with CANopen: its link, then its encoders, in the order of their numbers.
std::vector<Fault> canopenFaults(const CanopenSession &bus);
std::optional<Fault> canopenFaultOf(const CanopenSession &bus, Place place);

} // namespace codewheel
