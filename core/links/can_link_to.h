// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link.h"
#include "can/can_link_argument.h"

#include <memory>

namespace codewheel {

// The link to an interface of this computer (SocketCanLink), or to a serial adapter (SlcanLink). Not open.
std::unique_ptr<CanLink> canLinkTo(const CanLinkArgument &at);

} // namespace codewheel
