// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/protocol_rules.h"

namespace codewheel {

// For the descriptions of encoders with the protocol of K3.
const ProtocolRules &k3Rules();

} // namespace codewheel
