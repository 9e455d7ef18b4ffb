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
RecordingDialect postgresDialect();

// How the rows of a table are written: a row replaces the one with the same key.
struct RecordingTable
{
    QString name;
    QStringList columns;
    qsizetype keys = 1;     // the first columns
    bool isOfMoment = true; // its rows belong to a stretch of time, and are as many as that is long
};
const std::vector<RecordingTable> &allRecordingTables();
const RecordingTable &recordingTable(const QString &name);
// With places for the values of a row.
QString putStatement(const RecordingTable &table);
// Of all rows, each (...) in the order of the columns.
QString putStatement(const RecordingTable &table, const QStringList &rows);

// docs/recording-files.md
QStringList recordingTables(const RecordingDialect &dialect);
// As a file.
const DatabaseSchema &recordingSchema();

} // namespace codewheel
