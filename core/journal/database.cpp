// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/database.h"

#include "journal/busy_wait.h"
#include "journal/journal_texts.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSqlError>
#include <QSqlQuery>

#include <atomic>
#include <optional>

namespace codewheel {
namespace {

// Primary result codes of SQLite, as QSqlError::nativeErrorCode() gives them.
constexpr int sqliteBusy = 5;
constexpr int sqliteNoMemory = 7;
constexpr int sqliteReadOnly = 8;
constexpr int sqliteCannotOpen = 14;
constexpr int sqliteInputOutput = 10;
constexpr int sqliteCorrupt = 11;
constexpr int sqliteFull = 13;
constexpr int sqliteNoDatabase = 26;

constexpr QByteArrayView sqliteHeader("SQLite format 3", 16); // including its zero
constexpr qsizetype journalModeAt = 18;                       // in the header
constexpr char writeAheadLog = 2;

// SQLite itself waits only briefly, then tries ever less often; the rest is BusyWait's.
constexpr auto connectOptions = "QSQLITE_BUSY_TIMEOUT=20;QSQLITE_OPEN_URI";

// For each connection. The schema of a hostile file must not call anything, and one row must not take all
// memory.
constexpr const char *settings[] = {
    "PRAGMA trusted_schema = OFF",
    "PRAGMA cell_size_check = ON",
    "PRAGMA hard_heap_limit = 536870912",
};

DatabaseError foreignFile(const QString &reason)
{
    return {DatabaseError::Kind::foreign, reason};
}

int primaryCode(const QSqlError &error)
{
    return error.nativeErrorCode().toInt() & 0xFF; // without the extended part
}

// As a URI, since characters in a file name could otherwise have a special meaning there.
QString uriOf(const DatabasePlace &place, const char *mode)
{
    if (place.inMemory)
        return QStringLiteral("file:/%1?vfs=memdb").arg(place.name);
    return QStringLiteral("file:") +
           QString::fromLatin1(QFile::encodeName(QFileInfo(place.name).absoluteFilePath())
                                   .toPercentEncoding(QByteArrayLiteral("/")) +
                               mode);
}

} // namespace

DatabasePlace DatabasePlace::memory()
{
    static std::atomic<quint64> counter = 0;
    return {QStringLiteral("codewheel-%1").arg(++counter), true};
}

Database::Database(Database &&other) noexcept
    : SqlConnection(std::move(other))
    , m_file(std::exchange(other.m_file, {}))
    , m_open(std::move(other.m_open))
{}

Database &Database::operator=(Database &&other) noexcept
{
    SqlConnection::operator=(std::move(static_cast<SqlConnection &>(other)));
    std::swap(m_file, other.m_file);
    std::swap(m_open, other.m_open);
    return *this;
}

Database::~Database()
{
    close();
}

DatabaseError Database::damaged()
{
    return {DatabaseError::Kind::broken, Journal::tr("it is damaged, or no database at all.")};
}

DatabaseError Database::locked()
{
    return {DatabaseError::Kind::locked, Journal::tr("another program has locked it.")};
}

DatabaseError Database::errorOf(const QSqlError &error)
{
    switch (primaryCode(error)) {
    case sqliteBusy:
        return locked();
    case sqliteInputOutput:
        return {DatabaseError::Kind::other, Journal::tr("its disk cannot be read or written.")};
    case sqliteCorrupt:
    case sqliteNoDatabase:
        return damaged();
    case sqliteFull:
        return {DatabaseError::Kind::other, Journal::tr("the disk is full.")};
    case sqliteReadOnly:
        return {DatabaseError::Kind::other, Journal::tr("it is not writable.")};
    case sqliteCannotOpen:
        return {DatabaseError::Kind::other, Journal::tr("its folder is not there, or you may not use it.")};
    case sqliteNoMemory:
        return {DatabaseError::Kind::broken, Journal::tr("it contains more than fits into memory.")};
    default:
        return {DatabaseError::Kind::other, error.databaseText()};
    }
}

Stored<Database> Database::open(const DatabasePlace &place, const DatabaseSchema &schema)
{
    if (!place.inMemory && !QDir().mkpath(QFileInfo(place.name).absolutePath()))
        return tl::unexpected(
            DatabaseError{DatabaseError::Kind::other, Journal::tr("its folder cannot be made.")});
    auto database = connect(place, Access::write);
    if (!database)
        return database;
    if (auto prepared = database->prepare(schema); !prepared)
        return tl::unexpected(prepared.error());
    return database;
}

Stored<Database> Database::openToRead(const QString &file, const DatabaseSchema &schema)
{
    auto database = connect(DatabasePlace::file(file), Access::read);
    if (!database)
        return database;
    const auto version =
        database->set()
            .and_then([&] { return database->execute(QStringLiteral("PRAGMA query_only = ON")); })
            .and_then([&] { return database->check(schema); });
    if (!version)
        return tl::unexpected(version.error());
    return database;
}

// If another kind of file has its name, it is not ours to put aside, and not touched. An empty file is a new
// database.
Stored<Database> Database::connect(const DatabasePlace &place, Access access)
{
    const QFileInfo info(place.name);
    if (!place.inMemory && info.exists() && !info.isFile()) // a pipe would never end
        return tl::unexpected(foreignFile(Journal::tr("it is not a file.")));
    const bool isRead = access == Access::read;
    if (isRead && !info.exists())
        return tl::unexpected(DatabaseError{DatabaseError::Kind::other, Journal::tr("it does not exist.")});
    if (isRead && !info.isReadable())
        return tl::unexpected(DatabaseError{DatabaseError::Kind::other, Journal::tr("it is not readable.")});
    const OpenFile::Turn turn = OpenFile::turn();
    std::optional<QByteArray> begin;
    if (!place.inMemory)
        begin = OpenFile::beginning(turn, place.name, journalModeAt + 1);
    if (begin && !begin->isEmpty() && !begin->startsWith(sqliteHeader))
        return tl::unexpected(foreignFile(Journal::tr("it is not a database, and was left as it was.")));

    Database database(QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), newName()),
                      place.inMemory ? QString() : place.name);
    QSqlDatabase &connection = database.connection();
    if (!connection.isValid())
        return tl::unexpected(DatabaseError{
            DatabaseError::Kind::other, Journal::tr("Qt's driver for SQLite is missing on this computer.")});
    const char *mode = !isRead ? "" : info.isWritable() ? "?mode=rw" : "?mode=ro";
    connection.setDatabaseName(uriOf(place, mode));
    connection.setConnectOptions(QString::fromLatin1(connectOptions));
    if (!connection.open())
        return tl::unexpected(errorOf(connection.lastError()));
    if (!place.inMemory)
        database.m_open = OpenFile(turn, place.name);
    if (begin && begin->size() > journalModeAt && begin->at(journalModeAt) == writeAheadLog)
        database.leaveWriteAheadLog();
    return database;
}

// Files of earlier versions have a write-ahead log. Locked for this program alone, it can be left without the
// file in shared memory. If another program has it open, it stays as it is.
void Database::leaveWriteAheadLog() const
{
    for (const char *step : {"PRAGMA locking_mode = EXCLUSIVE", "PRAGMA journal_mode = DELETE",
                             "PRAGMA locking_mode = NORMAL", "SELECT count(*) FROM sqlite_schema"})
        (void)execute(QString::fromLatin1(step));
}

Stored<void> Database::set() const
{
    for (const char *setting : settings)
        if (auto done = execute(QString::fromLatin1(setting)); !done)
            return done;
    return {};
}

Stored<void> Database::prepare(const DatabaseSchema &schema) const
{
    if (auto done = set(); !done)
        return done;
    const auto tables = number(QStringLiteral("SELECT count(*) FROM sqlite_schema"));
    if (!tables)
        return tl::unexpected(tables.error());
    if (auto ready = *tables == 0 ? make(schema) : raise(schema); !ready)
        return ready;
    return execute(schema.survivesPowerLoss ? QStringLiteral("PRAGMA synchronous = EXTRA")
                                            : QStringLiteral("PRAGMA synchronous = NORMAL"));
}

Stored<void> Database::make(const DatabaseSchema &schema) const
{
    // Only a database without tables accepts this.
    if (auto set = execute(QStringLiteral("PRAGMA auto_vacuum = INCREMENTAL")); !set)
        return set;
    return inTransaction([&]() -> Stored<void> {
        const auto found = objects();
        if (!found)
            return tl::unexpected(found.error());
        if (!found->isEmpty()) // another program was faster
            return check(schema).map([](qint64) {});
        for (const DatabaseSchema::Version &version : schema.versions)
            for (const QString &statement : version.statements)
                if (auto made = execute(statement); !made)
                    return made;
        if (auto told = execute(QStringLiteral("PRAGMA application_id = %1").arg(schema.applicationId));
            !told)
            return told;
        return execute(QStringLiteral("PRAGMA user_version = %1").arg(schema.versions.size()));
    });
}

// The version of the format it has.
Stored<qint64> Database::check(const DatabaseSchema &schema) const
{
    const auto kind = number(QStringLiteral("PRAGMA application_id"));
    auto version = number(QStringLiteral("PRAGMA user_version"));
    if (!kind || !version)
        return tl::unexpected(kind ? version.error() : kind.error());
    const auto found = objects();
    if (!found)
        return tl::unexpected(found.error());
    if (*kind == 0 && found->isEmpty())
        return tl::unexpected(DatabaseError{
            DatabaseError::Kind::other,
            Journal::tr("it is empty: the program that made it ended before anything was in it.")});
    if (*kind != schema.applicationId)
        return tl::unexpected(foreignFile(Journal::tr("it is the database of another program.")));
    if (*version > std::ssize(schema.versions))
        return tl::unexpected(DatabaseError{
            DatabaseError::Kind::newer,
            Journal::tr(
                "it was made by a newer Codewheel (version %1 of the file; this one reads up to version %2).")
                .arg(*version)
                .arg(schema.versions.size())});
    QStringList expected;
    for (qint64 i = 0; i < *version; ++i)
        expected << schema.versions[static_cast<std::size_t>(i)].statements;
    expected.sort();
    if (*found != expected)
        return tl::unexpected(damaged());
    return version;
}

// To the newest version.
Stored<void> Database::raise(const DatabaseSchema &schema) const
{
    if (const auto checked = check(schema); !checked || *checked == std::ssize(schema.versions))
        return checked ? Stored<void>() : tl::unexpected(checked.error());
    return inTransaction([&]() -> Stored<void> {
        const auto version = number(QStringLiteral("PRAGMA user_version")); // another program may be faster
        if (!version)
            return tl::unexpected(version.error());
        for (auto i = static_cast<std::size_t>(std::max<qint64>(*version, 0)); i < schema.versions.size();
             ++i)
            for (const QString &statement : schema.versions[i].statements + schema.versions[i].filling)
                if (auto done = execute(statement); !done)
                    return done;
        return execute(QStringLiteral("PRAGMA user_version = %1").arg(schema.versions.size()));
    });
}

// The statements of all tables, indices, ..., sorted.
Stored<QStringList> Database::objects() const
{
    QSqlQuery rows =
        query(QStringLiteral("SELECT sql FROM sqlite_schema WHERE name NOT LIKE 'sqlite\\_%' ESCAPE '\\'"));
    if (auto done = run(rows); !done)
        return tl::unexpected(done.error());
    QStringList found;
    while (rows.next())
        found.append(rows.value(0).toString());
    if (rows.lastError().isValid()) // in the middle of the file
        return tl::unexpected(errorOf(rows.lastError()));
    found.sort();
    return found;
}

Stored<void> Database::attempt(const QSqlQuery &query, const std::function<bool()> &isDone) const
{
    if (isDone())
        return {};
    for (BusyWait busy(m_file); primaryCode(query.lastError()) == sqliteBusy && busy.goesOn();)
        if (isDone())
            return {};
    return tl::unexpected(errorOf(query.lastError()));
}

QString putAside(const QString &path)
{
    const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz"));
    QString aside = QStringLiteral("%1.damaged-%2").arg(path, stamp);
    if (!QFile::rename(path, aside))
        return {};
    for (const QString &suffix : {QStringLiteral("-journal"), QStringLiteral("-wal"), QStringLiteral("-shm")})
        QFile::rename(path + suffix, aside + suffix);
    return aside;
}

} // namespace codewheel
