// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/kinds/link_kind.h"

namespace codewheel {

extern const Subcommand odCommand;
extern const Subcommand nmtCommand;
extern const Subcommand lssCommand;
extern const Subcommand edsCommand;

// Offers the simulated CAN bus behind an SLCAN adapter, or on an interface: serve canopen.
extern const Service canBusService;

std::unique_ptr<const LinkKind> canopenLinkKind();
std::unique_ptr<const LinkKind> canLogLinkKind();

} // namespace codewheel
