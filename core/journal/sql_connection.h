// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>
#include <QString>

#include <functional>
#include <tl/expected.hpp>

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
        away,    // a server that cannot be reached, or that went away
        other,   // not writable, disk full, ...
    };

    Kind kind = Kind::other;
    QString reason;
};
template <typename T>
using Stored = tl::expected<T, DatabaseError>;

// One connection to a database, whatever its kind; only the thread that opened it uses it.
class SqlConnection
{
public:
    virtual ~SqlConnection();

    // Ready to be run, and read row by row, once.
    QSqlQuery query(const QString &sql) const;
    Stored<void> run(QSqlQuery &query) const;
    Stored<void> execute(const QString &sql) const;
    // The first value of the first row; 0 if there is none.
    Stored<qint64> number(const QString &sql) const;

    // A transaction around `what`; undone if it fails.
    template <typename What>
    Stored<void> inTransaction(What what) const
    {
        if (auto begun = execute(beginning()); !begun)
            return begun;
        Stored<void> done = what();
        if (done)
            done = execute(QStringLiteral("COMMIT"));
        if (!done)
            (void)execute(QStringLiteral("ROLLBACK"));
        return done;
    }

    virtual DatabaseError reasonOf(const QSqlError &error) const = 0;

protected:
    explicit SqlConnection(const QSqlDatabase &connection)
        : m_connection(connection)
    {}
    SqlConnection(SqlConnection &&other) noexcept;
    SqlConnection &operator=(SqlConnection &&other) noexcept;
    static QString newName(); // of a connection

    // The statement that begins a transaction.
    virtual QString beginning() const = 0;
    // Calls `isDone` until it is, or there is no sense in going on.
    virtual Stored<void> attempt(const QSqlQuery &query, const std::function<bool()> &isDone) const;
    QSqlDatabase &connection() { return m_connection; }
    const QSqlDatabase &connection() const { return m_connection; }
    void close();

private:
    QSqlDatabase m_connection;
};

} // namespace codewheel
