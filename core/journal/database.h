// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/open_file.h"

#include <QSqlDatabase>
#include <QString>
#include <QStringList>

#include <tl/expected.hpp>
#include <vector>

class QSqlError;
class QSqlQuery;

namespace codewheel {

// Why a database cannot be used. The reason is a sentence in the user's language.
struct DatabaseError
{
    enum class Kind : std::uint8_t {
        broken,  // a damaged database
        newer,   // made by a newer version of this program
        foreign, // not a database, or another program's
        locked,  // another program holds it, and does nothing
        other,   // not writable, disk full, ...
    };

    Kind kind = Kind::other;
    QString reason;
};
template <typename T>
using Stored = tl::expected<T, DatabaseError>;

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

// One connection to a SQLite database; only the thread that opened it uses it. Several programs may have the
// same file open, and wait for each other (BusyWait).
//
// It uses a rollback journal. With a write-ahead log (WAL), all programs share a file mapped into their
// memory, and if the disk is so full that a hole in it cannot be filled, they are killed by SIGBUS; without
// one, a full disk is an error that can be reported.
class Database
{
public:
    // Creates the file and its folders if they do not exist.
    static Stored<Database> open(const DatabasePlace &place, const DatabaseSchema &schema);
    // An existing file that is left as it is, also while another program writes to it. Where that program was
    // killed, its last change is undone first; that has to be allowed.
    static Stored<Database> openToRead(const QString &file, const DatabaseSchema &schema);

    Database(Database &&other) noexcept;
    Database &operator=(Database &&other) noexcept;
    ~Database();

    // Ready to be run, and read row by row, once.
    QSqlQuery query(const QString &sql) const;
    Stored<void> run(QSqlQuery &query) const;
    Stored<void> execute(const QString &sql) const;
    // The first value of the first row; 0 if there is none.
    Stored<qint64> number(const QString &sql) const;

    // BEGIN IMMEDIATE ... COMMIT around `what`; ROLLBACK if it fails.
    template <typename What>
    Stored<void> inTransaction(What what) const
    {
        if (auto begun = execute(QStringLiteral("BEGIN IMMEDIATE")); !begun)
            return begun;
        Stored<void> done = what();
        if (done)
            done = execute(QStringLiteral("COMMIT"));
        if (!done)
            (void)execute(QStringLiteral("ROLLBACK"));
        return done;
    }

    static DatabaseError errorOf(const QSqlError &error);
    static DatabaseError damaged();
    static DatabaseError locked();
    // Whether Qt's driver is there.
    static bool isAvailable();

private:
    Database(const QSqlDatabase &connection, QString file)
        : m_file(std::move(file))
        , m_connection(connection)
    {}
    enum class Access { write, read };
    static Stored<Database> connect(const DatabasePlace &place, Access access);
    Stored<void> set() const;
    Stored<void> prepare(const DatabaseSchema &schema) const;
    Stored<void> make(const DatabaseSchema &schema) const;
    Stored<qint64> check(const DatabaseSchema &schema) const;
    Stored<void> raise(const DatabaseSchema &schema) const;
    Stored<QStringList> objects() const;
    void leaveWriteAheadLog() const;
    void close();

    QString m_file;  // empty: in memory
    OpenFile m_open; // until the connection is closed
    QSqlDatabase m_connection;
};

// Puts a damaged file (and what belongs to it) aside under another name, which is returned; empty: it could
// not be renamed.
QString putAside(const QString &path);

} // namespace codewheel
