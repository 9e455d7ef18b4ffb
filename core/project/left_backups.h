// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// Removes what programs left beside `file` that were ended between making a backup and naming it: NAME.PID~,
// as far as it holds no more than the file itself or its backup. Under FolderLock.
void dropLeftBackups(const QString &file, qint64 largest);

} // namespace codewheel
