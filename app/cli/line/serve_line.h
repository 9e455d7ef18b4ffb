// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/subcommand.h"

namespace codewheel {

// Offers the simulated line to other programs until it is told to end: serve esc.
Checked<Answer> serveLine(const Call &call);

// The system has none left.
Complaint noPseudoTerminal();

} // namespace codewheel
