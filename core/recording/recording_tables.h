// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/database.h"

namespace codewheel {

// What the statements that make the tables of a recording say differently to each kind of database. All other
// statements are the same for all.
struct RecordingDialect
{
    QString number;    // of a row, 64 bits
    QString bytes;     // a column of bytes
    QString clustered; // stored in the order of its key, where that has to be said
};
RecordingDialect sqliteDialect();

// docs/recording-files.md
QStringList recordingTables(const RecordingDialect &dialect);
// As a file.
const DatabaseSchema &recordingSchema();

// Puts a row there, or replaces the one with the same key, which is the first `keys` columns.
QString putStatement(const QString &table, const QStringList &columns, qsizetype keys);

} // namespace codewheel
