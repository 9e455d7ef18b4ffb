// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/message_table.h"

#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int messagesApplication = 0x43574D53; // "CWMS"

const DatabaseSchema &messagesSchema()
{
    static const DatabaseSchema messages{
        .applicationId = messagesApplication,
        .versions = {
            {.statements = {QStringLiteral("CREATE TABLE message (id INTEGER PRIMARY KEY AUTOINCREMENT, "
                                           "at INTEGER NOT NULL, severity INTEGER NOT NULL, place TEXT, "
                                           "code TEXT NOT NULL, arguments TEXT NOT NULL, refusal TEXT)"),
                            QStringLiteral("CREATE TABLE place (number TEXT PRIMARY KEY) WITHOUT ROWID")}}}};
    return messages;
}

const QString messageColumns = QStringLiteral("id, at, severity, place, code, arguments, refusal");

// A file may contain anything.
Severity severityOf(int number)
{
    return number <= 0 ? Severity::information : number == 1 ? Severity::attention : Severity::fault;
}

StoredMessage messageOf(const QSqlQuery &query)
{
    return {.id = query.value(0).toLongLong(),
            .at = query.value(1).toLongLong(),
            .severity = severityOf(query.value(2).toInt()),
            .place = Place::ofKey(query.value(3).toString()),
            .code = query.value(4).toString(),
            .arguments = query.value(5).toString(),
            .refusal = query.value(6).toString()};
}

// For a bus everything that happened there; `places` are those of the table.
QString placeCondition(const MessageFilter::Where &where, const std::vector<Place> &places)
{
    if (where.all)
        return {};
    if (!where.at)
        return QStringLiteral(" AND (place IS NULL OR place LIKE '%/')");
    const auto quoted = [](const Place &place) {
        return u'\'' + place.key().replace(u'\'', QStringLiteral("''")) + u'\'';
    };
    QStringList keys{quoted(*where.at)};
    for (const Place &place : places)
        if (place.bus == where.at->bus)
            keys << quoted(place);
    return QStringLiteral(" AND place IN (%1)").arg(keys.join(u','));
}

QString conditions(const MessageFilter &filter, const std::vector<Place> &places)
{
    QString text = QStringLiteral(" WHERE id BETWEEN ? AND ?");
    if (filter.least != Severity::information)
        text += QStringLiteral(" AND severity >= %1").arg(static_cast<int>(filter.least));
    text += placeCondition(filter.place, places);
    if (filter.from)
        text += QStringLiteral(" AND at >= %1").arg(*filter.from);
    if (filter.until)
        text += QStringLiteral(" AND at < %1").arg(*filter.until);
    return text + QStringLiteral(" ORDER BY id");
}

template <typename Row>
Stored<std::vector<Row>> all(const Database &database, QSqlQuery query, Row (*rowAt)(const QSqlQuery &))
{
    if (auto done = database.run(query); !done)
        return tl::unexpected(done.error());
    std::vector<Row> rows;
    while (query.next())
        rows.push_back(rowAt(query));
    if (query.lastError().isValid()) // in the middle of the file
        return tl::unexpected(Database::errorOf(query.lastError()));
    return rows;
}

QVariant orNull(const QString &text)
{
    return text.isEmpty() ? QVariant() : QVariant(text);
}

} // namespace

Stored<MessageTable> MessageTable::open(const DatabasePlace &place)
{
    auto database = Database::open(place, messagesSchema());
    if (!database)
        return tl::unexpected(database.error());
    return MessageTable(std::move(*database));
}

Stored<MessageTable::Span> MessageTable::span() const
{
    const auto first = m_database.number(QStringLiteral("SELECT min(id) FROM message"));
    const auto last = m_database.number(QStringLiteral("SELECT max(id) FROM message"));
    if (!first || !last)
        return tl::unexpected(first ? last.error() : first.error());
    return Span{std::max<qint64>(*first, 0), std::max<qint64>(*last, 0)};
}

Stored<void> MessageTable::insert(const std::vector<StoredMessage> &messages, bool withIds)
{
    return m_database.inTransaction([&]() -> Stored<void> {
        QSqlQuery row = m_database.query(
            QStringLiteral("INSERT INTO message (%1) VALUES (?, ?, ?, ?, ?, ?, ?)").arg(messageColumns));
        QSqlQuery place = m_database.query(QStringLiteral("INSERT OR IGNORE INTO place VALUES (?)"));
        std::optional<Place> noted;
        for (const StoredMessage &message : messages) {
            const QString number = message.place ? message.place->key() : QString();
            const QVariant values[] = {withIds ? QVariant(message.id) : QVariant(),
                                       message.at,
                                       static_cast<int>(message.severity),
                                       orNull(number),
                                       message.code,
                                       message.arguments,
                                       orNull(message.refusal)};
            for (int i = 0; i < 7; ++i)
                row.bindValue(i, values[i]);
            if (auto done = m_database.run(row); !done)
                return done;
            if (!message.place || noted == message.place)
                continue;
            noted = message.place;
            place.bindValue(0, number);
            if (auto done = m_database.run(place); !done)
                return done;
        }
        return {};
    });
}

Stored<std::vector<StoredMessage>> MessageTable::read(const std::vector<qint64> &ids) const
{
    const auto count = static_cast<qint64>(ids.size());
    if (count > 1 && ids.back() - ids.front() == count - 1 && std::ranges::is_sorted(ids))
        if (auto run = read(ids.front(), ids.back()); !run || std::ssize(*run) == count)
            return run;
    QSqlQuery query =
        m_database.query(QStringLiteral("SELECT %1 FROM message WHERE id = ?").arg(messageColumns));
    std::vector<StoredMessage> messages;
    for (const qint64 id : ids) {
        query.bindValue(0, id);
        if (auto done = m_database.run(query); !done)
            return tl::unexpected(done.error());
        messages.push_back(query.next() ? messageOf(query) : StoredMessage());
    }
    return messages;
}

Stored<std::vector<StoredMessage>> MessageTable::read(qint64 first, qint64 last,
                                                      const MessageFilter &filter) const
{
    QSqlQuery query = m_database.query(QStringLiteral("SELECT %1 FROM message").arg(messageColumns) +
                                       conditions(filter, placesFor(filter)));
    query.bindValue(0, first);
    query.bindValue(1, last);
    return all<StoredMessage>(m_database, std::move(query), messageOf);
}

Stored<std::vector<qint64>> MessageTable::ids(qint64 first, qint64 last, const MessageFilter &filter) const
{
    QSqlQuery query =
        m_database.query(QStringLiteral("SELECT id FROM message") + conditions(filter, placesFor(filter)));
    query.bindValue(0, first);
    query.bindValue(1, last);
    return all<qint64>(m_database, std::move(query),
                       [](const QSqlQuery &row) { return row.value(0).toLongLong(); });
}

std::vector<Place> MessageTable::places() const
{
    QSqlQuery query = m_database.query(QStringLiteral("SELECT number FROM place"));
    std::vector<Place> places;
    (void)m_database.run(query);
    while (query.next())
        if (const auto place = Place::ofKey(query.value(0).toString()))
            places.push_back(*place);
    std::ranges::sort(places);
    return places;
}

// Only looked up if a bus is asked for.
std::vector<Place> MessageTable::placesFor(const MessageFilter &filter) const
{
    return filter.place.at && filter.place.at->isEmpty() ? places() : std::vector<Place>();
}

qint64 MessageTable::size() const
{
    return m_database.number(QStringLiteral("PRAGMA page_count")).value_or(0) *
           m_database.number(QStringLiteral("PRAGMA page_size")).value_or(0);
}

Stored<void> MessageTable::dropUpTo(qint64 last)
{
    return m_database.inTransaction([&]() -> Stored<void> {
        return m_database.execute(QStringLiteral("DELETE FROM message WHERE id <= %1").arg(last))
            .and_then([&] { return freePages(); });
    });
}

// Qt takes one step of the statement each time, which frees at least one page: a file whose list of free
// pages says otherwise is damaged.
Stored<void> MessageTable::freePages()
{
    const auto number = [&](const char *what) { return m_database.number(QString::fromLatin1(what)); };
    constexpr qint64 incremental = 2;
    if (number("PRAGMA auto_vacuum").value_or(0) != incremental)
        return {}; // made by another program: it keeps its free pages for later
    const auto free = number("PRAGMA freelist_count");
    auto pages = number("PRAGMA page_count");
    if (!free || !pages)
        return tl::unexpected(free ? pages.error() : free.error());
    const qint64 least = *pages - *free;
    if (least < 0)
        return tl::unexpected(Database::damaged());
    QSqlQuery vacuum = m_database.query(QStringLiteral("PRAGMA incremental_vacuum"));
    while (*pages > least) {
        if (auto freed = m_database.run(vacuum); !freed)
            return freed;
        const auto left = number("PRAGMA page_count");
        if (!left)
            return tl::unexpected(left.error());
        if (*left >= *pages)
            return tl::unexpected(Database::damaged());
        pages = left;
    }
    return {};
}

} // namespace codewheel
