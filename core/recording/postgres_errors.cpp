// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/postgres_database.h"
#include "recording/server_texts.h"

#include <QRegularExpression>
#include <QSqlError>

#include <algorithm>
#include <initializer_list>

namespace codewheel {
namespace {

// Without "FATAL:" and the like, and the lines that follow.
QString saidBy(const QString &text)
{
    static const QRegularExpression level(QStringLiteral("\\A[A-Z]+:\\s*"));
    return text.section(u'\n', 0, 0).trimmed().remove(level) + u'.';
}

DatabaseError isAway(const QString &reason)
{
    return {DatabaseError::Kind::away, reason};
}

DatabaseError isNo(const QString &reason)
{
    return {DatabaseError::Kind::other, reason};
}

} // namespace

DatabaseError connectionError(const ServerAddress &address, const QString &text)
{
    const auto says = [&text](std::initializer_list<const char *> parts) {
        return std::ranges::any_of(
            parts, [&text](const char *part) { return text.contains(QString::fromLatin1(part)); });
    };
    if (says({"could not translate host name"}))
        return isAway(Server::tr("no computer of the name %1 is known.").arg(address.host));
    if (says({"starting up", "shutting down", "recovery mode"}))
        return isAway(Server::tr("the server is just starting or stopping."));
    if (says({"too many clients", "remaining connection slots"}))
        return isAway(Server::tr("the server has no connection free."));
    if (says({"no password supplied"}))
        return isNo(Server::tr("it asks for a password, and there is none. Put it into ~/.pgpass, into the "
                               "file that PGPASSFILE names, or into PGPASSWORD."));
    if (says({"password authentication failed"}))
        return isNo(Server::tr("user or password is wrong. The password is in ~/.pgpass, in the file that "
                               "PGPASSFILE names, or in PGPASSWORD."));
    if (says({"no pg_hba.conf entry"}))
        return isNo(Server::tr("the server does not let this user of this computer in (pg_hba.conf)."));
    if (says({"database \""}) && says({"\" does not exist"}))
        return isNo(Server::tr("the server has no database %1.").arg(address.database));
    if (says({"role \""}) && says({"\" does not exist"}))
        return isNo(Server::tr("the server has no such user."));
    if (says({"Connection refused", "No such file or directory"}))
        return isAway(Server::tr("no server answers there. Is it running, and is the port right?"));
    if (says({"timeout expired", "timed out"}))
        return isAway(Server::tr("its computer does not answer."));
    const QString said = saidBy(text);
    return says({"FATAL:", "SSL", "certificate"}) ? isNo(said) : isAway(said);
}

DatabaseError statementError(const QSqlError &error)
{
    const QString state = error.nativeErrorCode();
    if (state.isEmpty() || state.startsWith(QStringLiteral("08")) || state.startsWith(QStringLiteral("57P")))
        return isAway(Server::tr("the connection was lost."));
    if (state == QStringLiteral("42501"))
        return isNo(Server::tr("its user may not do that there: %1").arg(saidBy(error.databaseText())));
    if (state == QStringLiteral("25006"))
        return isNo(Server::tr("the server only lets it be read."));
    if (state == QStringLiteral("53100"))
        return isNo(Server::tr("the disk of the server is full."));
    if (state == QStringLiteral("42P01"))
        return isNo(Server::tr("a table of the recording is missing."));
    return isNo(saidBy(error.databaseText()));
}

} // namespace codewheel
