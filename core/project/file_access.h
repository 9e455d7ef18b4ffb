// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/refusal.h"

#include <QByteArray>

namespace codewheel {

// All of a file of at most `largest` bytes: fileNotReadable, fileTooLarge. What is no file is not opened.
Result<QByteArray> readWholeFile(const QString &path, qint64 largest);

// A size as it is told: whole MB, rounded up.
QString inMegabytes(qint64 bytes);

// What becomes of the file that is replaced.
enum class OldFile { goes, isKeptAsBackup };

// Whether a file could be put at `path` now: fileNotWritten. What is no file, such as a device, a pipe, a
// socket or a loop of links, is not replaced.
Result<void> checkReplaceable(const QString &path);

// Writes a file beside `path` to the disk and puts it in place of `path` in one step: fileNotWritten, with
// `path` as it was; bad input where nothing could be put there, as checkReplaceable() tells before, and a
// matter of the disk from then on. Whatever the program saves in one piece goes this way; what is written
// piece by piece goes through project/file_replacement.h.
Result<void> replaceFile(const QString &path, const QByteArray &bytes, OldFile old);

// The reason of a fileNotWritten, without its full stop, for a sentence that is put together elsewhere.
QString whyNotWritten(const Refusal &refusal);

QString backupPath(const QString &path); // NAME~

} // namespace codewheel
