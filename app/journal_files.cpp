// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal_files.h"

#include "bus/encoder_bus.h"

#include <QCoreApplication>
#include <QSettings>
#include <QStandardPaths>

namespace codewheel {
namespace {

const QString userNameKey = QStringLiteral("eeprom/user");

} // namespace

std::unique_ptr<QSettings> userSettings()
{
    return std::make_unique<QSettings>(QSettings::IniFormat, QSettings::UserScope,
                                       QStringLiteral("codewheel"), QStringLiteral("codewheel"));
}

QString userName(const QSettings &settings)
{
    return settings.value(userNameKey).toString();
}

void setUserName(QSettings &settings, const QString &name)
{
    settings.setValue(userNameKey, name);
}

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

QString nothingIsKept()
{
    return Database::isAvailable()
               ? QString()
               : QCoreApplication::translate("JournalFiles",
                                             "Messages are not kept, and EEPROM writes are counted for this "
                                             "connection only: Qt's driver for SQLite is missing on this "
                                             "computer. Install the package libqt6sql6-sqlite.");
}

DatabasePlace ledgerPlace(const EncoderBus &bus, const QString &folder)
{
    return bus.isSimulated() ? DatabasePlace::memory() : DatabasePlace::file(ledgerFile(folder));
}

} // namespace codewheel
