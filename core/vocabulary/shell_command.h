// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace codewheel {

// `pattern` with %1.. replaced by the parts, each of them one word to a shell, whatever is in it; what
// somebody typed is in commands that are copied. Empty if a part has characters that no command line shows,
// or looks like an option.
QString shellCommand(const QString &pattern, const QStringList &parts);

} // namespace codewheel
