// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

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

// Saves the files as one zip, replacing any existing file once the new one is complete: fileNotWritten. It
// reveals nothing about them but their names and `time`.
Result<void> saveZip(const QString &path, const std::vector<ZipEntry> &files, const QDateTime &time);

} // namespace codewheel
