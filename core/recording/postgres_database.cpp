// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/postgres_database.h"

#include "recording/recording_tables.h"
#include "recording/server_texts.h"

#include <QSqlDriver>
#include <QSqlError>
#include <QSqlField>
#include <QSqlQuery>
#include <QVariant>

#include <clocale>

namespace codewheel {
namespace {

constexpr int oldestServer = 90'500; // has ON CONFLICT
constexpr int shownNames = 5;

const QString postgresDriver = QStringLiteral("QPSQL");

// PostgreSQL's library says why there is no connection in the language of the thread.
class EnglishThread
{
public:
    EnglishThread()
        : m_english(::newlocale(LC_MESSAGES_MASK, "C", static_cast<locale_t>(nullptr)))
        , m_before(::uselocale(m_english))
    {}
    ~EnglishThread()
    {
        (void)::uselocale(m_before);
        ::freelocale(m_english);
    }
    EnglishThread(const EnglishThread &) = delete;
    EnglishThread &operator=(const EnglishThread &) = delete;

private:
    locale_t m_english;
    locale_t m_before;
};

// A server whose cable was pulled says nothing: that has to be noticed before the disk is full.
QString connectOptionsOf(const ServerAddress &address)
{
    std::map<QString, QString> options{{QStringLiteral("connect_timeout"), QStringLiteral("5")},
                                       {QStringLiteral("tcp_user_timeout"), QStringLiteral("15000")},
                                       {QStringLiteral("keepalives_idle"), QStringLiteral("10")},
                                       {QStringLiteral("keepalives_interval"), QStringLiteral("5")},
                                       {QStringLiteral("keepalives_count"), QStringLiteral("3")},
                                       {QStringLiteral("application_name"), QStringLiteral("codewheel")}};
    for (const auto &[name, value] : address.options)
        options[name] = value;
    QStringList parts;
    for (const auto &[name, value] : options)
        parts << name + u'=' + value;
    return parts.join(u';');
}

DatabaseError serverProblem(const QString &reason)
{
    return {DatabaseError::Kind::other, reason};
}

QString inQuotes(const QString &name)
{
    return u'"' + name + u'"';
}

} // namespace

bool PostgresDatabase::isAvailable()
{
    return QSqlDatabase::isDriverAvailable(postgresDriver);
}

Stored<std::shared_ptr<PostgresDatabase>> PostgresDatabase::connect(const ServerAddress &address)
{
    const DatabaseError missing =
        serverProblem(Server::tr("Qt's driver for PostgreSQL is missing on this computer. "
                                 "Install the package libqt6sql6-psql."));
    if (!isAvailable())
        return tl::unexpected(missing);
    std::shared_ptr<PostgresDatabase> database(
        new PostgresDatabase(QSqlDatabase::addDatabase(postgresDriver, newName())));
    QSqlDatabase &connection = database->connection();
    if (!connection.isValid()) // the driver is there, and what it needs is not
        return tl::unexpected(missing);
    connection.setHostName(address.host);
    if (address.port != 0)
        connection.setPort(address.port);
    connection.setUserName(address.user);
    connection.setDatabaseName(address.database);
    connection.setConnectOptions(connectOptionsOf(address));
    const EnglishThread english;
    if (!connection.open())
        return tl::unexpected(connectionError(address, connection.lastError().databaseText()));
    return database->check().map([&] { return database; });
}

Stored<std::shared_ptr<PostgresDatabase>> PostgresDatabase::connectToRead(ServerAddress &address)
{
    auto database = connect(address);
    if (!database)
        return database;
    if (address.recording.isEmpty()) {
        const auto names = (*database)->recordings();
        if (!names)
            return tl::unexpected(names.error());
        if (names->isEmpty())
            return tl::unexpected(serverProblem(Server::tr("there is no recording in it.")));
        if (names->size() > 1)
            return tl::unexpected(serverProblem(
                Server::tr("there are several recordings in it. Add ?recording=NAME; the newest are: "
                           "%1.")
                    .arg(names->first(std::min<qsizetype>(shownNames, names->size()))
                             .join(QStringLiteral(", ")))));
        address.recording = names->front();
    }
    return (*database)->openRecording(address.recording).map([&] { return *database; });
}

DatabaseError PostgresDatabase::reasonOf(const QSqlError &error) const
{
    return statementError(error);
}

Stored<void> PostgresDatabase::check() const
{
    const auto version = number(QStringLiteral("SELECT current_setting('server_version_num')"));
    const auto encoding = texts(QStringLiteral("SELECT current_setting('server_encoding')"));
    if (!version || !encoding)
        return tl::unexpected(version ? encoding.error() : version.error());
    if (*version < oldestServer)
        return tl::unexpected(
            serverProblem(Server::tr("the server is too old: PostgreSQL 9.5 or newer is needed.")));
    if (encoding->value(0) != QStringLiteral("UTF8"))
        return tl::unexpected(
            serverProblem(Server::tr("its encoding is %1. Make a database with the encoding UTF8.")
                              .arg(encoding->value(0))));
    return {};
}

Stored<QStringList> PostgresDatabase::texts(const QString &sql) const
{
    QSqlQuery rows = query(sql);
    if (auto done = run(rows); !done)
        return tl::unexpected(done.error());
    QStringList all;
    while (rows.next())
        all << rows.value(0).toString();
    return all;
}

Stored<QStringList> PostgresDatabase::recordings() const
{
    return texts(
        QStringLiteral("SELECT nspname FROM pg_namespace JOIN pg_class ON relnamespace = pg_namespace.oid "
                       "WHERE relname = 'recording' AND nspname LIKE 'codewheel\\_%' "
                       "AND has_schema_privilege(pg_namespace.oid, 'USAGE') ORDER BY nspname DESC"));
}

Stored<void> PostgresDatabase::openRecording(const QString &name) const
{
    const auto all = recordings();
    if (!all)
        return tl::unexpected(all.error());
    if (!all->contains(name))
        return tl::unexpected(serverProblem(Server::tr("there is no recording %1 in it.").arg(name)));
    return execute(QStringLiteral("SET search_path TO ") + inQuotes(name))
        .and_then([&] { return execute(QStringLiteral("SET default_transaction_read_only TO on")); })
        .and_then([&] { return number(QStringLiteral("SELECT version FROM recording")); })
        .and_then([](qint64 version) -> Stored<void> {
            if (version == 0)
                return tl::unexpected(
                    serverProblem(Server::tr("nothing of the recording has arrived as yet.")));
            if (version > std::ssize(recordingSchema().versions))
                return tl::unexpected(DatabaseError{
                    DatabaseError::Kind::newer, Server::tr("the recording was made by a newer Codewheel.")});
            return {};
        });
}

Stored<void> PostgresDatabase::useRecording(const QString &name) const
{
    const auto all = recordings();
    if (!all)
        return tl::unexpected(all.error());
    if (!all->contains(name))
        if (auto made = inTransaction([&] { return makeTables(name); }); !made)
            return made;
    return execute(QStringLiteral("SET search_path TO ") + inQuotes(name));
}

Stored<void> PostgresDatabase::makeTables(const QString &name) const
{
    QSqlQuery making(connection());
    if (!making.exec(QStringLiteral("CREATE SCHEMA ") + inQuotes(name))) {
        const bool mayNot = making.lastError().nativeErrorCode() == QStringLiteral("42501");
        return tl::unexpected(mayNot ? serverProblem(Server::tr(
                                           "its user may not make a schema there. The owner of the database "
                                           "allows it with GRANT CREATE ON DATABASE."))
                                     : reasonOf(making.lastError()));
    }
    if (auto used = execute(QStringLiteral("SET LOCAL search_path TO ") + inQuotes(name)); !used)
        return used;
    for (const QString &statement : recordingTables(postgresDialect()))
        if (auto made = execute(statement); !made)
            return made;
    return {};
}

// PostgreSQL has no text with a zero in it.
QString PostgresDatabase::literal(const QVariant &value) const
{
    if (value.isNull())
        return QStringLiteral("NULL");
    const bool isText = value.typeId() == QMetaType::QString;
    QSqlField field(QString(), value.metaType());
    field.setValue(isText ? QVariant(value.toString().remove(QChar(0))) : value);
    return isText && field.value().toString().isEmpty() ? QStringLiteral("''")
                                                        : connection().driver()->formatValue(field);
}

} // namespace codewheel
