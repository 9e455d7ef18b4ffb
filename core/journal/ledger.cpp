// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/ledger.h"

#include "journal/argument_json.h"
#include "journal/ledger_json.h"
#include "journal/ledger_rows.h"
#include "journal/waiting_entries.h"

#include <QFileInfo>
#include <QSqlQuery>
#include <QUuid>
#include <QVariant>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int ledgerApplication = 0x43574545; // "CWEE"

const DatabaseSchema &ledgerSchema()
{
    static const DatabaseSchema ledger{
        .applicationId = ledgerApplication,
        .versions =
            {{.statements =
                  {QStringLiteral(
                       "CREATE TABLE entry (id INTEGER PRIMARY KEY AUTOINCREMENT, at INTEGER NOT NULL, "
                       "identity TEXT NOT NULL, counted_by TEXT NOT NULL, place TEXT NOT NULL, "
                       "device TEXT NOT NULL, planned INTEGER NOT NULL, writes INTEGER NOT NULL, "
                       "settled INTEGER NOT NULL, before TEXT NOT NULL, written TEXT NOT NULL)"),
                   QStringLiteral("CREATE INDEX entry_identity ON entry (identity)")}},
             {.statements = {QStringLiteral("CREATE TABLE origin (entry INTEGER PRIMARY KEY, id TEXT NOT "
                                            "NULL UNIQUE)")},
              .filling = {QStringLiteral("INSERT INTO origin SELECT id, id || '-' || at FROM entry")}},
             {.statements = {QStringLiteral("CREATE TABLE writer (entry INTEGER PRIMARY KEY, computer TEXT "
                                            "NOT NULL, user TEXT NOT NULL)")}}},
        .survivesPowerLoss = true};
    return ledger;
}

QString columnOf(const auto &values)
{
    return jsonLine(valuesToJson(values));
}

QString notNull(const QString &text) // as a column without NULL takes it
{
    return text.isNull() ? QStringLiteral("") : text;
}

// Sums over entries. Whatever a file says, nothing counts as less than 0.
constexpr QLatin1String sums("ifnull(sum(max(writes, 0)), 0), "
                             "ifnull(sum(CASE settled WHEN 0 THEN max(planned - writes, 0) ELSE 0 END), 0), "
                             "min(at)");

EepromCount countOf(const QSqlQuery &row, int column)
{
    EepromCount count{.writes = row.value(column).toInt(), .perhaps = row.value(column + 1).toInt()};
    if (!row.value(column + 2).isNull())
        count.since = QDateTime::fromMSecsSinceEpoch(row.value(column + 2).toLongLong(), Qt::UTC);
    return count;
}

std::vector<Ledger::Value> beforeOf(const Database &database, qint64 id)
{
    QSqlQuery query = database.query(QStringLiteral("SELECT before FROM entry WHERE id = ?"));
    query.addBindValue(id);
    return database.run(query) && query.next() ? ledgerValues(query.value(0)) : std::vector<Ledger::Value>();
}

// What was read takes precedence over what was known.
std::vector<Ledger::Value> merged(const std::vector<Ledger::Value> &known, std::vector<Ledger::Value> read)
{
    for (const Ledger::Value &value : known)
        if (std::ranges::find(read, value.parameter, &Ledger::Value::parameter) == read.end())
            read.push_back(value);
    std::ranges::sort(read, {}, &Ledger::Value::parameter);
    return read;
}

QString newOrigin()
{
    return QUuid::createUuid().toString(QUuid::Id128);
}

constexpr QLatin1String serialPrefix("serial/");

// From the key of a place (Place::key()).
constexpr QLatin1String busOfPlace(
    "(CASE WHEN instr(place, '/') > 0 THEN CAST(substr(place, 1, instr(place, '/') - 1) AS INTEGER) "
    "WHEN place LIKE 'esc:%' THEN 2 ELSE 1 END)");

QString placePrefix(const QString &project)
{
    return QStringLiteral("place/%1/").arg(project);
}

} // namespace

QString EncoderIdentity::key() const
{
    return by == CountedBy::place ? placePrefix(project) + place.key()
                                  : serialPrefix + vendor + u'/' + serialNumber;
}

QString ledgerProject(const QString &file)
{
    const QString path = file.isEmpty() ? QString() : QFileInfo(file).canonicalFilePath();
    return path.isEmpty() ? file : path; // it does not exist yet
}

Stored<Ledger> Ledger::open(const DatabasePlace &place)
{
    auto database = Database::open(place, ledgerSchema());
    if (!database)
        return tl::unexpected(database.error());
    Ledger ledger(std::move(*database));
    if (!place.inMemory)
        ledger.takeOver(LeftEntries::filesBeside(place.name));
    return ledger;
}

// What could not be entered before. If it cannot be entered now either, it goes on waiting.
void Ledger::takeOver(const QStringList &left)
{
    for (const QString &path : left) {
        LeftEntries entries(path);
        if (!entries.isLeft())
            continue;
        const auto records = entries.records();
        if (records && merge(*records))
            entries.drop();
    }
}

Stored<qint64> Ledger::begin(const Entry &entry)
{
    qint64 id = 0;
    Record record{newOrigin(), entry};
    record.entry.writer = ledgerWriter();
    return m_database
        .inTransaction([&] { return insert(record).map([&](qint64 inserted) { id = inserted; }); })
        .map([&] { return id; });
}

// With its id, or a new one if that is 0.
Stored<qint64> Ledger::insert(const Record &record)
{
    const Entry &entry = record.entry;
    QSqlQuery query = m_database.query(QStringLiteral("INSERT OR REPLACE INTO entry (%1) VALUES (?, ?, ?, ?, "
                                                      "?, ?, ?, ?, ?, ?, ?)")
                                           .arg(ledgerColumns));
    for (const QVariant &value : std::initializer_list<QVariant>{
             entry.id > 0 ? QVariant(entry.id) : QVariant(), entry.at.toMSecsSinceEpoch(), entry.identity,
             countedByKey(entry.by), entry.place.key(), notNull(entry.device), entry.planned, entry.writes,
             entry.settled ? 1 : 0, columnOf(entry.before), columnOf(entry.written)})
        query.addBindValue(value);
    if (auto inserted = m_database.run(query); !inserted)
        return tl::unexpected(inserted.error());
    const qint64 id = query.lastInsertId().toLongLong();
    QSqlQuery origin = m_database.query(QStringLiteral("INSERT OR REPLACE INTO origin VALUES (?, ?)"));
    origin.addBindValue(id);
    origin.addBindValue(record.origin);
    if (auto named = m_database.run(origin); !named)
        return tl::unexpected(named.error());
    QSqlQuery writer = m_database.query(QStringLiteral("INSERT OR REPLACE INTO writer VALUES (?, ?, ?)"));
    for (const QVariant &value :
         std::initializer_list<QVariant>{id, notNull(entry.writer.computer), notNull(entry.writer.user)})
        writer.addBindValue(value);
    return m_database.run(writer).map([&] { return id; });
}

Stored<void> Ledger::count(qint64 id, int writes)
{
    QSqlQuery query = m_database.query(QStringLiteral("UPDATE entry SET writes = writes + ? WHERE id = ?"));
    query.addBindValue(writes);
    query.addBindValue(id);
    return m_database.run(query);
}

Stored<void> Ledger::plan(qint64 id, int more)
{
    QSqlQuery query = m_database.query(QStringLiteral("UPDATE entry SET planned = planned + ? WHERE id = ?"));
    query.addBindValue(more);
    query.addBindValue(id);
    return m_database.run(query);
}

Stored<void> Ledger::settle(qint64 id, const ParameterValues &written, const std::vector<Value> &readBefore,
                            int perhaps)
{
    return m_database.inTransaction([&]() -> Stored<void> {
        if (!readBefore.empty()) {
            QSqlQuery before = m_database.query(QStringLiteral("UPDATE entry SET before = ? WHERE id = ?"));
            before.addBindValue(columnOf(merged(beforeOf(m_database, id), readBefore)));
            before.addBindValue(id);
            if (auto added = m_database.run(before); !added)
                return added;
        }
        QSqlQuery query = m_database.query(QStringLiteral(
            "UPDATE entry SET settled = ?, planned = CASE WHEN ? THEN planned ELSE writes + ? END, "
            "written = ? WHERE id = ?"));
        const int isSettled = perhaps == 0 ? 1 : 0;
        query.addBindValue(isSettled);
        query.addBindValue(isSettled);
        query.addBindValue(perhaps);
        query.addBindValue(columnOf(written));
        query.addBindValue(id);
        return m_database.run(query);
    });
}

Stored<void> Ledger::attribute(const std::vector<qint64> &ids, const EncoderIdentity &identity)
{
    return m_database.inTransaction([&]() -> Stored<void> {
        for (const qint64 id : ids) {
            QSqlQuery query = m_database.query(
                QStringLiteral("UPDATE entry SET identity = ?, counted_by = ? WHERE id = ?"));
            query.addBindValue(identity.key());
            query.addBindValue(countedByKey(identity.by));
            query.addBindValue(id);
            if (auto updated = m_database.run(query); !updated)
                return updated;
        }
        return {};
    });
}

Stored<void> Ledger::copyPlaces(const QString &from, const QString &to, BusId bus,
                                const std::vector<qint64> &without)
{
    QSqlQuery query = m_database.query(ledgerQuery(
        QStringLiteral("substr(identity, 1, length(:from)) = :from AND %1 = :bus AND %2 AND NOT EXISTS "
                       "(SELECT 1 FROM entry AS copy WHERE copy.at = entry.at AND copy.device = "
                       "entry.device AND copy.identity = :to || substr(entry.identity, length(:from) + 1))")
            .arg(busOfPlace, hasWrites)));
    query.bindValue(QStringLiteral(":from"), placePrefix(from));
    query.bindValue(QStringLiteral(":to"), placePrefix(to));
    query.bindValue(QStringLiteral(":bus"), bus.number);
    return m_database.inTransaction([&]() -> Stored<void> {
        if (auto found = m_database.run(query); !found)
            return found;
        std::vector<Record> copies;
        while (query.next())
            copies.push_back(ledgerRecordOf(query));
        query.finish();
        for (Record &copy : copies) {
            if (std::ranges::count(without, copy.entry.id) > 0)
                continue;
            copy.origin = newOrigin();
            copy.entry.id = 0;
            copy.entry.identity.replace(0, placePrefix(from).size(), placePrefix(to));
            if (auto added = insert(copy); !added)
                return tl::unexpected(added.error());
        }
        return {};
    });
}

Stored<void> Ledger::movePlaces(const QString &to, BusId bus)
{
    QSqlQuery query = m_database.query(
        QStringLiteral(
            "UPDATE entry SET identity = :to || place WHERE identity = :from || place AND %1 = :bus")
            .arg(busOfPlace));
    query.bindValue(QStringLiteral(":from"), placePrefix({}));
    query.bindValue(QStringLiteral(":to"), placePrefix(to));
    query.bindValue(QStringLiteral(":bus"), bus.number);
    return m_database.inTransaction([&] { return m_database.run(query); });
}

EepromCount Ledger::writes(const EncoderIdentity &identity, const std::vector<qint64> &running) const
{
    QSqlQuery query = m_database.query(
        QStringLiteral("SELECT %1 FROM entry WHERE identity = ? AND %2").arg(sums, hasWrites));
    query.addBindValue(identity.key());
    EepromCount count;
    if (m_database.run(query) && query.next())
        count = countOf(query, 0);
    for (const qint64 id : running)
        count.perhaps -= static_cast<int>(
            m_database
                .number(QStringLiteral("SELECT max(planned - writes, 0) FROM entry WHERE id = %1").arg(id))
                .value_or(0));
    count.by = identity.by;
    count.serialNumber = identity.by == CountedBy::place ? QString() : identity.serialNumber;
    return count;
}

std::vector<Ledger::Entry> Ledger::valuesBefore(const EncoderIdentity &identity) const
{
    QSqlQuery query = m_database.query(
        ledgerQuery(QStringLiteral("identity = ? AND before <> '[]' AND %1").arg(hasWrites)));
    query.addBindValue(identity.key());
    std::vector<Entry> entries;
    (void)m_database.run(query);
    while (query.next())
        entries.push_back(ledgerRecordOf(query).entry);
    std::ranges::reverse(entries);
    return entries;
}

std::vector<Ledger::Account> Ledger::accounts() const
{
    QSqlQuery query = m_database.query(
        QStringLiteral(
            "SELECT entry.identity, counted_by, place, device, account.* FROM (SELECT max(id) AS newest, "
            "%1 FROM entry WHERE %2 GROUP BY identity) AS account JOIN entry ON id = newest ORDER BY 1")
            .arg(sums, hasWrites));
    std::vector<Account> accounts;
    (void)m_database.run(query);
    while (query.next()) {
        Account account{.identity = query.value(0).toString(),
                        .place = Place::parse(query.value(2).toString()).value_or(Place()),
                        .device = query.value(3).toString(),
                        .count = countOf(query, 5)};
        account.count.by = countedByFromKey(query.value(1).toString()).value_or(CountedBy::place);
        if (account.identity.startsWith(serialPrefix))
            account.count.serialNumber = account.identity.section(u'/', 2);
        accounts.push_back(std::move(account));
    }
    return accounts;
}

} // namespace codewheel
