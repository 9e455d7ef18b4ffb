// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/translations/ts_file.h"

namespace codewheel {

// What is wrong with the translation of a text, as short sentences; empty if nothing is. `sameInBoth`: the
// texts that read the same in both languages; a text without words, such as "%1 = %2", always may.
QStringList faultsOf(const TsText &text, const QStringList &sameInBoth);

} // namespace codewheel
