// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/sql_connection.h"
#include "recording/server_address.h"

#include <QStringList>

#include <memory>

namespace codewheel {

// A connection to a database of a PostgreSQL server, in which each recording has a schema of its own.
class PostgresDatabase final : public SqlConnection
{
public:
    static Stored<std::shared_ptr<PostgresDatabase>> connect(const ServerAddress &address);
    // To the recording of the address, or the only one there is; it is left as it is.
    static Stored<std::shared_ptr<PostgresDatabase>> connectToRead(ServerAddress &address);
    // Whether Qt's driver is there.
    static bool isAvailable();

    // The names of all that may be read, newest first.
    Stored<QStringList> recordings() const;
    // From then on all tables are those of that recording; they are made if there are none.
    Stored<void> useRecording(const QString &name) const;
    // As it is written in a statement.
    QString literal(const QVariant &value) const;

    DatabaseError reasonOf(const QSqlError &error) const override;

private:
    explicit PostgresDatabase(const QSqlDatabase &connection)
        : SqlConnection(connection)
    {}
    QString beginning() const override { return QStringLiteral("BEGIN"); }
    Stored<QStringList> texts(const QString &sql) const;
    Stored<void> check() const;
    Stored<void> openRecording(const QString &name) const;
    Stored<void> makeTables(const QString &name) const;
};

// Why there is no connection: PostgreSQL's library tells it as an English text and nothing else.
DatabaseError connectionError(const ServerAddress &address, const QString &text);
// Why a statement failed: by its SQLSTATE; without one the connection is lost.
DatabaseError statementError(const QSqlError &error);

} // namespace codewheel
