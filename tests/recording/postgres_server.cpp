// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/recording/postgres_server.h"

#include <QDeadlineTimer>
#include <QDir>
#include <QFile>
#include <QSqlDatabase>
#include <QThread>

#include <gtest/gtest.h>
#include <pwd.h>
#include <unistd.h>

namespace codewheel::test {
namespace {

constexpr int generousTime = 120'000; // ms

} // namespace

QString PostgresServer::folderOfPrograms()
{
    const QDir all(QStringLiteral("/usr/lib/postgresql"));
    for (const QString &version :
         all.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name | QDir::Reversed))
        if (QFile::exists(all.filePath(version + QStringLiteral("/bin/initdb"))))
            return all.filePath(version + QStringLiteral("/bin/"));
    return {};
}

PostgresServer *PostgresServer::shared()
{
    if (folderOfPrograms().isEmpty() || !QSqlDatabase::isDriverAvailable(QStringLiteral("QPSQL")))
        return nullptr;
    static PostgresServer server;
    return &server;
}

// It ends with this program, however that ends.
QStringList PostgresServer::asOwner(const QStringList &command)
{
    QStringList owner{QStringLiteral("setpriv"), QStringLiteral("--pdeathsig=INT")};
    if (::geteuid() == 0)
        owner << QStringLiteral("--reuid=nobody") << QStringLiteral("--regid=nogroup")
              << QStringLiteral("--clear-groups");
    return owner + command;
}

bool PostgresServer::run(const QStringList &command, QString *said)
{
    QProcess process;
    process.setWorkingDirectory(QStringLiteral("/"));
    process.start(command.first(), command.sliced(1));
    const bool isDone = process.waitForFinished(generousTime) && process.exitCode() == 0;
    if (said != nullptr)
        *said = QString::fromUtf8(isDone ? process.readAllStandardOutput() : process.readAllStandardError());
    return isDone;
}

void PostgresServer::giveToOwner(const QStringList &paths)
{
    const passwd *nobody = ::geteuid() == 0 ? ::getpwnam("nobody") : nullptr;
    if (nobody == nullptr)
        return;
    for (const QString &path : paths) {
        const int failed = ::chown(QFile::encodeName(path).constData(), nobody->pw_uid, nobody->pw_gid);
        EXPECT_EQ(failed, 0);
    }
}

PostgresServer::PostgresServer()
{
    setPassword(QString::fromLatin1(password));
    const QString passwordFile = m_folder.filePath(QStringLiteral("first"));
    QFile file(passwordFile);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(password) > 0);
    file.close();
    giveToOwner({m_folder.path(), passwordFile});
    QString said;
    EXPECT_TRUE(run(asOwner({folderOfPrograms() + QStringLiteral("initdb"), QStringLiteral("-D"),
                             m_folder.filePath(QStringLiteral("data")), QStringLiteral("-U"),
                             QStringLiteral("admin"), QStringLiteral("--auth=scram-sha-256"),
                             QStringLiteral("--pwfile=") + passwordFile, QStringLiteral("--encoding=UTF8"),
                             QStringLiteral("--locale=C"), QStringLiteral("--no-sync")}),
                    &said))
        << said.toStdString();
    start();
}

PostgresServer::~PostgresServer()
{
    if (m_process)
        stop();
}

void PostgresServer::start()
{
    const QStringList command =
        asOwner({folderOfPrograms() + QStringLiteral("postgres"), QStringLiteral("-D"),
                 m_folder.filePath(QStringLiteral("data")), QStringLiteral("-k"), m_folder.path(),
                 QStringLiteral("-c"), QStringLiteral("listen_addresses="), QStringLiteral("-c"),
                 QStringLiteral("fsync=off")});
    m_process = std::make_unique<QProcess>();
    m_process->setWorkingDirectory(QStringLiteral("/"));
    m_process->setStandardErrorFile(QProcess::nullDevice());
    m_process->start(command.first(), command.sliced(1));
    EXPECT_TRUE(m_process->waitForStarted(generousTime));
    const QStringList asking{folderOfPrograms() + QStringLiteral("pg_isready"), QStringLiteral("-h"),
                             m_folder.path()};
    const QDeadlineTimer bound(generousTime);
    while (!run(asking) && m_process->state() == QProcess::Running && !bound.hasExpired())
        QThread::msleep(20);
    EXPECT_EQ(m_process->state(), QProcess::Running);
}

void PostgresServer::stop()
{
    ::kill(static_cast<pid_t>(m_process->processId()), SIGINT);
    EXPECT_TRUE(m_process->waitForFinished(generousTime));
    m_process.reset();
}

QString PostgresServer::execute(const QString &database, const QString &sql) const
{
    QString said;
    EXPECT_TRUE(run({folderOfPrograms() + QStringLiteral("psql"), QStringLiteral("-h"), m_folder.path(),
                     QStringLiteral("-U"), QStringLiteral("admin"), QStringLiteral("-w"),
                     QStringLiteral("-d"), database, QStringLiteral("-Atqc"), sql},
                    &said))
        << said.toStdString();
    return said.trimmed();
}

QString PostgresServer::newDatabase(const QString &options)
{
    const QString name = QStringLiteral("station%1").arg(++m_databases);
    execute(QStringLiteral("postgres"), QStringLiteral("CREATE DATABASE %1 %2").arg(name, options));
    return addressOf(name);
}

QString PostgresServer::addressOf(const QString &database, const QString &user) const
{
    QString folder = m_folder.path();
    return QStringLiteral("postgresql://%1@%2/%3")
        .arg(user, folder.replace(u'/', QStringLiteral("%2F")), database);
}

void PostgresServer::setPassword(const QString &text) const
{
    const QString path = m_folder.filePath(QStringLiteral("passwords"));
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("*:*:*:*:" + text.toUtf8() + '\n');
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner); // others are not believed
    qputenv("PGPASSFILE", QFile::encodeName(path));
    qunsetenv("PGPASSWORD");
}

} // namespace codewheel::test
