// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/database.h"
#include "recording/postgres_database.h"
#include "recording/recording_tables.h"

#include <QVariant>

#include <map>

namespace codewheel {

// Sends what is in a recording file to a server, piece by piece, and removes from the file what has arrived,
// so that what is in it is what waits. It keeps nothing of its own: wherever it was interrupted, also between
// the two, it goes on from what it finds, and as rows replace those with the same key nothing comes twice.
// What belongs to no moment (devices, descriptions, notes, the head) stays in the file, and is compared with
// what the server has. Used by one thread.
class RecordingSender
{
public:
    enum class Sent { some, all };

    // `to` has the name of the recording.
    RecordingSender(QString file, ServerAddress to);

    // A transaction's worth. After a failure the next call connects anew.
    Result<Sent> send();
    bool isConnected() const { return m_server != nullptr; }
    std::int64_t waitingBytes() const; // in the file

    static std::int64_t megabytes(std::int64_t bytes) { return (bytes + 999'999) / 1'000'000; }
    static Refusal awayRefusal(const ServerAddress &server, const DatabaseError &error, std::int64_t waiting);

private:
    using Row = std::vector<QVariant>;
    struct Rows
    {
        const RecordingTable *table;
        std::vector<Row> rows;
    };
    struct Batch
    {
        std::vector<Rows> moments;
        std::vector<Rows> others{}; // complete; empty: not all moments are in the batch
    };
    using RowTexts = std::map<QString, QString>; // the whole row, by its key

    Stored<void> connect();
    Stored<Batch> nextBatch() const;
    Stored<void> deliver(const Batch &batch);
    Stored<void> forgetSent(const Batch &batch) const;
    static Stored<std::vector<Row>> read(const SqlConnection &from, const RecordingTable &table, int most);
    Stored<void> remove(const Rows &rows) const;
    Stored<void> put(const RecordingTable &table, const QStringList &rows) const;
    Stored<void> putMoments(const Rows &rows) const;
    Stored<void> equal(const Rows &rows);
    Stored<void> forgetAsFile(const Batch &batch);
    QString text(Row::const_iterator begin, Row::const_iterator end) const;
    RowTexts textsOf(const Rows &rows) const;

    QString m_file;
    ServerAddress m_to;
    std::shared_ptr<Database> m_waiting;
    std::shared_ptr<PostgresDatabase> m_server;
    std::map<QString, RowTexts> m_there; // what the server has of the other tables, by table
    qint64 m_since = 0;                  // what is older the server has not any more
};

} // namespace codewheel
