// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/left_backups.h"

#include "project/file_access.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

namespace codewheel {

void dropLeftBackups(const QString &file, qint64 largest)
{
    const QFileInfo info(file);
    const QRegularExpression left(
        QStringLiteral("^%1\\.[0-9]+~$").arg(QRegularExpression::escape(info.fileName())));
    const QStringList names = info.absoluteDir().entryList(QDir::Files | QDir::Hidden).filter(left);
    for (const QString &name : names) {
        const QString path = info.absoluteDir().filePath(name);
        const auto held = readWholeFile(path, largest);
        if (held &&
            (held == readWholeFile(file, largest) || held == readWholeFile(backupPath(file), largest)))
            QFile::remove(path);
    }
}

} // namespace codewheel
