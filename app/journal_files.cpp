// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal_files.h"

#include <QStandardPaths>

namespace codewheel {

QString userJournalFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           QStringLiteral("/codewheel");
}

QString messageFile(const QString &folder)
{
    return folder + QStringLiteral("/messages.sqlite");
}

QString ledgerFile(const QString &folder)
{
    return folder + QStringLiteral("/eeprom-writes.sqlite");
}

} // namespace codewheel
