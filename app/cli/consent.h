// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/subcommand.h"

namespace codewheel {

// Whether what is to be agreed to could be shown at all.
Checked<void> checkWasShown(const Call &call);

// Whether the user wants what was just shown: --yes, or yes to the question. Nobody is asked where nobody can
// answer, or where the answer is for a program; `howWithoutAsking` tells what is needed then.
Checked<void> consent(const Call &call, const QString &question, const QString &howWithoutAsking);

} // namespace codewheel
