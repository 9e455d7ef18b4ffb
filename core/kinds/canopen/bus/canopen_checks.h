// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/data_check.h"

namespace codewheel {

class CanopenSession;

// Why there is no data of an encoder on the bus, or, without a node, of the bus itself: as far as listening
// tells.
DataChecks canopenChecks(const CanopenSession &bus, NodeId node, const std::vector<Participant> &planned);

// Whether the node sends its position by itself, or why not, by what it told of its PDO (CiA 301, 7.5.2.37;
// CiA 406).
DataCheck canopenPdoCheck(const CanopenSession &bus, int number);

} // namespace codewheel
