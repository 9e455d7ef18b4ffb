// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"
#include "cli/kinds/link_kind.h"

namespace codewheel {

struct DeviceDescription;

extern const Subcommand terminalCommand;

// Offers the simulated line at a pseudo terminal: serve esc.
extern const Service lineService;

std::unique_ptr<const LinkKind> lineLinkKind();

// Explains what a request on a serial line means ("05P", "03GP00005200"), or, with --other REQUEST, an answer
// to it: its digits, or CRLF for the bare line end of a write that was accepted.
Checked<Answer> explainLine(const Call &call, const DeviceDescription &device);

} // namespace codewheel
