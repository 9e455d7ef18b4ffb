// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/database.h"

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
constexpr int sqliteNoMemory = 7;
constexpr int sqliteReadOnly = 8;
constexpr int sqliteCorrupt = 11;
constexpr int sqliteFull = 13;
constexpr int sqliteNoDatabase = 26;

constexpr QByteArrayView sqliteHeader("SQLite format 3", 16); // with its zero

constexpr auto connectOptions = "QSQLITE_BUSY_TIMEOUT=5000;QSQLITE_OPEN_URI";

// For each connection. A schema of a hostile file shall call nothing, and one row shall not take all memory.
constexpr const char *settings[] = {
    "PRAGMA trusted_schema = OFF",
    "PRAGMA cell_size_check = ON",
    "PRAGMA hard_heap_limit = 536870912",
};

QString newName()
{
    static std::atomic<quint64> counter = 0;
    return QStringLiteral("codewheel-%1").arg(++counter);
}

DatabaseError brokenFile()
{
    return {DatabaseError::Kind::broken, Journal::tr("it is damaged, or no database at all.")};
}

// Where another kind of file has its name, it is not ours to put aside. An empty file is a new database.
std::optional<DatabaseError> otherFileAt(const QString &path)
{
    const auto other = [](const QString &reason) {
        return DatabaseError{DatabaseError::Kind::foreign, reason};
    };
    const QFileInfo info(path);
    if (!info.exists())
        return std::nullopt;
    if (!info.isFile()) // a pipe would never end
        return other(Journal::tr("it is no file."));
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return std::nullopt; // SQLite says why
    const QByteArray begin = file.read(sqliteHeader.size());
    if (begin.isEmpty() || begin == sqliteHeader)
        return std::nullopt;
    return other(Journal::tr("it is no database, and was left as it was."));
}

QStringList objects(const QSqlDatabase &connection)
{
    QSqlQuery query(connection);
    QStringList found;
    query.exec(QStringLiteral("SELECT sql FROM sqlite_schema WHERE name NOT LIKE 'sqlite\\_%' ESCAPE '\\'"));
    while (query.next())
        found.append(query.value(0).toString());
    return found;
}

// As a URI, since the name of a file may hold what means something there.
QString uriOf(const DatabasePlace &place)
{
    if (place.inMemory)
        return QStringLiteral("file:/%1?vfs=memdb").arg(place.name);
    return QStringLiteral("file:") +
           QString::fromLatin1(QFile::encodeName(QFileInfo(place.name).absoluteFilePath())
                                   .toPercentEncoding(QByteArrayLiteral("/")));
}

} // namespace

DatabasePlace DatabasePlace::memory()
{
    return {newName(), true};
}

Database::Database(Database &&other) noexcept
    : m_connection(std::exchange(other.m_connection, {}))
{}

Database &Database::operator=(Database &&other) noexcept
{
    std::swap(m_connection, other.m_connection);
    return *this;
}

Database::~Database()
{
    close();
}

void Database::close()
{
    const QString name = m_connection.connectionName();
    if (name.isEmpty())
        return;
    m_connection.close();
    m_connection = {};
    QSqlDatabase::removeDatabase(name);
}

DatabaseError Database::errorOf(const QSqlError &error)
{
    const int code = error.nativeErrorCode().toInt() & 0xFF; // without the extended part
    switch (code) {
    case sqliteCorrupt:
    case sqliteNoDatabase:
        return brokenFile();
    case sqliteFull:
        return {DatabaseError::Kind::other, Journal::tr("the disk is full.")};
    case sqliteReadOnly:
        return {DatabaseError::Kind::other, Journal::tr("it is not writable.")};
    case sqliteNoMemory:
        return {DatabaseError::Kind::broken, Journal::tr("it holds more than fits into the memory.")};
    default:
        return {DatabaseError::Kind::other, error.databaseText()};
    }
}

bool Database::isAvailable()
{
    return QSqlDatabase::isDriverAvailable(QStringLiteral("QSQLITE"));
}

Stored<Database> Database::open(const DatabasePlace &place, const DatabaseSchema &schema)
{
    if (!place.inMemory && !QDir().mkpath(QFileInfo(place.name).absolutePath()))
        return tl::unexpected(
            DatabaseError{DatabaseError::Kind::other, Journal::tr("its folder cannot be made.")});
    if (const auto other = place.inMemory ? std::nullopt : otherFileAt(place.name))
        return tl::unexpected(*other);
    Database database(QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), newName()));
    QSqlDatabase &connection = database.m_connection;
    if (!connection.isValid())
        return tl::unexpected(DatabaseError{
            DatabaseError::Kind::other, Journal::tr("Qt's driver for SQLite is missing on this computer.")});
    connection.setDatabaseName(uriOf(place));
    connection.setConnectOptions(QString::fromLatin1(connectOptions));
    if (!connection.open())
        return tl::unexpected(errorOf(connection.lastError()));
    if (auto prepared = database.prepare(schema); !prepared)
        return tl::unexpected(prepared.error());
    return database;
}

Stored<void> Database::prepare(const DatabaseSchema &schema) const
{
    for (const char *setting : settings)
        if (auto set = execute(QString::fromLatin1(setting)); !set)
            return set;
    const auto tables = number(QStringLiteral("SELECT count(*) FROM sqlite_schema"));
    if (!tables)
        return tl::unexpected(tables.error());
    if (auto ready = *tables == 0 ? make(schema) : check(schema); !ready)
        return ready;
    return execute(schema.survivesPowerLoss ? QStringLiteral("PRAGMA synchronous = FULL")
                                            : QStringLiteral("PRAGMA synchronous = NORMAL"));
}

Stored<void> Database::make(const DatabaseSchema &schema) const
{
    // Only a database without tables takes these two.
    for (const auto &setting :
         {QStringLiteral("PRAGMA auto_vacuum = INCREMENTAL"), QStringLiteral("PRAGMA journal_mode = WAL")})
        if (auto set = execute(setting); !set)
            return set;
    return inTransaction([&]() -> Stored<void> {
        if (!objects(m_connection).isEmpty()) // another program was faster
            return check(schema);
        QStringList statements = schema.statements;
        statements << QStringLiteral("PRAGMA application_id = %1").arg(schema.applicationId)
                   << QStringLiteral("PRAGMA user_version = %1").arg(schema.version);
        for (const QString &statement : statements)
            if (auto made = execute(statement); !made)
                return made;
        return {};
    });
}

Stored<void> Database::check(const DatabaseSchema &schema) const
{
    const auto kind = number(QStringLiteral("PRAGMA application_id"));
    const auto version = number(QStringLiteral("PRAGMA user_version"));
    if (!kind || !version)
        return tl::unexpected(kind ? version.error() : kind.error());
    if (*kind != schema.applicationId)
        return tl::unexpected(DatabaseError{DatabaseError::Kind::foreign,
                                            Journal::tr("it is the database of another program.")});
    if (*version > schema.version)
        return tl::unexpected(DatabaseError{
            DatabaseError::Kind::newer,
            Journal::tr("it was made by a newer Codewheel (version %1 of the file; this one reads up to %2).")
                .arg(*version)
                .arg(schema.version)});
    QStringList found = objects(m_connection);
    QStringList expected = schema.statements;
    found.sort();
    expected.sort();
    if (found != expected)
        return tl::unexpected(brokenFile());
    return {};
}

QSqlQuery Database::query(const QString &sql) const
{
    QSqlQuery query(m_connection);
    query.setForwardOnly(true);
    query.prepare(sql);
    return query;
}

Stored<void> Database::execute(const QString &sql) const
{
    QSqlQuery query(m_connection);
    if (!query.exec(sql))
        return tl::unexpected(errorOf(query.lastError()));
    return {};
}

Stored<qint64> Database::number(const QString &sql) const
{
    QSqlQuery query(m_connection);
    if (!query.exec(sql))
        return tl::unexpected(errorOf(query.lastError()));
    return query.next() ? query.value(0).toLongLong() : 0;
}

QString putAside(const QString &path)
{
    const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz"));
    QString aside = QStringLiteral("%1.damaged-%2").arg(path, stamp);
    if (!QFile::rename(path, aside))
        return {};
    for (const QString &suffix : {QStringLiteral("-wal"), QStringLiteral("-shm")})
        QFile::rename(path + suffix, aside + suffix);
    return aside;
}

} // namespace codewheel
