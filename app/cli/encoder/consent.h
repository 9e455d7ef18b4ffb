// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"

namespace codewheel {

// Whether what is to be agreed to could be shown at all.
Checked<void> checkWasShown(const Call &call);

// Whether the user wants what was just shown: --yes, or yes to the question. Nobody is asked where nobody can
// answer, or if the answer is for a program; `howWithoutAsking` says what is needed then.
Checked<void> consent(const Call &call, const QString &question, const QString &howWithoutAsking);

QString nothingSaved();
// Before anything is done: whether the file that the call is to leave behind can be created. An existing file
// is only replaced with --yes; `whereThere` says so, with %1 for the file.
Checked<void> checkTargetFile(const Arguments &arguments, const QString &path,
                              const QString &whereThere = nothingSaved());

} // namespace codewheel
