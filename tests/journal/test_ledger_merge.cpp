// SPDX-License-Identifier: GPL-3.0-or-later
// Counts carried from one ledger to another.
#include "journal/ledger_json.h"
#include "tests/journal/journal_file.h"
#include "tests/support/places.h"

namespace codewheel {
namespace {

using test::JournalFile;

const EncoderIdentity seven{.by = CountedBy::serialNumber,
                            .vendor = QStringLiteral("FRABA"),
                            .serialNumber = QStringLiteral("7"),
                            .project = {},
                            .place = "1.0"_ring};

class LedgerMerge : public testing::Test
{
protected:
    static qint64 begin(Ledger &ledger, const EncoderIdentity &identity, int planned)
    {
        return *ledger.begin({.at = QDateTime(QDate(2026, 3, 1), QTime(12, 0), Qt::UTC),
                              .identity = identity.key(),
                              .by = identity.by,
                              .place = identity.place,
                              .device = QStringLiteral("fraba-ocd-ib"),
                              .planned = planned,
                              .before = {{Parameter::steps, 4096, Evidence::read,
                                          QDateTime(QDate(2026, 3, 1), QTime(11, 0), Qt::UTC)}}});
    }
    // Its content as files.
    static std::vector<Ledger::Record> carried(const Ledger &ledger)
    {
        const auto records = recordsFromJson(recordsToJson(*ledger.records(), false));
        EXPECT_TRUE(records) << records.error().toStdString();
        return *records;
    }

    JournalFile thereFile;
    JournalFile hereFile;
    Ledger there = *Ledger::open(thereFile.place());
    Ledger here = *Ledger::open(hereFile.place());
};

TEST_F(LedgerMerge, AddsTheWritesToTheSameEncoderOnce)
{
    const qint64 job = begin(there, seven, 2);
    ASSERT_TRUE(there.count(job, 2));
    ASSERT_TRUE(there.settle(job, {{Parameter::steps, 255}}));
    ASSERT_TRUE(here.count(begin(here, seven, 1), 1)); // at the same time, but a different one
    for (int times = 0; times < 2; ++times)
        ASSERT_TRUE(here.merge(carried(there)));
    EXPECT_EQ(here.writes(seven).writes, 3);
    EXPECT_EQ(here.writes(seven).perhaps, 0);
    const auto entries = here.valuesBefore(seven);
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_EQ(entries[0].written, (ParameterValues{{Parameter::steps, 255}}));
    EXPECT_EQ(entries[0].before, there.valuesBefore(seven)[0].before);
    // And back again.
    const auto merged = there.merge(carried(here));
    EXPECT_EQ(merged->added, 1);
    EXPECT_EQ(merged->known, 1);
    EXPECT_EQ(there.writes(seven).writes, 3);
}

TEST_F(LedgerMerge, LearnsWhatBecameOfAnEntry)
{
    EncoderIdentity place = seven;
    place.by = CountedBy::place;
    const qint64 job = begin(there, place, 3);
    ASSERT_TRUE(here.merge(carried(there)));
    EXPECT_EQ(here.writes(place).perhaps, 3);
    ASSERT_TRUE(there.count(job, 2));
    ASSERT_TRUE(there.settle(job, {}));
    ASSERT_TRUE(there.attribute({job}, seven));
    ASSERT_TRUE(here.merge(carried(there)));
    EXPECT_EQ(here.writes(place).atMost(), 0);
    EXPECT_EQ(here.writes(seven).writes, 2);
    EXPECT_EQ(here.writes(seven).perhaps, 0);
}

TEST_F(LedgerMerge, LearnsThatAnEntryEndedWithoutAWrite)
{
    const qint64 job = begin(there, seven, 3);
    ASSERT_TRUE(here.merge(carried(there)));
    EXPECT_EQ(here.writes(seven).perhaps, 3) << "it was under way";
    ASSERT_TRUE(there.settle(job, {}));
    ASSERT_TRUE(here.merge(carried(there)));
    EXPECT_EQ(here.writes(seven).perhaps, 0);
    EXPECT_TRUE(here.accounts().empty());
    // Nor does an old file bring it back.
    Ledger third = *Ledger::open(DatabasePlace::memory());
    const auto merged = third.merge(carried(there));
    EXPECT_EQ(merged->added, 0);
    EXPECT_TRUE(third.records()->empty());
}

TEST_F(LedgerMerge, AnOldFileDoesNotBringBackWhatHasEnded)
{
    const qint64 job = begin(there, seven, 3);
    const auto old = carried(there);
    ASSERT_TRUE(there.settle(job, {}));
    ASSERT_TRUE(there.merge(old));
    EXPECT_TRUE(there.accounts().empty());
}

TEST_F(LedgerMerge, KeepsWhoWrote)
{
    setLedgerUser(QStringLiteral("Ada"));
    ASSERT_TRUE(there.count(begin(there, seven, 1), 1));
    setLedgerUser({});
    ASSERT_TRUE(here.merge(carried(there)));
    EXPECT_EQ(here.records()->front().entry.writer, there.records()->front().entry.writer);
    EXPECT_EQ(here.records()->front().entry.writer.user, QStringLiteral("Ada"));
}

TEST_F(LedgerMerge, TheSamePlaceOnTwoBusesIsTwoPlaces)
{
    Ledger::Record record{.origin = QStringLiteral("a")};
    record.entry = {.at = QDateTime(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC),
                    .identity = QStringLiteral("place/4/esc:05"),
                    .by = CountedBy::place,
                    .place = {{4}, NodeId("esc:05")}};
    const QByteArray json = recordsToJson({record}, false).replace(": ", ":");
    EXPECT_TRUE(json.contains(R"("bus":4)")) << json.toStdString();
    EXPECT_TRUE(json.contains(R"("place":"esc:05")")) << json.toStdString();
    EXPECT_EQ(recordsFromJson(json)->front().entry.place, record.entry.place);

    const QByteArray before = R"({"format":"codewheel-ledger","version":1,"entries":[{"id":"a",)"
                              R"("at":"2026-03-01T13:00:00.000Z","identity":"x","countedBy":"place",)"
                              R"("place":"4/esc:05","device":"","planned":1,"writes":1,"settled":true,)"
                              R"("before":[],"written":[]}]})";
    EXPECT_EQ(recordsFromJson(before)->front().entry.place, record.entry.place)
        << "of a file that has the bus in the place";
}

TEST_F(LedgerMerge, WhatIsWrongWithAFileIsTold)
{
    const QByteArray good = recordsToJson({}, false);
    EXPECT_TRUE(recordsFromJson(good));
    const char *negativeWrites =
        R"({"format":"codewheel-ledger","version":1,"entries":[{"id":"a","at":"x","identity":"serial/A/1",)"
        R"("countedBy":"place","place":"1.0","device":"","planned":1,"writes":-1,"settled":true,)"
        R"("before":[],"written":[]}]})";
    for (const char *bad :
         {"", "{}", R"({"format":"codewheel-ledger","version":3,"entries":[]})",
          R"({"format":"codewheel-ledger","version":0,"entries":[]})",
          R"({"format":"codewheel-ledger","version":1,"entries":[{"id":"a"}]})", negativeWrites}) {
        const auto read = recordsFromJson(bad);
        ASSERT_FALSE(read) << bad;
        EXPECT_NE(read.error(), QString()) << bad;
    }
}

// As made by an earlier version, with a write-ahead log.
TEST(LedgerOfAnEarlierVersion, IsTakenOver)
{
    const JournalFile file;
    for (const char *statement :
         {"PRAGMA auto_vacuum = INCREMENTAL", "PRAGMA journal_mode = WAL",
          "CREATE TABLE entry (id INTEGER PRIMARY KEY AUTOINCREMENT, at INTEGER NOT NULL, identity TEXT NOT "
          "NULL, counted_by TEXT NOT NULL, place TEXT NOT NULL, device TEXT NOT NULL, planned INTEGER NOT "
          "NULL, writes INTEGER NOT NULL, settled INTEGER NOT NULL, before TEXT NOT NULL, written TEXT NOT "
          "NULL)",
          "CREATE INDEX entry_identity ON entry (identity)", "PRAGMA application_id = 1129792837",
          "PRAGMA user_version = 1",
          "INSERT INTO entry VALUES (5, 1000, 'serial/FRABA/7', 'serial-number', '1.0', 'fraba-ocd-ib', 2, "
          "2, "
          "1, '[]', '[]')"})
        file.execute(QString::fromLatin1(statement));
    auto ledger = Ledger::open(file.place());
    ASSERT_TRUE(ledger) << ledger.error().reason.toStdString();
    EXPECT_EQ(ledger->writes(seven).writes, 2);
    const auto records = ledger->records();
    ASSERT_EQ(records->size(), 1U);
    EXPECT_EQ(records->front().origin, QStringLiteral("5-1000"));
    EXPECT_EQ(records->front().entry.writer, LedgerWriter());
    EXPECT_TRUE(ledger->count(5, 1));
    EXPECT_EQ(file.names(), QStringList{QStringLiteral("journal.sqlite")}) << "while it is open";
    EXPECT_EQ(Ledger::open(file.place())->writes(seven).writes, 3);
}

} // namespace
} // namespace codewheel
