// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/message_table.h"

#include <QDir>
#include <QFile>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace codewheel::test {

// A file in a folder of its own, and what can be done to it from outside.
class JournalFile
{
public:
    DatabasePlace place() const { return DatabasePlace::file(path); }
    QStringList names() const { return QDir(m_folder.path()).entryList(QDir::Files, QDir::Name); }
    QString folder() const { return m_folder.path(); }

    void fill(const QByteArray &bytes) const
    {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        EXPECT_EQ(file.write(bytes), bytes.size());
    }
    // How every SQLite file begins.
    static QByteArray header() { return {"SQLite format 3", 16}; }
    // As another program would.
    void execute(const QString &sql) const
    {
        {
            auto connection = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), path);
            connection.setDatabaseName(path);
            EXPECT_TRUE(connection.open());
            QSqlQuery query(connection);
            EXPECT_TRUE(query.exec(sql)) << sql.toStdString();
        }
        QSqlDatabase::removeDatabase(path);
    }

private:
    QTemporaryDir m_folder;

public:
    const QString path = m_folder.filePath(QStringLiteral("journal.sqlite"));
};

// "Trained: WHAT", at a time in ms.
inline StoredMessage messageAt(qint64 at, const char *what, std::optional<Place> place = {},
                               Severity severity = Severity::information)
{
    return storedMessage({.place = place,
                          .severity = severity,
                          .id = MessageId::training,
                          .arguments = {QString::fromUtf8(what)}},
                         QDateTime::fromMSecsSinceEpoch(at));
}

} // namespace codewheel::test
