// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/link_kind.h"

namespace codewheel {

extern const Subcommand terminalCommand;
extern const Subcommand serveCommand;

std::unique_ptr<const LinkKind> lineLinkKind();

} // namespace codewheel
