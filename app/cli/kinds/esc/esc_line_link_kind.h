// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/kinds/link_kind.h"

namespace codewheel {

extern const Subcommand terminalCommand;

// Offers the simulated line at a pseudo terminal: serve esc.
extern const Service lineService;

std::unique_ptr<const LinkKind> lineLinkKind();

} // namespace codewheel
