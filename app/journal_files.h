// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/database.h"

#include <memory>

class QSettings;

namespace codewheel {

class EncoderBus;

// The settings of the user, the same for the window and the command line; in an ini file.
std::unique_ptr<QSettings> userSettings();
// In them: the name under which the user's writes are entered in the ledger; empty: none is given.
QString userName(const QSettings &settings);
void setUserName(QSettings &settings, const QString &name);

// The folder of the user's messages and EEPROM counts, the same for the window and the command line:
// ~/.local/share/codewheel. Need not exist.
QString userJournalFolder();

// The file in such a folder.
QString messageFile(const QString &folder);
QString ledgerFile(const QString &folder);

// Where EEPROM writes to the encoders of this bus are counted: in the user's ledger. Simulated encoders are
// new at each start, and counted in memory.
DatabasePlace ledgerPlace(const EncoderBus &bus, const QString &folder);

// What to report if neither messages nor EEPROM writes can be kept, not even in memory, because Qt's SQLite
// driver is missing; empty: it is there.
QString nothingIsKept();

} // namespace codewheel
