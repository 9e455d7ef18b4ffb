// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/arguments.h"
#include "cli/complaint.h"

namespace codewheel {

// Before anything is done: whether the file can be made that the call is to leave behind. One that is there
// already is replaced with --yes only.
Checked<void> checkTargetFile(const Arguments &arguments, const QString &path);

} // namespace codewheel
