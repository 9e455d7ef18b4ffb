// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/job.h"
#include "vocabulary/refusal.h"

namespace codewheel {

// "position mode", "cam mode, program 3", in the user's language.
QString modeText(const SwitchMode &mode);
// "cam mode", if nobody knows the program.
QString modeText(Mode mode, std::optional<unsigned> camProgram);

// A mode as messages store it: its key and, of cam mode, the program.
std::vector<RefusalArgument> modeArguments(const SwitchMode &mode);
std::vector<RefusalArgument> modeArguments(Mode mode, std::optional<unsigned> camProgram);
// A text of an earlier version is shown as it is.
QString modeText(const std::vector<RefusalArgument> &arguments);

} // namespace codewheel
