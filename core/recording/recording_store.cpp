// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_store.h"

#include "history/track.h"
#include "recording/recording_tables.h"

#include <QSqlQuery>
#include <QVariant>

#include <map>

namespace codewheel {
namespace {

QString into(const char *table)
{
    return putStatement(recordingTable(QString::fromLatin1(table)));
}

QVariant number(Instant at)
{
    return qint64{at.count()};
}

// Never NULL.
QVariant text(const QString &some)
{
    return some.isNull() ? QStringLiteral("") : some;
}

QVariant nullIfEmpty(const QString &some)
{
    return some.isEmpty() ? QVariant() : QVariant(some);
}

QVariant keyOrNull(const std::optional<Place> &place)
{
    return place ? QVariant(place->key()) : QVariant();
}

QVariant keyOrNull(const std::optional<TrafficKind> &kind)
{
    return kind ? QVariant(QString::fromLatin1(trafficKindKeys.at(static_cast<std::size_t>(*kind))))
                : QVariant();
}

bool isSame(const QVariant &one, const QVariant &other)
{
    return one.isNull() == other.isNull() && one == other;
}

void addPiece(std::vector<QVariant> &values, const RecordedPiece &piece)
{
    const History::Column &column = piece.column;
    for (const std::int64_t value :
         {static_cast<std::int64_t>(piece.samples), column.summary.extent.least,
          column.summary.extent.greatest, std::int64_t{column.summary.always},
          std::int64_t{column.summary.ever}, column.first, column.last, std::int64_t{column.hasGap}})
        values.emplace_back(qint64{value});
}

} // namespace

Stored<void> RecordingStore::create(const QString &file, const RecordingHead &head)
{
    return open(file).and_then([&](RecordingStore store) { return store.begin(head); });
}

Stored<RecordingStore> RecordingStore::open(const QString &file)
{
    auto database = Database::open(DatabasePlace::file(file), recordingSchema());
    if (!database)
        return tl::unexpected(database.error());
    return RecordingStore(std::make_shared<Database>(std::move(*database)));
}

Stored<void> RecordingStore::begin(const RecordingHead &head)
{
    return run(into("recording"),
               {1, qint64{std::ssize(recordingSchema().versions)}, text(head.program), number(head.begun),
                text(head.zone), number(head.since), number(head.until), QVariant()});
}

Stored<void> RecordingStore::run(const QString &statement, const Values &values)
{
    QSqlQuery query = m_database->query(statement);
    for (int i = 0; i < static_cast<int>(values.size()); ++i)
        query.bindValue(i, values[static_cast<std::size_t>(i)]);
    return m_database->run(query);
}

template <class Rows, class ValuesOf>
Stored<void> RecordingStore::put(const QString &statement, const Rows &rows, ValuesOf valuesOf)
{
    if (rows.empty())
        return {};
    QSqlQuery query = m_database->query(statement);
    Values bound;
    for (const auto &row : rows) {
        Values values = valuesOf(row);
        for (std::size_t i = 0; i < values.size(); ++i)
            if (bound.empty() || !isSame(bound[i], values[i])) // it takes longer than to compare them
                query.bindValue(static_cast<int>(i), values[i]);
        bound = std::move(values);
        if (auto done = m_database->run(query); !done)
            return done;
    }
    return {};
}

Stored<void> RecordingStore::write(const RecordingChanges &changes)
{
    return m_database->inTransaction([&] {
        return writeDevices(changes)
            .and_then([&] { return writeBlocks(changes); })
            .and_then([&] { return writeEvents(changes); })
            .and_then([&] { return writeNotes(changes); })
            .and_then([&] {
                return run(QStringLiteral("UPDATE recording SET until = ? WHERE until < ?"),
                           {number(changes.until), number(changes.until)});
            });
    });
}

Stored<void> RecordingStore::writeDevices(const RecordingChanges &changes)
{
    return put(into("bus"), changes.buses,
               [](const RecordedBus &bus) {
                   return Values{bus.bus.number, text(bus.name)};
               })
        .and_then([&] {
            return put(into("device"), changes.devices, [](const auto &row) {
                return Values{row.first, row.second.place.key(), number(row.second.until)};
            });
        })
        .and_then([&] {
            return put(into("description"), changes.descriptions, [](const auto &row) {
                return Values{row.first, number(row.second.since), text(QString::fromUtf8(row.second.json))};
            });
        })
        .and_then([&] {
            return put(into("channel"), changes.channels, [](const auto &row) {
                const ChannelRow &channel = row.second;
                return Values{channel.id, channel.device, channelKey(channel.channel),
                              channel.gapSince ? number(*channel.gapSince) : QVariant()};
            });
        });
}

Stored<void> RecordingStore::writeBlocks(const RecordingChanges &changes)
{
    return put(into("block"), changes.blocks,
               [](const auto &row) {
                   const BlockRow &block = row.second;
                   Values values{block.channel, number(block.piece.from), block.id,
                                 number(block.piece.length)};
                   addPiece(values, block.piece);
                   return values;
               })
        .and_then([&] {
            return put(into("samples"), changes.blocks, [](const auto &row) {
                return Values{row.first, row.second.data};
            });
        })
        .and_then([&] {
            return put(into("summary"), changes.summaries, [](const SummaryRow &row) {
                Values values{row.channel, number(row.piece.length), number(row.piece.from)};
                addPiece(values, row.piece);
                return values;
            });
        });
}

Stored<void> RecordingStore::writeEvents(const RecordingChanges &changes)
{
    return put(into("message"), changes.messages,
               [](const auto &row) {
                   const auto &[at, message] = row.second;
                   return Values{number(at),
                                 row.first,
                                 static_cast<int>(message.severity),
                                 keyOrNull(message.place),
                                 message.code,
                                 message.arguments,
                                 nullIfEmpty(message.refusal)};
               })
        .and_then([&] {
            std::map<std::optional<Place>, QVariant> keys; // of few places, which are in thousands of rows
            return put(into("traffic"), changes.traffic, [&keys](const auto &entry) {
                const TrafficRow &row = entry.second.row;
                const auto [place, isNew] = keys.try_emplace(row.place);
                if (isNew)
                    place->second = keyOrNull(row.place);
                return Values{number(entry.second.at),
                              entry.first,
                              entry.second.bus.number,
                              place->second,
                              keyOrNull(row.kind),
                              static_cast<qint64>(row.cycle),
                              row.out,
                              row.in,
                              row.bytes,
                              int{row.isAutomatic},
                              int{row.isTyped}};
            });
        })
        .and_then([&] {
            return put(into("loss"), changes.losses, [](const auto &row) {
                const RecordedLoss &loss = row.second;
                return Values{number(loss.at), row.first, loss.bus.number, static_cast<qint64>(loss.count)};
            });
        })
        .and_then([&] {
            return put(into("clock"), changes.clocks, [](const RecordedClock &clock) {
                return Values{number(clock.at), number(clock.wall)};
            });
        });
}

Stored<void> RecordingStore::writeNotes(const RecordingChanges &changes)
{
    for (const RecordedNote &note : changes.notes) {
        auto done = note.text.isEmpty()
                        ? run(QStringLiteral("DELETE FROM note WHERE at = ?"), {number(note.at)})
                        : run(into("note"), {number(note.at), note.text});
        if (!done)
            return done;
    }
    return {};
}

Stored<std::vector<qint64>> RecordingStore::channels() const
{
    QSqlQuery query = m_database->query(QStringLiteral("SELECT id FROM channel"));
    if (auto done = m_database->run(query); !done)
        return tl::unexpected(done.error());
    std::vector<qint64> ids;
    while (query.next())
        ids.push_back(query.value(0).toLongLong());
    return ids;
}

// What the clock said before is needed for what comes after.
Stored<void> RecordingStore::forgetBefore(Instant at)
{
    return m_database->inTransaction([&]() -> Stored<void> {
        const auto all = channels();
        if (!all)
            return tl::unexpected(all.error());
        for (const qint64 channel : *all)
            if (auto done = forgetBefore(at, channel); !done)
                return done;
        for (const char *table : {"message", "traffic", "loss"})
            if (auto done = run(QStringLiteral("DELETE FROM %1 WHERE at < ?").arg(QLatin1String(table)),
                                {number(at)});
                !done)
                return done;
        return run(QStringLiteral("DELETE FROM clock WHERE at < (SELECT max(at) FROM clock WHERE at <= ?)"),
                   {number(at)})
            .and_then([&] {
                return run(QStringLiteral("UPDATE recording SET since = ? WHERE since < ?"),
                           {number(at), number(at)});
            });
    });
}

// The block that begins before stays, since its value may stand until today.
Stored<void> RecordingStore::forgetBefore(Instant at, qint64 channel)
{
    QSqlQuery query =
        m_database->query(QStringLiteral("SELECT max(start) FROM block WHERE channel = ? AND start <= ?"));
    query.bindValue(0, channel);
    query.bindValue(1, number(at));
    if (auto done = m_database->run(query); !done)
        return done;
    if (!query.next() || query.value(0).isNull())
        return {};
    const QVariant kept = query.value(0);
    query.finish();
    return run(QStringLiteral("DELETE FROM samples WHERE id IN "
                              "(SELECT data FROM block WHERE channel = ? AND start < ?)"),
               {channel, kept})
        .and_then([&] {
            return run(QStringLiteral("DELETE FROM block WHERE channel = ? AND start < ?"), {channel, kept});
        })
        .and_then([&]() -> Stored<void> {
            for (const auto width : pieceWidths)
                if (auto done = run(QStringLiteral("DELETE FROM summary WHERE channel = ? AND length = ? "
                                                   "AND start <= ?"),
                                    {channel, number(width), number(Instant(kept.toLongLong()) - width)});
                    !done)
                    return done;
            return {};
        });
}

Stored<void> RecordingStore::end(Instant at)
{
    return run(QStringLiteral("UPDATE recording SET ended = ?"), {number(at)});
}

qint64 RecordingStore::usedBytes() const
{
    const auto pragma = [this](const char *what) {
        return m_database->number(QStringLiteral("PRAGMA ") + QLatin1String(what)).value_or(0);
    };
    return (pragma("page_count") - pragma("freelist_count")) * pragma("page_size");
}

} // namespace codewheel
