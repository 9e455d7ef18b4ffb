// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_sender.h"

#include "recording/recording_store.h"

#include <QSqlError>
#include <QSqlQuery>

namespace codewheel {
namespace {

constexpr int mostInBatch = 5'000;
constexpr qsizetype rowsOfStatement = 100; // each statement waits for an answer of the server

const QString listComma = QStringLiteral(", ");

} // namespace

RecordingSender::RecordingSender(QString file, ServerAddress to)
    : m_file(std::move(file))
    , m_to(std::move(to))
{}

Result<RecordingSender::Sent> RecordingSender::send()
{
    const auto fileFailed = [this](const DatabaseError &error) {
        return refuse(RefusalKind::link, RefusalId::databaseFailed, {m_file, error.reason});
    };
    if (!m_waiting) {
        auto opened = Database::open(DatabasePlace::file(m_file), recordingSchema());
        if (!opened)
            return fileFailed(opened.error());
        m_waiting = std::make_shared<Database>(std::move(*opened));
    }
    const auto batch = nextBatch();
    if (!batch)
        return fileFailed(batch.error());
    if (auto delivered = connect().and_then([&] { return deliver(*batch); }); !delivered) {
        m_server.reset();
        return tl::unexpected(awayRefusal(m_to, delivered.error(), waitingBytes()));
    }
    if (auto forgotten = forgetSent(*batch); !forgotten)
        return fileFailed(forgotten.error());
    return batch->others.empty() ? Sent::some : Sent::all;
}

Refusal RecordingSender::awayRefusal(const ServerAddress &server, const DatabaseError &error,
                                     std::int64_t waiting)
{
    return {RefusalKind::link, RefusalId::serverAway, {server.place(), error.reason, megabytes(waiting)}};
}

std::int64_t RecordingSender::waitingBytes() const
{
    return m_waiting ? RecordingStore(m_waiting).usedBytes() : 0;
}

Stored<void> RecordingSender::connect()
{
    if (m_server)
        return {};
    auto server = PostgresDatabase::connect(m_to);
    if (!server)
        return tl::unexpected(server.error());
    if (auto used = (*server)->useRecording(m_to.recording); !used)
        return used;
    m_server = std::move(*server);
    m_since = 0;
    for (const RecordingTable &table : allRecordingTables()) {
        if (table.isOfMoment)
            continue;
        auto rows = read(*m_server, table, 0);
        if (!rows)
            return tl::unexpected(rows.error());
        m_there[table.name] = textsOf({&table, std::move(*rows)});
    }
    return {};
}

// `most`: 0: all.
Stored<std::vector<RecordingSender::Row>> RecordingSender::read(const SqlConnection &from,
                                                                const RecordingTable &table, int most)
{
    QString statement =
        QStringLiteral("SELECT %1 FROM %2 ORDER BY %3")
            .arg(table.columns.join(listComma), table.name, table.columns.first(table.keys).join(listComma));
    if (most > 0)
        statement += QStringLiteral(" LIMIT %1").arg(most);
    QSqlQuery query = from.query(statement);
    if (auto done = from.run(query); !done)
        return tl::unexpected(done.error());
    std::vector<Row> rows;
    while (query.next()) {
        Row &row = rows.emplace_back();
        for (int column = 0; column < static_cast<int>(table.columns.size()); ++column)
            row.push_back(query.value(column));
    }
    if (query.lastError().isValid())
        return tl::unexpected(from.reasonOf(query.lastError()));
    return rows;
}

// As the file is at one moment.
Stored<RecordingSender::Batch> RecordingSender::nextBatch() const
{
    Batch batch;
    int room = mostInBatch;
    const auto done = m_waiting->inTransaction([&]() -> Stored<void> {
        for (const RecordingTable &table : allRecordingTables()) {
            if (room == 0)
                return {};
            auto rows = read(*m_waiting, table, table.isOfMoment ? room : 0);
            if (!rows)
                return tl::unexpected(rows.error());
            room -= table.isOfMoment ? static_cast<int>(rows->size()) : 0;
            (table.isOfMoment ? batch.moments : batch.others).push_back({&table, std::move(*rows)});
        }
        return {};
    });
    if (!done)
        return tl::unexpected(done.error());
    return batch;
}

// The head says how far the recording has come: only once all that belongs to it is there.
Stored<void> RecordingSender::deliver(const Batch &batch)
{
    auto done = m_server->inTransaction([&]() -> Stored<void> {
        for (const Rows &rows : batch.moments)
            if (auto put = putMoments(rows); !put)
                return put;
        for (const Rows &rows : batch.others)
            if (auto put = equal(rows); !put)
                return put;
        return {};
    });
    return done.and_then([&] { return forgetAsFile(batch); });
}

QString RecordingSender::text(Row::const_iterator begin, Row::const_iterator end) const
{
    QStringList values;
    for (auto value = begin; value != end; ++value)
        values << m_server->literal(*value);
    return u'(' + values.join(listComma) + u')';
}

RecordingSender::RowTexts RecordingSender::textsOf(const Rows &rows) const
{
    RowTexts texts;
    for (const Row &row : rows.rows)
        texts.emplace(text(row.begin(), row.begin() + rows.table->keys), text(row.begin(), row.end()));
    return texts;
}

Stored<void> RecordingSender::put(const RecordingTable &table, const QStringList &rows) const
{
    for (qsizetype at = 0; at < rows.size(); at += rowsOfStatement)
        if (auto done = m_server->execute(
                putStatement(table, rows.sliced(at, std::min(rowsOfStatement, rows.size() - at))));
            !done)
            return done;
    return {};
}

Stored<void> RecordingSender::putMoments(const Rows &rows) const
{
    QStringList texts;
    for (const Row &row : rows.rows)
        texts << text(row.begin(), row.end());
    return put(*rows.table, texts);
}

// The table there has the same rows then.
Stored<void> RecordingSender::equal(const Rows &rows)
{
    RowTexts &there = m_there[rows.table->name];
    const RowTexts here = textsOf(rows);
    QStringList changed;
    for (const auto &[key, row] : here)
        if (const auto found = there.find(key); found == there.end() || found->second != row)
            changed << row;
    const QString keys = rows.table->columns.first(rows.table->keys).join(listComma);
    for (const auto &[key, row] : there)
        if (!here.contains(key))
            if (auto done =
                    m_server->execute(QStringLiteral("DELETE FROM ") + rows.table->name +
                                      QStringLiteral(" WHERE (") + keys + QStringLiteral(") = ") + key);
                !done)
                return done;
    return put(*rows.table, changed).map([&] { there = here; });
}

// What is too old for the file is too old for the server.
Stored<void> RecordingSender::forgetAsFile(const Batch &batch)
{
    if (batch.others.empty() || batch.others.back().rows.empty())
        return {};
    const Rows &heads = batch.others.back();
    const auto column = heads.table->columns.indexOf(QStringLiteral("since"));
    const qint64 since = heads.rows.front().at(static_cast<std::size_t>(column)).toLongLong();
    if (since <= m_since)
        return {};
    return RecordingStore(m_server).forgetBefore(Instant(since)).map([&] { m_since = since; });
}

Stored<void> RecordingSender::forgetSent(const Batch &batch) const
{
    return m_waiting->inTransaction([&]() -> Stored<void> {
        for (const Rows &rows : batch.moments)
            if (auto removed = remove(rows); !removed)
                return removed;
        return {};
    });
}

// A block that was written again meanwhile is another row.
Stored<void> RecordingSender::remove(const Rows &rows) const
{
    if (rows.rows.empty())
        return {};
    QStringList conditions;
    for (qsizetype column = 0; column < rows.table->columns.size(); ++column)
        conditions << rows.table->columns[column] +
                          (column < rows.table->keys ? QStringLiteral(" = ?") : QStringLiteral(" IS ?"));
    QSqlQuery query = m_waiting->query(QStringLiteral("DELETE FROM ") + rows.table->name +
                                       QStringLiteral(" WHERE ") + conditions.join(QStringLiteral(" AND ")));
    for (const Row &row : rows.rows) {
        int index = 0;
        for (const QVariant &value : row)
            query.bindValue(index++, value);
        if (auto done = m_waiting->run(query); !done)
            return done;
    }
    return {};
}

} // namespace codewheel
