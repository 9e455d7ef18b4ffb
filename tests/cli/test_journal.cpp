// SPDX-License-Identifier: GPL-3.0-or-later
// What is kept on disk: messages listed and exported, EEPROM writes counted, and consent asked for.
#include "journal/ledger.h"
#include "journal/message_store.h"
#include "journal_files.h"
#include "project/bus_kind.h"
#include "project/project_file.h"
#include "tests/cli/cli_run.h"
#include "tests/support/no_room.h"
#include "tests/support/places.h"
#include "tests/support/scripted_link.h"
#include "vocabulary/job.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

class CliJournal : public testing::Test
{
protected:
    QString path(const char *name) const { return folder.filePath(QString::fromLatin1(name)); }
    CliRun run(const char *line, const Person &person = {}) const
    {
        return runLine(QString::fromLatin1(line).arg(folder.path()), person);
    }
    // So many writes to the encoder at 1.0 of this project, or of none.
    void count(int writes, const QString &project = {}) const
    {
        auto ledger = Ledger::open(DatabasePlace::file(path("ledger.sqlite")));
        ASSERT_TRUE(ledger);
        const EncoderIdentity fraba{.by = CountedBy::place,
                                    .vendor = {},
                                    .serialNumber = {},
                                    .project = project,
                                    .place = {firstBus, NodeId("1.0")}};
        ASSERT_TRUE(ledger->begin({.at = QDateTime(QDate(2026, 3, 1), QTime(12, 0), Qt::UTC),
                                   .identity = fraba.key(),
                                   .place = fraba.place,
                                   .device = QStringLiteral("fraba-ocd-ib"),
                                   .planned = writes,
                                   .writes = writes,
                                   .settled = true}));
    }
    int counted() const
    {
        int writes = 0;
        for (const Ledger::Account &account :
             Ledger::open(DatabasePlace::file(path("ledger.sqlite")))->accounts())
            writes += account.count.atMost();
        return writes;
    }

    QTemporaryDir folder;
};

TEST_F(CliJournal, AFileThatIsNoLedgerStaysWhereItIs)
{
    QFile file(path("x.codewheel"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{}");
    file.close();
    const CliRun looked = run("ledger --ledger %1/x.codewheel");
    EXPECT_EQ(looked.exit, 1);
    EXPECT_NE(looked.err.find("x.codewheel cannot be used: it is not a database, and was left as it was."),
              std::string::npos)
        << looked.err;
    const CliRun written = run("write 1.0 steps=2048 --yes --ledger %1/x.codewheel");
    EXPECT_NE(written.err.find("it is not a database"), std::string::npos) << written.err;
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files), QStringList{QStringLiteral("x.codewheel")});
}

class CliMessages : public CliJournal
{
protected:
    CliMessages()
    {
        MessageStore store({.file = path("messages.sqlite")});
        const QDateTime noon(QDate(2026, 3, 1), QTime(12, 0));
        store.add({.place = Place{firstBus, {}}, .id = MessageId::busStarted}, noon);
        store.add({.place = "1.0"_ring,
                   .severity = Severity::fault,
                   .id = MessageId::deviceFault,
                   .arguments = {std::int64_t{3}, Word{0x86000000}}},
                  noon.addSecs(60));
    }
};

TEST_F(CliMessages, AreListed)
{
    const CliRun all = run("messages --file %1/messages.sqlite");
    EXPECT_EQ(all.exit, 0);
    EXPECT_NE(all.out.find("Information  Bus  The bus runs."), std::string::npos) << all.out;
    EXPECT_NE(all.out.find("Fault        1.0  The encoder reports error 3 (IN 86000000)."), std::string::npos)
        << all.out;
}

TEST_F(CliMessages, AreFiltered)
{
    for (const char *filter :
         {"--severity fault", "--place 1.0", "--from 2026-03-01T12:01", "--text 8600", "--last 1"}) {
        const CliRun one = run(("messages --json --file %1/messages.sqlite " + std::string(filter)).c_str());
        const QJsonArray messages = one.json()[u"messages"].toArray();
        ASSERT_EQ(messages.size(), 1) << filter;
        EXPECT_EQ(messages[0][u"code"], QStringLiteral("deviceFault"));
        EXPECT_EQ(messages[0][u"arguments"][1][u"word"], QStringLiteral("86000000"));
    }
    EXPECT_EQ(
        run("messages --json --file %1/messages.sqlite --place bus").json()[u"messages"].toArray().size(), 1);
    EXPECT_EQ(run("messages --json --file %1/messages.sqlite --until 2026-03-01")
                  .json()[u"messages"]
                  .toArray()
                  .size(),
              0);
}

// Of two buses: a stop is reported with its bus, and each bus can be viewed alone.
TEST_F(CliMessages, TellTheBus)
{
    {
        MessageStore store({.file = path("messages.sqlite")});
        const QDateTime later(QDate(2026, 3, 1), QTime(13, 0));
        store.add({.place = Place{BusId{3}, {}}, .id = MessageId::busStopped}, later);
        store.add({.place = Place{BusId{3}, NodeId("1.0")}, .id = MessageId::valuesForgotten}, later);
    }
    const CliRun all = run("messages --file %1/messages.sqlite");
    EXPECT_NE(all.out.find("Information  1      The bus runs."), std::string::npos) << all.out;
    EXPECT_NE(all.out.find("Fault        1/1.0  The encoder"), std::string::npos) << all.out;
    EXPECT_NE(all.out.find("Information  3      The bus is stopped."), std::string::npos) << all.out;
    EXPECT_NE(all.out.find("Information  3/1.0  "), std::string::npos) << all.out;

    const QJsonArray third =
        run("messages --json --file %1/messages.sqlite --bus 3").json()[u"messages"].toArray();
    ASSERT_EQ(third.size(), 2);
    EXPECT_EQ(third[0][u"bus"], 3);
    EXPECT_TRUE(third[0][u"place"].isNull());
    EXPECT_EQ(third[1][u"place"], QStringLiteral("1.0"));
    EXPECT_EQ(run("messages --json --file %1/messages.sqlite --bus 1").json()[u"messages"].toArray().size(),
              2);
    EXPECT_EQ(errorKey(run("messages --json --file %1/messages.sqlite --bus Crane")), "badBus");
    EXPECT_EQ(errorKey(run("messages --json --file %1/messages.sqlite --bus 3 --place 1.0")), "badOption");
}

TEST_F(CliMessages, APlaceIsTakenAsItIsListed)
{
    {
        MessageStore store({.file = path("messages.sqlite")});
        store.add({.place = Place{BusId{4}, NodeId("esc:03")}, .id = MessageId::valuesForgotten},
                  QDateTime(QDate(2026, 3, 1), QTime(13, 0)));
    }
    Project project;
    project.buses = {{BusId{4}, QStringLiteral("esc"), QStringLiteral("Gate"), {}}};
    project.buses.front().settings = busKind(QStringLiteral("esc"))->usual();
    ASSERT_TRUE(saveProject(project, path("gate.codewheel")));
    for (const char *place : {"4/03", "4/esc:03", "Gate/03", "Gate/esc:03"}) {
        const CliRun one = run((std::string("messages --json --file %1/messages.sqlite --project "
                                            "%1/gate.codewheel --place ") +
                                place)
                                   .c_str());
        EXPECT_EQ(one.json()[u"messages"].toArray().size(), 1) << place;
    }
    EXPECT_NE(run("messages --project %1/gate.codewheel --bus Nix").err.find("Its buses are: Gate."),
              std::string::npos);
    EXPECT_EQ(errorKey(runLine(QStringLiteral("devices --json --bus Nix"))), "unknownBus");
}

TEST_F(CliMessages, NoneThatFitsIsTold)
{
    for (const char *filter : {"--from 2026-12-01 --until 2026-01-01", "--place 99.99"})
        EXPECT_EQ(run(("messages --file %1/messages.sqlite " + std::string(filter)).c_str()).out,
                  "No stored message matches.\n");
}

TEST_F(CliMessages, AreExported)
{
    EXPECT_EQ(run("messages --file %1/messages.sqlite --export %1/all.csv").exit, 0);
    QFile file(path("all.csv"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll().count("\r\n"), 3);
    EXPECT_EQ(errorKey(run("messages --file %1/messages.sqlite --export %1/all.pdf --json")), "badFormat");
}

TEST_F(CliMessages, AFileThatIsThereIsReplacedWithYesOnly)
{
    QFile file(path("all.csv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.close();
    const char *const line = "messages --file %1/messages.sqlite --export %1/all.csv --json";
    EXPECT_EQ(errorKey(run(line)), "fileExists");
    EXPECT_EQ(file.size(), 0);
    EXPECT_EQ(run((line + std::string(" --yes")).c_str()).exit, 0);
    EXPECT_GT(QFileInfo(file.fileName()).size(), 0);
}

TEST_F(CliMessages, WhereThereIsNoRoomTheOldExportStaysAndItIsTold)
{
    {
        MessageStore store({.file = path("messages.sqlite")});
        for (int i = 0; i < 1'000; ++i)
            store.add({.id = MessageId::training, .arguments = {QString(100, u'x')}},
                      QDateTime::currentDateTime());
    }
    for (const char *name : {"all.csv", "all.html"}) {
        QFile file(path(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("old");
        file.close();
        const CliRun told = [&] {
            const test::NoRoom disk(50'000); // SQLite writes less than this to read
            return run(("messages --file %1/messages.sqlite --yes --export %1/" + std::string(name)).c_str());
        }();
        EXPECT_EQ(told.exit, 1) << name;
        EXPECT_NE(told.err.find("cannot be written: File too large."), std::string::npos) << told.err;
        EXPECT_EQ(told.out, "");
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        EXPECT_EQ(file.readAll(), "old") << name;
    }
}

TEST_F(CliMessages, BadInputIsTold)
{
    EXPECT_EQ(errorKey(runLine(QStringLiteral("messages --severity bad --json"))), "badSeverity");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("messages --place here --json"))), "badPlace");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("messages --from yesterday --json"))), "badTime");
}

// The same for window and command line: writes to real encoders are kept.
TEST_F(CliJournal, OnlySimulatedEncodersAreCountedInMemory)
{
    const Catalog catalog = Catalog::builtIn();
    RingSession real(std::make_unique<ScriptedLink>(1), catalog, QDateTime::currentDateTime());
    EXPECT_FALSE(ledgerPlace(real, folder.path()).inMemory);
    EXPECT_EQ(ledgerPlace(real, folder.path()).name, ledgerFile(folder.path()));
    const TrainingSession training = openTrainingSession(catalog, QDateTime::currentDateTime());
    EXPECT_TRUE(ledgerPlace(*training.bus, folder.path()).inMemory);
}

TEST_F(CliJournal, LookingMakesNoFile)
{
    EXPECT_EQ(run("messages --file %1/none.sqlite").exit, 0);
    EXPECT_EQ(run("ledger --ledger %1/none.sqlite").exit, 0);
    EXPECT_FALSE(QFile::exists(path("none.sqlite")));
}

TEST_F(CliJournal, ADamagedFileIsToldAndLeftAlone)
{
    QFile file(path("broken.sqlite"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(QByteArray(9'000, 'x')) == 9'000);
    file.close();
    EXPECT_EQ(errorKey(run("messages --file %1/broken.sqlite --json")), "databaseFailed");
    EXPECT_EQ(errorKey(run("ledger --ledger %1/broken.sqlite --json")), "databaseFailed");
    EXPECT_EQ(QFile(path("broken.sqlite")).size(), 9'000);
}

TEST_F(CliJournal, WritesAreCountedInALedger)
{
    EXPECT_EQ(run("write 1.0 steps=255 --yes --ledger %1/ledger.sqlite").exit, 0);
    const CliRun listed = run("ledger --ledger %1/ledger.sqlite --json");
    const QJsonObject account = listed.json()[u"accounts"][0].toObject();
    EXPECT_EQ(account[u"writes"], 1);
    EXPECT_EQ(account[u"perhaps"], 0);
    EXPECT_EQ(account[u"place"], QStringLiteral("1.0"));
    EXPECT_EQ(account[u"device"], QStringLiteral("fraba-ocd-ib"));
}

TEST_F(CliJournal, WarnsAndAsksFromThreeQuartersOfTheBudgetOn)
{
    count(149);
    EXPECT_EQ(errorKey(run("preset 1.0 1000 --json --ledger %1/ledger.sqlite")), "eepromBudgetUsed");
    EXPECT_EQ(counted(), 149);
    const CliRun write = run("write 1.0 steps=255 --yes --ledger %1/ledger.sqlite");
    EXPECT_EQ(write.exit, 0);
    EXPECT_NE(write.err.find("has written 149 times"), std::string::npos) << write.err;
    EXPECT_EQ(counted(), 150);
}

TEST_F(CliJournal, AsksBeyondTheBudget)
{
    count(200);
    EXPECT_EQ(errorKey(run("preset 1.0 1000 --json --ledger %1/ledger.sqlite")), "eepromBudgetUsed");
    EXPECT_EQ(counted(), 200);
    EXPECT_EQ(run("preset 1.0 1000 --ledger %1/ledger.sqlite", {true, "n\n"}).exit, 1);
    EXPECT_EQ(counted(), 200);
    EXPECT_EQ(run("preset 1.0 1000 --ledger %1/ledger.sqlite", {true, "y\n"}).exit, 0);
    EXPECT_GT(counted(), 200);
    EXPECT_EQ(run("preset 1.0 1001 --yes --ledger %1/ledger.sqlite").exit, 0);
}

TEST_F(CliJournal, WantsThePlaceTypedBeyondTheLimit)
{
    count(500);
    EXPECT_EQ(errorKey(run("write 1.0 steps=255 --yes --json --ledger %1/ledger.sqlite")),
              "eepromLimitPassed");
    EXPECT_EQ(
        errorKey(run("write 1.0 steps=255 --yes --json --beyond-eeprom-limit 2.0 --ledger %1/ledger.sqlite")),
        "eepromLimitPassed");
    const CliRun nobody = run("write 1.0 steps=255 --yes --ledger %1/ledger.sqlite");
    EXPECT_THAT(nobody.err, HasSubstr("1.0: With 500 writes by this program"));
    EXPECT_THAT(nobody.err, HasSubstr("--beyond-eeprom-limit 1.0."));
    EXPECT_EQ(run("write 1.0 steps=255 --ledger %1/ledger.sqlite", {true, "y\ny\n"}).exit, 1);
    EXPECT_EQ(counted(), 500);
    EXPECT_EQ(run("write 1.0 steps=255 --ledger %1/ledger.sqlite", {true, "1.0\ny\n"}).exit, 0);
    EXPECT_EQ(run("write 1.0 steps=256 --yes --beyond-eeprom-limit 1.0 --ledger %1/ledger.sqlite").exit, 0);
    EXPECT_EQ(counted(), 502);
}

// The calls that start each kind of job, and whether it may write to an EEPROM, in the order of Job: enter
// new ones here. %2 is a project with the encoder at 1.0.
struct JobRow
{
    std::vector<const char *> calls; // none: no command does this
    bool writes;
};
const std::vector<JobRow> jobRows{
    {{"read 1.0 steps", "velocity 1.0 on", "store %2 1.0", "report %2 -o %1/report.html --read"}, false},
    {{"write 1.0 steps=255 --yes", "transfer %2 1.0 --yes"}, true},
    {{"preset 1.0", "preset 1.0 1000", "preset 1.0 --fraba"}, true},
    {{"words 1.0 020000FF", "words 1.0 40000000", "words 1.0 20800001 46000015 20800000"}, true},
    {{}, true},                                         // EndParameterization
    {{"velocity 1.0 off --device fraba-ocd-ib"}, true}, // so that its mode is not known
    {{"reset 1.0 --yes"}, true},
    {{"cams 1.0 read --program 1", "cams 1.0 compare %3/cams.json", "clone 1.0 6.1 --cams --yes",
      "store %2 1.0 --cams"},
     true},
    {{"cams 1.0 write %3/cams.json --yes"}, true},
    {{}, true}}; // StoreParameters

TEST_F(CliJournal, NoKindOfJobWritesPastTheLimitUnlessThePlaceIsTyped)
{
    ASSERT_EQ(jobRows.size(), std::variant_size_v<Job>);
    const QString examples = QStringLiteral(CODEWHEEL_ROOT "/docs/examples");
    const QString project = path("training.codewheel");
    for (const JobRow &row : jobRows)
        for (const char *line : row.calls) {
            for (const char *made : {"ledger.sqlite", "training.codewheel", "report.html"})
                QFile::remove(path(made));
            ASSERT_TRUE(QFile::copy(examples + QStringLiteral("/training.codewheel"), project));
            count(500);
            count(500, project);
            QString call = QString::fromLatin1(line) + QStringLiteral(" --json");
            if (row.writes)
                call += QStringLiteral(" --ledger %1/ledger.sqlite");
            call.replace(QStringLiteral("%1"), folder.path());
            call.replace(QStringLiteral("%2"), project);
            call.replace(QStringLiteral("%3"), examples);
            const CliRun first = runLine(call);
            EXPECT_EQ(first.exit, row.writes ? 1 : 0) << line << first.out;
            EXPECT_EQ(errorKey(first), row.writes ? "eepromLimitPassed" : "") << line;
            EXPECT_EQ(counted(), 1000) << line;
            if (row.writes) {
                EXPECT_NE(errorKey(runLine(call + QStringLiteral(" --beyond-eeprom-limit 1.0,6.1"))),
                          "eepromLimitPassed")
                    << line;
            }
        }
}

// Asked only once: setting the position takes two writes, the values before it two more.
TEST_F(CliJournal, AsksOnceForAllThatIsWrittenToAnEncoder)
{
    const QString project = QStringLiteral(CODEWHEEL_ROOT "/docs/examples/training.codewheel");
    count(199, project);
    const QString call =
        QStringLiteral("transfer %1 1.0 --ledger %2/ledger.sqlite").arg(project, folder.path());
    const CliRun written = runLine(call + QStringLiteral(" --yes"));
    EXPECT_EQ(written.exit, 0);
    EXPECT_NE(written.err.find("199 writes by this program and 2 more"), std::string::npos) << written.err;
}

} // namespace
} // namespace codewheel
