// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/sql_connection.h"

#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>

#include <atomic>

namespace codewheel {

QString SqlConnection::newName()
{
    static std::atomic<quint64> counter = 0;
    return QStringLiteral("codewheel-%1").arg(++counter);
}

SqlConnection::SqlConnection(SqlConnection &&other) noexcept
    : m_connection(std::exchange(other.m_connection, {}))
{}

SqlConnection &SqlConnection::operator=(SqlConnection &&other) noexcept
{
    std::swap(m_connection, other.m_connection);
    return *this;
}

SqlConnection::~SqlConnection()
{
    close();
}

void SqlConnection::close()
{
    const QString name = m_connection.connectionName();
    if (name.isEmpty())
        return;
    m_connection.close();
    m_connection = {};
    QSqlDatabase::removeDatabase(name);
}

Stored<void> SqlConnection::attempt(const QSqlQuery &query, const std::function<bool()> &isDone) const
{
    return isDone() ? Stored<void>() : tl::unexpected(reasonOf(query.lastError()));
}

QSqlQuery SqlConnection::query(const QString &sql) const
{
    QSqlQuery query(m_connection);
    query.setForwardOnly(true);
    (void)attempt(query, [&] { return query.prepare(sql); }); // running it reports why
    return query;
}

Stored<void> SqlConnection::run(QSqlQuery &query) const
{
    return attempt(query, [&] { return query.exec(); });
}

Stored<void> SqlConnection::execute(const QString &sql) const
{
    QSqlQuery query(m_connection);
    return attempt(query, [&] { return query.exec(sql); });
}

Stored<qint64> SqlConnection::number(const QString &sql) const
{
    QSqlQuery query(m_connection);
    return attempt(query, [&] { return query.exec(sql); }).map([&] {
        return query.next() ? query.value(0).toLongLong() : 0;
    });
}

} // namespace codewheel
