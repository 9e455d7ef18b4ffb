// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/refusal.h"

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include <vector>

namespace codewheel {

struct ZipEntry
{
    QString name;
    QByteArray bytes;
};

// Saves the files as one zip in place of a file that may be there, which stays until the new one is whole:
// fileNotWritten. The names are all that it tells of them besides `time`.
Result<void> saveZip(const QString &path, const std::vector<ZipEntry> &files, const QDateTime &time);

} // namespace codewheel
