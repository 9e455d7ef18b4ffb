// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

#include <QByteArray>

namespace codewheel {

// All of a file of at most `largest` bytes: fileNotReadable, fileTooLarge. Only regular files are opened.
Result<QByteArray> readWholeFile(const QString &path, qint64 largest);

// A size as shown: whole MB, rounded up.
QString inMegabytes(qint64 bytes);

// What happens to the file that is replaced.
enum class OldFile { goes, isKeptAsBackup };

// Whether a file could be put at `path` now: fileNotWritten. Anything but a regular file, such as a device, a
// pipe, a socket or a loop of links, is not replaced.
Result<void> checkReplaceable(const QString &path);

// Writes a file beside `path` to the disk and puts it in place of `path` in one step: fileNotWritten, with
// `path` as it was; bad input if nothing could be put there, which checkReplaceable() tells beforehand, and a
// fault of the disk after that. Whatever the program saves in one piece goes through here; what is written
// piece by piece goes through project/file_replacement.h.
Result<void> replaceFile(const QString &path, const QByteArray &bytes, OldFile old);

// The reason of a fileNotWritten, without its full stop, for a sentence put together elsewhere.
QString whyNotWritten(const Refusal &refusal);

QString backupPath(const QString &path); // NAME~

} // namespace codewheel
