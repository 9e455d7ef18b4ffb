// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProcess>
#include <QString>
#include <QTemporaryDir>

#include <memory>

namespace codewheel::test {

// A PostgreSQL server of this program alone: in a temporary folder, on a socket there. It refuses to run as
// root, so where the tests do it runs as nobody.
class PostgresServer
{
public:
    // The one for all tests of the program; nullptr: Debian's server or Qt's driver for it is not installed.
    static PostgresServer *shared();

    PostgresServer();
    ~PostgresServer();
    Q_DISABLE_COPY(PostgresServer)

    void start();
    void stop(); // at once; who is connected loses the connection
    QString execute(const QString &database, const QString &sql) const; // as its administrator
    // The address of a new database.
    QString newDatabase(const QString &options = {});
    QString addressOf(const QString &database, const QString &user = QStringLiteral("admin")) const;
    // In the file that PGPASSFILE names.
    void setPassword(const QString &password) const;

    static constexpr auto password = "the-secret-of-the-test";

private:
    static QString folderOfPrograms();
    static QStringList asOwner(const QStringList &command);
    static void giveToOwner(const QStringList &paths);
    static bool run(const QStringList &command, QString *said = nullptr);

    QTemporaryDir m_folder{QStringLiteral("/tmp/cwpg-XXXXXX")}; // the name of a socket is short
    std::unique_ptr<QProcess> m_process;
    int m_databases = 0;
};

} // namespace codewheel::test
