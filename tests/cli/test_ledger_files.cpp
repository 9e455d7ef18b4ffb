// SPDX-License-Identifier: GPL-3.0-or-later
// A ledger carried to another computer, and one that cannot be written to.
#include "journal/ledger.h"
#include "tests/cli/cli_run.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

class CliLedgerFiles : public testing::Test
{
protected:
    QString path(const char *name) const { return folder.filePath(QString::fromLatin1(name)); }
    CliRun run(const char *line) const
    {
        return runLine(QString::fromLatin1(line).replace(QStringLiteral("%1"), folder.path()));
    }
    int counted(const char *ledger) const
    {
        int writes = 0;
        for (const QJsonValue account :
             run((std::string("ledger --json --ledger %1/") + ledger).c_str()).json()[u"accounts"].toArray())
            writes += account[u"writes"].toInt() + account[u"perhaps"].toInt();
        return writes;
    }
    void setVersion(int version) const
    {
        const QString name = QStringLiteral("version");
        {
            auto connection = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), name);
            connection.setDatabaseName(path("ledger.sqlite"));
            EXPECT_TRUE(connection.open());
            EXPECT_TRUE(QSqlQuery(connection).exec(QStringLiteral("PRAGMA user_version = %1").arg(version)));
        }
        QSqlDatabase::removeDatabase(name);
    }

    QTemporaryDir folder;
};

TEST_F(CliLedgerFiles, CountsAreCarriedToAnotherComputer)
{
    EXPECT_EQ(run("write 1.0 steps=255 --yes --ledger %1/there.sqlite").exit, 0);
    EXPECT_EQ(run("write 1.0 steps=255 --yes --ledger %1/here.sqlite").exit, 0);
    EXPECT_EQ(run("ledger export %1/counts.json --ledger %1/there.sqlite").out,
              "Saved in " + path("counts.json").toStdString() + ": entries of the ledger: 1.\n");
    for (const int added : {1, 0}) {
        const CliRun imported = run("ledger import %1/counts.json --ledger %1/here.sqlite --json");
        EXPECT_EQ(imported.exit, 0);
        EXPECT_EQ(imported.json()[u"added"], added);
        EXPECT_EQ(imported.json()[u"known"], 1 - added);
        EXPECT_EQ(counted("here.sqlite"), 2);
    }
}

TEST_F(CliLedgerFiles, WhatCannotBeCarriedIsTold)
{
    EXPECT_EQ(run("write 1.0 steps=255 --yes --ledger %1/ledger.sqlite").exit, 0);
    QFile text(path("counts.json"));
    ASSERT_TRUE(text.open(QIODevice::WriteOnly) && text.write("{}") == 2);
    text.close();
    EXPECT_EQ(errorKey(run("ledger export %1/counts.json --json --ledger %1/ledger.sqlite")), "fileExists");
    EXPECT_EQ(errorKey(run("ledger import %1/counts.json --json --ledger %1/ledger.sqlite")),
              "fileNotReadable");
    EXPECT_EQ(errorKey(run("ledger import %1/none.json --json --ledger %1/ledger.sqlite")),
              "fileNotReadable");
    EXPECT_EQ(errorKey(run("ledger carry %1/counts.json --json")), "badLedgerCall");
    EXPECT_EQ(errorKey(run("ledger export --json")), "badLedgerCall");
    EXPECT_EQ(run("ledger export %1/counts.json --yes --ledger %1/ledger.sqlite").exit, 0);
}

// The line is the second bus of the call.
TEST_F(CliLedgerFiles, WhatIsNotEnteredWaitsInTheFileThatIsTold)
{
    EXPECT_EQ(run("write 05 steps=864 --yes --ledger %1/ledger.sqlite").exit, 0);
    setVersion(9);
    const CliRun write = run("write 05 steps=1000 --yes --ledger %1/ledger.sqlite");
    EXPECT_EQ(write.exit, 1);
    const QStringList waiting =
        QDir(folder.path()).entryList({QStringLiteral("*.waiting-*")}, QDir::Files | QDir::Hidden);
    ASSERT_EQ(waiting.size(), 1);
    EXPECT_THAT(write.err,
                HasSubstr("kept in " + path(waiting.front().toLatin1().constData()).toStdString()));
    EXPECT_EQ(QString::fromStdString(write.err).count(QStringLiteral("kept in")), 1);
}

TEST_F(CliLedgerFiles, WhatIsWrittenButNotEnteredIsToldAndEnteredLater)
{
    EXPECT_EQ(run("write 1.0 steps=255 --yes --ledger %1/ledger.sqlite").exit, 0);
    setVersion(9);
    const CliRun read = run("read 1.0 steps --ledger %1/ledger.sqlite --json");
    EXPECT_EQ(read.exit, 2) << "it writes nothing, and takes no ledger";
    const CliRun write = run("write 1.0 steps=255 --yes --json --ledger %1/ledger.sqlite");
    EXPECT_EQ(write.exit, 1);
    EXPECT_EQ(errorKey(write), "notCounted");
    EXPECT_EQ(write.json()[u"written"].toArray().size(), 1) << write.out;
    EXPECT_THAT(write.err, HasSubstr("are not entered in the ledger"));
    EXPECT_THAT(write.err, HasSubstr("a newer Codewheel"));
    EXPECT_THAT(write.err, HasSubstr("kept in " + path("ledger.sqlite").toStdString() + ".waiting-"));
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 2);
    setVersion(2);
    EXPECT_EQ(counted("ledger.sqlite"), 2);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 1);
}

} // namespace
} // namespace codewheel
