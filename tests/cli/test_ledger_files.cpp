// SPDX-License-Identifier: GPL-3.0-or-later
// A ledger carried to another computer, and one that cannot be written to.
#include "journal/ledger.h"
#include "tests/cli/cli_run.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QSysInfo>
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

TEST_F(CliLedgerFiles, SeveralFilesAreImportedTogetherOrNotAtAll)
{
    EXPECT_EQ(run("write 1.0 steps=255 --yes --ledger %1/a.sqlite").exit, 0);
    EXPECT_EQ(run("write 1.0 steps=256 --yes --ledger %1/b.sqlite").exit, 0);
    EXPECT_EQ(run("ledger export %1/a.json --ledger %1/a.sqlite").exit, 0);
    EXPECT_EQ(run("ledger export %1/b.json --ledger %1/b.sqlite").exit, 0);
    EXPECT_EQ(errorKey(run("ledger import %1/a.json %1/none.json --json --ledger %1/here.sqlite")),
              "fileNotReadable");
    EXPECT_EQ(counted("here.sqlite"), 0);
    EXPECT_EQ(run("ledger import %1/a.json %1/b.json --json --ledger %1/here.sqlite").json()[u"added"], 2);
    EXPECT_EQ(counted("here.sqlite"), 2);
}

TEST_F(CliLedgerFiles, TheEntriesAreListedWithWhoWrote)
{
    setLedgerUser(QStringLiteral("Ada"));
    EXPECT_EQ(run("write 1.0 steps=255 --yes --ledger %1/ledger.sqlite").exit, 0);
    setLedgerUser({});
    EXPECT_EQ(run("write 1.0 steps=256 --yes --ledger %1/ledger.sqlite").exit, 0);
    const QJsonArray entries =
        run("ledger entries --json --ledger %1/ledger.sqlite").json()[u"entries"].toArray();
    ASSERT_EQ(entries.size(), 2);
    EXPECT_EQ(entries[0][u"user"], QStringLiteral("Ada"));
    EXPECT_EQ(entries[0][u"computer"], QSysInfo::machineHostName());
    EXPECT_EQ(entries[0][u"writes"], 1);
    EXPECT_EQ(entries[1][u"user"], QString());
    const CliRun text = run("ledger entries --ledger %1/ledger.sqlite");
    EXPECT_THAT(text.out, HasSubstr("Ada"));
    EXPECT_THAT(text.out, HasSubstr(QSysInfo::machineHostName().toStdString()));
    EXPECT_THAT(run("ledger entries --ledger %1/none.sqlite").out, HasSubstr("No EEPROM writes"));
}

class CliLedgerFolder : public CliLedgerFiles
{
protected:
    CliLedgerFolder()
    {
        EXPECT_TRUE(QDir(folder.path()).mkdir(QStringLiteral("shared")));
        EXPECT_EQ(run("write 1.0 steps=255 --yes --ledger %1/here.sqlite").exit, 0);
        EXPECT_EQ(run("write 1.0 steps=256 --yes --ledger %1/there.sqlite").exit, 0);
        EXPECT_EQ(run("ledger export %1/shared/eeprom-writes-hall-3.json --ledger %1/there.sqlite").exit, 0);
    }
    static QByteArray bytesOf(const QString &file)
    {
        QFile opened(file);
        EXPECT_TRUE(opened.open(QIODevice::ReadOnly));
        return opened.readAll();
    }
    CliRun mergeHere() const { return run("ledger merge %1/shared --json --ledger %1/here.sqlite"); }
    QStringList shared() const
    {
        return QDir(path("shared")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot, QDir::Name);
    }
    void put(const char *name, const QByteArray &bytes) const
    {
        QFile file(path("shared") + u'/' + QString::fromLatin1(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
};

TEST_F(CliLedgerFolder, IsReadAndGetsAFileOfThisComputer)
{
    const CliRun first = mergeHere();
    EXPECT_EQ(first.exit, 0) << first.err;
    EXPECT_EQ(first.json()[u"added"], 1);
    EXPECT_EQ(first.json()[u"entries"], 2);
    const QString own = first.json()[u"saved"].toString();
    EXPECT_EQ(shared().size(), 2);
    EXPECT_EQ(counted("here.sqlite"), 2);
    const QByteArray left = bytesOf(own);
    const QDateTime changed = QFileInfo(own).lastModified();
    const CliRun again = mergeHere();
    EXPECT_EQ(again.json()[u"added"], 0);
    EXPECT_EQ(counted("here.sqlite"), 2) << "nothing is counted twice";
    EXPECT_EQ(bytesOf(own), left);
    EXPECT_EQ(QFileInfo(own).lastModified(), changed) << "nothing is new, so it is not written";
    // The other computer takes it from there.
    EXPECT_EQ(run("ledger merge %1/shared --ledger %1/there.sqlite").exit, 0);
    EXPECT_EQ(counted("there.sqlite"), 2);
}

// Two ledgers of one computer, or two computers of one name.
TEST_F(CliLedgerFolder, AFileOfTheSameNameLosesNothing)
{
    EXPECT_EQ(mergeHere().exit, 0);
    EXPECT_EQ(run("write 1.0 steps=300 --yes --ledger %1/third.sqlite").exit, 0);
    EXPECT_EQ(run("ledger merge %1/shared --json --ledger %1/third.sqlite").json()[u"entries"], 3);
    EXPECT_EQ(mergeHere().json()[u"added"], 1);
    EXPECT_EQ(counted("here.sqlite"), 3);
}

TEST_F(CliLedgerFolder, WhatCannotBeReadIsNamedAndStaysAsItIs)
{
    const QByteArray half =
        bytesOf(path("shared") + QStringLiteral("/eeprom-writes-hall-3.json")).chopped(20);
    put("eeprom-writes-hall-4.json", half);
    put("notes.json", "{}");
    const CliRun merged = mergeHere();
    EXPECT_EQ(merged.exit, 1);
    EXPECT_EQ(errorKey(merged), "ledgerFilesNotRead");
    EXPECT_THAT(merged.err, HasSubstr("eeprom-writes-hall-4.json"));
    EXPECT_EQ(merged.json()[u"added"], 1) << "the others are taken in";
    EXPECT_EQ(bytesOf(path("shared") + QStringLiteral("/eeprom-writes-hall-4.json")), half);
    const QString own = merged.json()[u"saved"].toString();
    EXPECT_TRUE(QFileInfo::exists(own));
    put(QFileInfo(own).fileName().toLatin1().constData(), half);
    const CliRun again = mergeHere();
    EXPECT_EQ(again.exit, 1);
    EXPECT_EQ(bytesOf(own), half) << "it may hold what nobody else has";
}

TEST_F(CliLedgerFolder, HasToBeThere)
{
    EXPECT_EQ(errorKey(run("ledger merge %1/none --json --ledger %1/here.sqlite")), "noFolder");
    EXPECT_EQ(errorKey(run("ledger merge %1/here.sqlite --json --ledger %1/here.sqlite")), "noFolder");
    EXPECT_EQ(errorKey(run("ledger merge --json")), "badLedgerCall");
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
    setVersion(3);
    EXPECT_EQ(counted("ledger.sqlite"), 2);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 1);
}

} // namespace
} // namespace codewheel
