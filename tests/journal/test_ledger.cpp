// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/ledger.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "tests/journal/journal_file.h"
#include "tests/support/places.h"

#include <QSysInfo>

namespace codewheel {
namespace {

using test::JournalFile;

const QDateTime noonOfWrite(QDate(2026, 3, 1), QTime(12, 0), Qt::UTC);

EncoderIdentity serial(const char *number, const char *vendor = "FRABA")
{
    return {.by = CountedBy::serialNumber,
            .vendor = QString::fromLatin1(vendor),
            .serialNumber = QString::fromLatin1(number),
            .project = {},
            .place = "1.0"_ring};
}
EncoderIdentity atPlace(Place place, const QString &project = {})
{
    return {.by = CountedBy::place, .vendor = {}, .serialNumber = {}, .project = project, .place = place};
}

Ledger::Entry entryOf(const EncoderIdentity &identity, int planned, const QDateTime &at = noonOfWrite)
{
    return {.at = at,
            .identity = identity.key(),
            .by = identity.by,
            .place = identity.place,
            .device = QStringLiteral("fraba-ocd-ib"),
            .planned = planned};
}

class LedgerTest : public testing::Test
{
protected:
    Ledger ledger = std::move(*Ledger::open(DatabasePlace::memory()));
};

TEST_F(LedgerTest, CountsWhatWasSeen)
{
    const qint64 job = *ledger.begin(entryOf(serial("4711"), 4));
    EXPECT_TRUE(ledger.count(job, 1) && ledger.count(job, 2));
    EXPECT_TRUE(ledger.settle(job, {{Parameter::steps, 255}}));
    const EepromCount count = ledger.writes(serial("4711"));
    EXPECT_EQ(count.writes, 3);
    EXPECT_EQ(count.perhaps, 0);
    EXPECT_EQ(count.since, noonOfWrite);
    EXPECT_EQ(count.serialNumber, QStringLiteral("4711"));
    EXPECT_EQ(ledger.writes(serial("4712")),
              (EepromCount{.by = CountedBy::serialNumber, .serialNumber = QStringLiteral("4712")}));
}

TEST_F(LedgerTest, EachEntryHasTheNamesOfComputerAndUser)
{
    setLedgerUser(QStringLiteral("  Ada \n L. "));
    const qint64 hers = *ledger.begin(entryOf(serial("1"), 1));
    setLedgerUser({});
    const qint64 nobodys = *ledger.begin(entryOf(serial("1"), 1));
    EXPECT_EQ(ledger.record(hers)->entry.writer.user, QStringLiteral("Ada L."));
    EXPECT_EQ(ledger.record(hers)->entry.writer.computer, QSysInfo::machineHostName());
    EXPECT_EQ(ledger.record(nobodys)->entry.writer,
              (LedgerWriter{.computer = QSysInfo::machineHostName(), .user = {}}));
}

TEST_F(LedgerTest, ACopyOfAPlaceKeepsTheNames)
{
    const QString from = QStringLiteral("/a.codewheel");
    const QString to = QStringLiteral("/b.codewheel");
    setLedgerUser(QStringLiteral("Ada"));
    EXPECT_TRUE(ledger.count(*ledger.begin(entryOf(atPlace("1.0"_ring, from), 1)), 1));
    setLedgerUser(QStringLiteral("Ben"));
    EXPECT_TRUE(ledger.copyPlaces(from, to, "1.0"_ring.bus, {}));
    setLedgerUser({});
    const auto records = *ledger.records();
    ASSERT_EQ(records.size(), 2U);
    EXPECT_EQ(records[1].entry.writer.user, QStringLiteral("Ada"));
    EXPECT_NE(records[0].origin, records[1].origin);
}

TEST_F(LedgerTest, WhatEndedWithoutAWriteIsNoLongerListed)
{
    Ledger::Entry entry = entryOf(serial("1"), 2);
    entry.before = {{Parameter::steps, 4096, Evidence::read, noonOfWrite}};
    const qint64 job = *ledger.begin(entry);
    EXPECT_EQ(ledger.valuesBefore(serial("1")).size(), 1U);
    EXPECT_TRUE(ledger.settle(job, {}));
    EXPECT_TRUE(ledger.accounts().empty());
    EXPECT_TRUE(ledger.valuesBefore(serial("1")).empty());
    EXPECT_FALSE(ledger.since(serial("1")).isValid());
}

TEST_F(LedgerTest, WhatNeverEndedMayHaveBeenWritten)
{
    const qint64 job = *ledger.begin(entryOf(serial("1"), 4));
    EXPECT_TRUE(ledger.count(job, 1));
    EXPECT_EQ(ledger.writes(serial("1")).writes, 1);
    EXPECT_EQ(ledger.writes(serial("1")).perhaps, 3);
    EXPECT_EQ(ledger.writes(serial("1"), {job}).perhaps, 0); // it is still running
}

TEST_F(LedgerTest, WhatAJobLeftInDoubtStaysPerhaps)
{
    const qint64 job = *ledger.begin(entryOf(serial("1"), 4));
    EXPECT_TRUE(ledger.count(job, 1));
    EXPECT_TRUE(ledger.settle(job, {}, {}, 2));
    EXPECT_EQ(ledger.writes(serial("1")).writes, 1);
    EXPECT_EQ(ledger.writes(serial("1")).perhaps, 2);
    EXPECT_TRUE(ledger.count(job, 1) && ledger.settle(job, {{Parameter::steps, 255}}));
    EXPECT_EQ(ledger.writes(serial("1")).writes, 2);
    EXPECT_EQ(ledger.writes(serial("1")).perhaps, 0);
    EXPECT_TRUE(ledger.settle(*ledger.begin(entryOf(serial("2"), 4)), {}, {}, 1));
    EXPECT_EQ(ledger.writes(serial("2")).perhaps, 1) << "it is not dropped";
}

TEST_F(LedgerTest, ForgetsAJobThatWroteNothing)
{
    EXPECT_TRUE(ledger.settle(*ledger.begin(entryOf(serial("1"), 4)), {}));
    EXPECT_TRUE(ledger.accounts().empty());
}

TEST_F(LedgerTest, TellsEncodersApart)
{
    for (const EncoderIdentity &identity :
         {serial("1"), serial("1", "Baumer"), atPlace("1.0"_ring), atPlace("2.0"_ring),
          atPlace("1.0"_ring, QStringLiteral("/a.codewheel"))})
        EXPECT_TRUE(ledger.count(*ledger.begin(entryOf(identity, 1)), 1));
    EXPECT_EQ(ledger.writes(serial("1")).writes, 1);
    EXPECT_EQ(ledger.writes(atPlace("1.0"_ring)).writes, 1);
    EXPECT_EQ(ledger.writes(atPlace("1.0"_ring, QStringLiteral("/a.codewheel"))).writes, 1);
    EXPECT_EQ(ledger.accounts().size(), 5U);
}

// The same address on two lines of a project, and the same number on two rings.
TEST_F(LedgerTest, TellsTheBusesOfAProjectApart)
{
    const QString from = QStringLiteral("/a.codewheel");
    const QString to = QStringLiteral("/copy.codewheel");
    const std::vector<Place> places{
        "1.0"_ring, placeOnLine({5}), {BusId{3}, NodeId("1.0")}, {BusId{4}, NodeId("esc:05")}};
    int writes = 0;
    for (const Place place : places)
        EXPECT_TRUE(ledger.count(*ledger.begin(entryOf(atPlace(place, from), 1)), ++writes));
    writes = 0;
    for (const Place place : places) {
        EXPECT_EQ(ledger.writes(atPlace(place, from)).writes, ++writes) << place.key().toStdString();
        EXPECT_TRUE(ledger.copyPlaces(from, to, place.bus, {}));
        for (const Place other : places)
            EXPECT_EQ(ledger.writes(atPlace(other, to)).writes > 0, other <= place)
                << other.key().toStdString() << " with " << place.key().toStdString();
    }
    std::vector<Place> told;
    for (const Ledger::Account &account : ledger.accounts())
        told.push_back(account.place);
    for (const Place place : places)
        EXPECT_NE(std::ranges::find(told, place), told.end()) << place.key().toStdString();
}

TEST_F(LedgerTest, ANumberThatIsTypedIsTheSameAsOneThatIsRead)
{
    EncoderIdentity typed = serial("4711");
    typed.by = CountedBy::labelSerialNumber;
    EXPECT_TRUE(ledger.count(*ledger.begin(entryOf(typed, 1)), 1));
    EXPECT_EQ(ledger.writes(serial("4711")).writes, 1);
    EXPECT_EQ(ledger.writes(typed).by, CountedBy::labelSerialNumber);
}

TEST_F(LedgerTest, AttributesWhatWasNotedBefore)
{
    const qint64 first = *ledger.begin(entryOf(atPlace("1.0"_ring), 1));
    const qint64 second = *ledger.begin(entryOf(atPlace("1.0"_ring), 1));
    EXPECT_TRUE(ledger.count(first, 1) && ledger.count(second, 1));
    EXPECT_TRUE(ledger.attribute({second}, serial("9")));
    EXPECT_EQ(ledger.writes(atPlace("1.0"_ring)).writes, 1);
    EXPECT_EQ(ledger.writes(serial("9")).writes, 1);
}

TEST_F(LedgerTest, TellsValuesFromBeforeTheNewestFirst)
{
    Ledger::Entry entry = entryOf(serial("1"), 2);
    entry.before = {{Parameter::steps, 4096, Evidence::read, noonOfWrite.addSecs(-60)},
                    {Parameter::preset, -1, Evidence::echoed, noonOfWrite.addSecs(-30)}};
    const qint64 first = *ledger.begin(entry);
    EXPECT_TRUE(ledger.count(first, 1));
    EXPECT_TRUE(ledger.settle(first, {{Parameter::steps, 255}}));
    EXPECT_TRUE(ledger.begin(entryOf(serial("1"), 1))); // nothing known
    entry.at = noonOfWrite.addSecs(60);
    EXPECT_TRUE(ledger.begin(entry));
    const auto found = ledger.valuesBefore(serial("1"));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].at, noonOfWrite.addSecs(60));
    EXPECT_FALSE(found[0].settled);
    EXPECT_EQ(found[1].before, entry.before);
    EXPECT_EQ(found[1].written, (ParameterValues{{Parameter::steps, 255}}));
}

TEST_F(LedgerTest, ListsAccountsWithWhereTheEncoderWasLast)
{
    Ledger::Entry entry = entryOf(serial("1"), 1, noonOfWrite.addDays(1));
    entry.writes = 5;
    entry.settled = true;
    EXPECT_TRUE(ledger.begin(entry));
    entry.place = "3.0"_ring;
    entry.at = noonOfWrite;
    EXPECT_TRUE(ledger.begin(entry));
    const auto accounts = ledger.accounts();
    ASSERT_EQ(accounts.size(), 1U);
    EXPECT_EQ(accounts[0].identity, QStringLiteral("serial/FRABA/1"));
    EXPECT_EQ(accounts[0].place, ("3.0"_ring));
    EXPECT_EQ(accounts[0].count.writes, 10);
    EXPECT_EQ(accounts[0].count.since, noonOfWrite);
    EXPECT_EQ(accounts[0].count.serialNumber, QStringLiteral("1"));
}

TEST(LedgerFile, KeepsWhatWasNoted)
{
    const JournalFile file;
    {
        auto ledger = Ledger::open(file.place());
        ASSERT_TRUE(ledger);
        EXPECT_TRUE(ledger->begin(entryOf(serial("1"), 3)));
    }
    EXPECT_EQ(Ledger::open(file.place())->writes(serial("1")).perhaps, 3);
}

TEST(LedgerFile, SaysWhatIsWrongWithAFile)
{
    const JournalFile messages;
    EXPECT_TRUE(MessageTable::open(messages.place()));
    EXPECT_EQ(Ledger::open(messages.place()).error().kind, DatabaseError::Kind::foreign);
    const JournalFile broken;
    broken.fill(JournalFile::header().leftJustified(5'000, 'x'));
    EXPECT_EQ(Ledger::open(broken.place()).error().kind, DatabaseError::Kind::broken);
    const JournalFile letter;
    letter.fill(QByteArray(5'000, 'x'));
    EXPECT_EQ(Ledger::open(letter.place()).error().kind, DatabaseError::Kind::foreign);
}

TEST(LedgerFile, CountsNothingBelowZeroWhateverAFileSays)
{
    const JournalFile file;
    EXPECT_TRUE(Ledger::open(file.place()));
    file.execute(QStringLiteral(
        "INSERT INTO entry VALUES (1, 'x', 'serial/FRABA/1', '?', '?', '?', -5, -7, 0, '{', '[[')"));
    const auto ledger = Ledger::open(file.place());
    ASSERT_TRUE(ledger);
    EXPECT_EQ(ledger->writes(serial("1")).writes, 0);
    EXPECT_GE(ledger->writes(serial("1")).perhaps, 0);
    EXPECT_EQ(ledger->valuesBefore(serial("1")).size(), 1U);
}

} // namespace
} // namespace codewheel
