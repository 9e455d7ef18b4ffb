// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_tables.h"

#include <array>

namespace codewheel {
namespace {

constexpr int recordingApplication = 0x43575243; // "CWRC"

// %1: a number of a row, %2: bytes, %3: clustered.
constexpr std::array tableStatements{
    "CREATE TABLE recording (id %1 PRIMARY KEY, version BIGINT NOT NULL, program TEXT NOT NULL, "
    "begun BIGINT NOT NULL, zone TEXT NOT NULL, since BIGINT NOT NULL, until BIGINT NOT NULL, ended BIGINT)",
    "CREATE TABLE bus (number %1 PRIMARY KEY, name TEXT NOT NULL)",
    "CREATE TABLE device (id %1 PRIMARY KEY, place TEXT NOT NULL, until BIGINT NOT NULL)",
    "CREATE TABLE description (device BIGINT NOT NULL, since BIGINT NOT NULL, json TEXT NOT NULL, "
    "PRIMARY KEY (device, since))%3",
    "CREATE TABLE channel (id %1 PRIMARY KEY, device BIGINT NOT NULL, kind TEXT NOT NULL, gap_since BIGINT)",
    "CREATE TABLE block (channel BIGINT NOT NULL, start BIGINT NOT NULL, data BIGINT NOT NULL, "
    "length BIGINT NOT NULL, samples BIGINT NOT NULL, lowest BIGINT NOT NULL, highest BIGINT NOT NULL, "
    "ones_always BIGINT NOT NULL, ones_ever BIGINT NOT NULL, first BIGINT NOT NULL, last BIGINT NOT NULL, "
    "gap BIGINT NOT NULL, PRIMARY KEY (channel, start, data))%3",
    "CREATE TABLE samples (id %1 PRIMARY KEY, data %2 NOT NULL)",
    "CREATE TABLE summary (channel BIGINT NOT NULL, length BIGINT NOT NULL, start BIGINT NOT NULL, "
    "samples BIGINT NOT NULL, lowest BIGINT NOT NULL, highest BIGINT NOT NULL, ones_always BIGINT NOT NULL, "
    "ones_ever BIGINT NOT NULL, first BIGINT NOT NULL, last BIGINT NOT NULL, gap BIGINT NOT NULL, "
    "PRIMARY KEY (channel, length, start))%3",
    "CREATE TABLE message (at BIGINT NOT NULL, id BIGINT NOT NULL, severity BIGINT NOT NULL, place TEXT, "
    "code TEXT NOT NULL, arguments TEXT NOT NULL, refusal TEXT, PRIMARY KEY (at, id))%3",
    "CREATE TABLE traffic (at BIGINT NOT NULL, id BIGINT NOT NULL, bus BIGINT NOT NULL, place TEXT, kind "
    "TEXT, "
    "cycle BIGINT NOT NULL, word_out BIGINT NOT NULL, word_in BIGINT NOT NULL, bytes %2, "
    "automatic BIGINT NOT NULL, typed BIGINT NOT NULL, PRIMARY KEY (at, id))%3",
    "CREATE TABLE note (at BIGINT PRIMARY KEY, text TEXT NOT NULL)%3",
    "CREATE TABLE loss (at BIGINT NOT NULL, id BIGINT NOT NULL, bus BIGINT NOT NULL, amount BIGINT NOT NULL, "
    "PRIMARY KEY (at, id))%3",
    "CREATE TABLE clock (at BIGINT PRIMARY KEY, wall BIGINT NOT NULL)%3",
};

} // namespace

RecordingDialect sqliteDialect()
{
    return {QStringLiteral("INTEGER"), QStringLiteral("BLOB"), QStringLiteral(" WITHOUT ROWID")};
}

QStringList recordingTables(const RecordingDialect &dialect)
{
    QStringList statements;
    for (const char *statement : tableStatements) {
        QString text = QString::fromLatin1(statement);
        text.replace(QStringLiteral("%1"), dialect.number);
        text.replace(QStringLiteral("%2"), dialect.bytes);
        statements << text.replace(QStringLiteral("%3"), dialect.clustered);
    }
    return statements;
}

const DatabaseSchema &recordingSchema()
{
    static const DatabaseSchema schema{.applicationId = recordingApplication,
                                       .versions = {{.statements = recordingTables(sqliteDialect())}}};
    return schema;
}

QString putStatement(const QString &table, const QStringList &columns, qsizetype keys)
{
    QStringList updates;
    for (const QString &column : columns.sliced(keys))
        updates << column + QStringLiteral(" = excluded.") + column;
    QStringList places(columns.size(), QStringLiteral("?"));
    const QStringList keyColumns = columns.first(keys);
    return QStringLiteral("INSERT INTO %1 (%2) VALUES (%3) ON CONFLICT (%4) DO UPDATE SET %5")
        .arg(table, columns.join(QStringLiteral(", ")), places.join(QStringLiteral(", ")),
             keyColumns.join(QStringLiteral(", ")), updates.join(QStringLiteral(", ")));
}

} // namespace codewheel
