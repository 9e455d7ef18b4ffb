// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_tables.h"

#include <algorithm>
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

RecordingTable tableOf(const char *name, const char *columns, qsizetype keys, bool isOfMoment = true)
{
    return {QString::fromLatin1(name), QString::fromLatin1(columns).split(u' '), keys, isOfMoment};
}

} // namespace

RecordingDialect sqliteDialect()
{
    return {QStringLiteral("INTEGER"), QStringLiteral("BLOB"), QStringLiteral(" WITHOUT ROWID")};
}

RecordingDialect postgresDialect()
{
    return {QStringLiteral("BIGINT"), QStringLiteral("BYTEA"), QString()};
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

// Samples come before the blocks that refer to them.
const std::vector<RecordingTable> &allRecordingTables()
{
    static const std::vector<RecordingTable> tables{
        tableOf("samples", "id data", 1),
        tableOf("block",
                "channel start data length samples lowest highest ones_always ones_ever first last gap", 3),
        tableOf("summary", "channel length start samples lowest highest ones_always ones_ever first last gap",
                3),
        tableOf("message", "at id severity place code arguments refusal", 2),
        tableOf("traffic", "at id bus place kind cycle word_out word_in bytes automatic typed", 2),
        tableOf("loss", "at id bus amount", 2),
        tableOf("bus", "number name", 1, false),
        tableOf("device", "id place until", 1, false),
        tableOf("description", "device since json", 2, false),
        tableOf("channel", "id device kind gap_since", 1, false),
        tableOf("note", "at text", 1, false),
        tableOf("clock", "at wall", 1, false),
        tableOf("recording", "id version program begun zone since until ended", 1, false),
    };
    return tables;
}

const RecordingTable &recordingTable(const QString &name)
{
    return *std::ranges::find(allRecordingTables(), name, &RecordingTable::name);
}

QString putStatement(const RecordingTable &table)
{
    const QStringList places(table.columns.size(), QStringLiteral("?"));
    return putStatement(table, {u'(' + places.join(QStringLiteral(", ")) + u')'});
}

QString putStatement(const RecordingTable &table, const QStringList &rows)
{
    QStringList updates;
    for (const QString &column : table.columns.sliced(table.keys))
        updates << column + QStringLiteral(" = excluded.") + column;
    const QString comma = QStringLiteral(", ");
    return QStringLiteral("INSERT INTO ") + table.name + QStringLiteral(" (") + table.columns.join(comma) +
           QStringLiteral(") VALUES ") + rows.join(comma) + QStringLiteral(" ON CONFLICT (") +
           table.columns.first(table.keys).join(comma) + QStringLiteral(") DO UPDATE SET ") +
           updates.join(comma);
}

} // namespace codewheel
