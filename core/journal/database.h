// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/open_file.h"
#include "journal/sql_connection.h"

#include <QStringList>

#include <vector>

namespace codewheel {

// Where a database is: a file, or the memory of this program for as long as somebody has it open.
struct DatabasePlace
{
    QString name;
    bool inMemory = false;

    static DatabasePlace file(const QString &path) { return {path, false}; }
    static DatabasePlace memory(); // a different one with each call

    friend bool operator==(const DatabasePlace &, const DatabasePlace &) = default;
};

// The contents of one of our databases. The statements are compared with those in the file, letter by letter.
struct DatabaseSchema
{
    // What a version of the format added.
    struct Version
    {
        QStringList statements;   // CREATE ...
        QStringList filling = {}; // fills in what a file of the previous version lacks
    };

    int applicationId = 0;         // in the header of the file: what kind of file it is
    std::vector<Version> versions; // 1, 2, ...
    // Nothing committed is missing even after a loss of power. After the end of the program, however it
    // ended, nothing is missing in any case.
    bool survivesPowerLoss = false;
};

// One connection to a SQLite database. Several programs may have the same file open, and wait for each other
// (BusyWait).
//
// It uses a rollback journal. With a write-ahead log (WAL), all programs share a file mapped into their
// memory, and if the disk is so full that a hole in it cannot be filled, they are killed by SIGBUS; without
// one, a full disk is an error that can be reported.
class Database final : public SqlConnection
{
public:
    // Creates the file and its folders if they do not exist.
    static Stored<Database> open(const DatabasePlace &place, const DatabaseSchema &schema);
    // An existing file that is left as it is, also while another program writes to it. Where that program was
    // killed, its last change is undone first; that has to be allowed.
    static Stored<Database> openToRead(const QString &file, const DatabaseSchema &schema);

    Database(Database &&other) noexcept;
    Database &operator=(Database &&other) noexcept;
    ~Database() override;

    static DatabaseError errorOf(const QSqlError &error);
    DatabaseError reasonOf(const QSqlError &error) const override { return errorOf(error); }
    static DatabaseError damaged();
    static DatabaseError locked();
    // Whether Qt's driver is there.
    static bool isAvailable() { return QSqlDatabase::isDriverAvailable(QStringLiteral("QSQLITE")); }

private:
    Database(const QSqlDatabase &connection, QString file)
        : SqlConnection(connection)
        , m_file(std::move(file))
    {}
    QString beginning() const override { return QStringLiteral("BEGIN IMMEDIATE"); }
    // Until no other program holds the file.
    Stored<void> attempt(const QSqlQuery &query, const std::function<bool()> &isDone) const override;
    enum class Access { write, read };
    static Stored<Database> connect(const DatabasePlace &place, Access access);
    Stored<void> set() const;
    Stored<void> prepare(const DatabaseSchema &schema) const;
    Stored<void> make(const DatabaseSchema &schema) const;
    Stored<qint64> check(const DatabaseSchema &schema) const;
    Stored<void> raise(const DatabaseSchema &schema) const;
    Stored<QStringList> objects() const;
    void leaveWriteAheadLog() const;

    QString m_file;  // empty: in memory
    OpenFile m_open; // until the connection is closed
};

// Puts a damaged file (and what belongs to it) aside under another name, which is returned; empty: it could
// not be renamed.
QString putAside(const QString &path);

} // namespace codewheel
