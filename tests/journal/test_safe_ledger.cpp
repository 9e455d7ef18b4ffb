// SPDX-License-Identifier: GPL-3.0-or-later
// A ledger whose file fails: nothing is lost, and the failure is reported.
#include "journal/safe_ledger.h"
#include "tests/journal/journal_file.h"
#include "tests/support/places.h"
#include "vocabulary/refusal_text.h"

#include <csignal>
#include <gmock/gmock.h>
#include <sys/resource.h>

namespace codewheel {
namespace {

using test::JournalFile;

class SafeLedgerTest : public testing::Test
{
protected:
    static EncoderIdentity encoder(const char *serialNumber)
    {
        return {.by = CountedBy::serialNumber,
                .vendor = QStringLiteral("FRABA"),
                .serialNumber = QString::fromLatin1(serialNumber),
                .project = {},
                .place = "1.0"_ring};
    }
    static Ledger::Entry entryOf(const EncoderIdentity &identity, int planned)
    {
        return {.at = QDateTime::currentDateTimeUtc(),
                .identity = identity.key(),
                .by = identity.by,
                .place = identity.place,
                .planned = planned};
    }
    // Makes writing fail as other programs could, and lets it succeed again.
    void refuseChanges() const
    {
        for (const char *what : {"INSERT", "UPDATE"})
            file.execute(QStringLiteral("CREATE TRIGGER no_%1 BEFORE %1 ON entry BEGIN "
                                        "SELECT RAISE(FAIL, 'no'); END")
                             .arg(QLatin1String(what)));
    }
    void allowChanges() const
    {
        for (const char *what : {"INSERT", "UPDATE"})
            file.execute(QStringLiteral("DROP TRIGGER no_%1").arg(QLatin1String(what)));
    }
    EepromCount counted() const { return Ledger::open(file.place())->writes(encoder("1")); }

    JournalFile file;
};

TEST_F(SafeLedgerTest, LeavesNothingBesideItAsLongAsItsFileIsGood)
{
    {
        SafeLedger ledger(file.place());
        ledger.settle(*ledger.begin(entryOf(encoder("1"), 1)), {});
        EXPECT_FALSE(ledger.problem());
        EXPECT_FALSE(ledger.hasUncounted());
    }
    EXPECT_EQ(file.names(), QStringList{QStringLiteral("journal.sqlite")});
}

TEST_F(SafeLedgerTest, KeepsBesideTheFileWhatThatRefusesUntilTheNextOneOpensIt)
{
    int told = 0;
    {
        SafeLedger ledger(file.place());
        ledger.onProblem([&] { ++told; });
        const auto before = ledger.begin(entryOf(encoder("1"), 3));
        ledger.count(*before, 1);
        refuseChanges();
        ledger.count(*before, 2); // and the rest of the job under way
        ASSERT_TRUE(ledger.problem());
        EXPECT_EQ(ledger.problem()->id, MessageId::keptBeside);
        EXPECT_EQ(told, 1);
        ledger.settle(*before, {});
        const auto later = ledger.begin(entryOf(encoder("1"), 2));
        ledger.count(*later, 1);
        EXPECT_EQ(ledger.ledger()->writes(encoder("1")).writes, 4);
        EXPECT_TRUE(ledger.hasUncounted());
        EXPECT_EQ(told, 1);
        allowChanges();
        EXPECT_EQ(counted().writes, 1) << "it is still the other program's";
    }
    EXPECT_EQ(counted().writes, 4);
    EXPECT_EQ(counted().perhaps, 1);
    EXPECT_EQ(file.names(), QStringList{QStringLiteral("journal.sqlite")});
}

TEST_F(SafeLedgerTest, AJobThatWroteNothingLeavesNoDoubt)
{
    {
        SafeLedger ledger(file.place());
        const auto id = ledger.begin(entryOf(encoder("1"), 3));
        refuseChanges();
        ledger.settle(*id, {});
        allowChanges();
    }
    EXPECT_EQ(counted().atMost(), 0);
}

TEST_F(SafeLedgerTest, WhatIsLeftTwiceIsCountedOnce)
{
    (void)Ledger::open(file.place());
    const QString copy = file.path + QStringLiteral(".waiting-copy");
    {
        refuseChanges();
        allowChanges();
        SafeLedger ledger(file.place());
        refuseChanges();
        ledger.count(*ledger.begin(entryOf(encoder("1"), 1)), 1);
        allowChanges();
        const QString waiting = file.names().filter(QStringLiteral("waiting")).value(0);
        ASSERT_TRUE(QFile::copy(file.folder() + u'/' + waiting, copy)); // as a kill leaves it, with its room
        EXPECT_EQ(QFileInfo(copy).size(), WaitingEntries::room);
        EXPECT_EQ(counted().writes, 1);
        EXPECT_FALSE(QFile::exists(copy));
    }
    EXPECT_EQ(counted().writes, 1);
}

TEST_F(SafeLedgerTest, ALineCutShortAndWhatIsNoneAreLeftOut)
{
    (void)Ledger::open(file.place());
    const QByteArray line = [&] {
        SafeLedger ledger(file.place());
        refuseChanges();
        ledger.begin(entryOf(encoder("1"), 1));
        allowChanges();
        QFile waiting(file.folder() + u'/' + file.names().filter(QStringLiteral("waiting")).value(0));
        EXPECT_TRUE(waiting.open(QIODevice::ReadOnly));
        return waiting.readLine();
    }();
    const auto put = [&](const char *name, const QByteArray &bytes) {
        QFile left(file.path + QLatin1String(name));
        EXPECT_TRUE(left.open(QIODevice::WriteOnly) && left.write(bytes) == bytes.size());
    };
    put(".waiting-a", line + line.first(line.size() / 2));
    put(".waiting-b", "no entries");
    EXPECT_EQ(counted().perhaps, 1);
    EXPECT_FALSE(QFile::exists(file.path + QStringLiteral(".waiting-a")));
    EXPECT_TRUE(QFile::exists(file.path + QStringLiteral(".waiting-b"))) << "nobody's to delete";
}

TEST_F(SafeLedgerTest, ALockIsWaitedForAndThenTold)
{
    SafeLedger ledger(file.place());
    const QString name = QStringLiteral("locker");
    auto connection = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), name);
    connection.setDatabaseName(file.path);
    ASSERT_TRUE(connection.open());
    ASSERT_TRUE(QSqlQuery(connection).exec(QStringLiteral("BEGIN EXCLUSIVE")));
    ledger.count(*ledger.begin(entryOf(encoder("1"), 1)), 1);
    ASSERT_TRUE(ledger.problem());
    EXPECT_EQ(ledger.problem()->id, MessageId::keptBeside);
    EXPECT_THAT(messageText(*ledger.problem()).toStdString(),
                testing::HasSubstr("another program has locked it."));
    EXPECT_EQ(ledger.ledger()->writes(encoder("1")).writes, 1);
    connection.close();
    connection = {};
    QSqlDatabase::removeDatabase(name);
}

// The file size limit of a process stands in for a full disk.
TEST_F(SafeLedgerTest, AFullDiskIsToldAndLosesNothing)
{
    (void)Ledger::open(file.place());
    constexpr int times = 8;
    const auto tooSmall = static_cast<rlim_t>(QFileInfo(file.path).size() / 2);
    {
        SafeLedger ledger(file.place());
        const auto before = std::signal(SIGXFSZ, SIG_IGN);
        rlimit limit{};
        ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
        const rlimit small{tooSmall, limit.rlim_max};
        ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
        for (int i = 0; i < times; ++i) {
            const auto id = ledger.begin(entryOf(encoder("1"), 1));
            ledger.count(*id, 1);
            ledger.settle(*id, {});
        }
        ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
        std::signal(SIGXFSZ, before);
        ASSERT_TRUE(ledger.problem());
        EXPECT_TRUE(ledger.hasUncounted());
        EXPECT_EQ(ledger.ledger()->writes(encoder("1")).writes, times);
    }
    EXPECT_EQ(counted().writes, times);
}

} // namespace
} // namespace codewheel
