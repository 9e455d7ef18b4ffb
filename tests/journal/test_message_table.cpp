// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/journal/journal_file.h"
#include "tests/support/places.h"

namespace codewheel {
namespace {

using test::JournalFile;
using test::messageAt;

DatabaseError errorOf(const JournalFile &file)
{
    const auto table = MessageTable::open(file.place());
    EXPECT_FALSE(table);
    return table ? DatabaseError() : table.error();
}

TEST(MessageTable, GivesBackWhatWasAppended)
{
    const JournalFile file;
    auto table = MessageTable::open(file.place());
    ASSERT_TRUE(table);
    EXPECT_EQ(table->span(), MessageTable::Span());
    std::vector<StoredMessage> messages{messageAt(1, "one"),
                                        messageAt(2, "two", "6.1"_ring, Severity::fault)};
    ASSERT_TRUE(table->append(messages));
    const auto again = MessageTable::open(file.place());
    ASSERT_TRUE(again);
    const auto read = again->read(1, 2);
    messages[0].id = 1;
    messages[1].id = 2;
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, messages);
    EXPECT_EQ(again->span(), (MessageTable::Span{1, 2}));
    EXPECT_EQ(again->places(), (std::vector<Place>{"6.1"_ring}));
}

TEST(MessageTable, ReadsSingleMessagesInTheOrderWanted)
{
    auto table = MessageTable::open(DatabasePlace::memory());
    ASSERT_TRUE(table && table->append({messageAt(1, "a"), messageAt(2, "b"), messageAt(3, "c")}));
    const auto read = table->read(std::vector<qint64>{3, 17, 1});
    ASSERT_TRUE(read);
    EXPECT_EQ(read->at(0).at, 3);
    EXPECT_EQ(read->at(1).id, 0);
    EXPECT_EQ(read->at(2).at, 1);
}

TEST(MessageTable, FiltersBySeverityPlaceAndTime)
{
    auto table = MessageTable::open(DatabasePlace::memory());
    ASSERT_TRUE(table && table->append({messageAt(10, "a"), messageAt(20, "b", "1.0"_ring),
                                        messageAt(30, "c", "2.0"_ring, Severity::fault),
                                        messageAt(40, "d", {}, Severity::attention)}));
    using Ids = std::vector<qint64>;
    const auto ids = [&](const MessageFilter &filter) { return table->ids(1, 4, filter).value_or(Ids()); };
    EXPECT_EQ(ids({}), (Ids{1, 2, 3, 4}));
    EXPECT_EQ(ids({.least = Severity::attention}), (Ids{3, 4}));
    EXPECT_EQ(ids({.least = Severity::fault}), (Ids{3}));
    EXPECT_EQ(ids({.place = {.all = false}}), (Ids{1, 4}));
    EXPECT_EQ(ids({.place = {.all = false, .at = "1.0"_ring}}), (Ids{2}));
    EXPECT_EQ(ids({.from = 20, .until = 40}), (Ids{2, 3}));
}

TEST(MessageTable, FindsAllOfABus)
{
    const Place first{firstBus, {}};
    const Place third{BusId{3}, {}};
    const Place onThird{BusId{3}, NodeId("1.0")};
    auto table = MessageTable::open(DatabasePlace::memory());
    ASSERT_TRUE(table &&
                table->append({messageAt(1, "a", first), messageAt(2, "b", "1.0"_ring),
                               messageAt(3, "c", third), messageAt(4, "d", onThird), messageAt(5, "e")}));
    using Ids = std::vector<qint64>;
    const auto ids = [&](std::optional<Place> place) {
        return table->ids(1, 9, {.place = {.all = false, .at = place}}).value_or(Ids());
    };
    EXPECT_EQ(ids(first), (Ids{1, 2}));
    EXPECT_EQ(ids(third), (Ids{3, 4}));
    EXPECT_EQ(ids(Place{BusId{4}, {}}), Ids());
    EXPECT_EQ(ids({}), (Ids{1, 3, 5}));
    EXPECT_EQ(table->read({3}).value().front().place, third);
    EXPECT_EQ(table->places(), (std::vector<Place>{first, "1.0"_ring, third, onThird}));
}

TEST(MessageTable, IsSeenByOthers)
{
    const JournalFile file;
    auto writer = MessageTable::open(file.place());
    const auto reader = MessageTable::open(file.place());
    ASSERT_TRUE(writer && reader);
    const qint64 before = reader->changes();
    ASSERT_TRUE(writer->append({messageAt(1, "one")}));
    EXPECT_NE(reader->changes(), before);
    EXPECT_EQ(reader->span()->last, 1);
}

TEST(MessageTable, DropsTheOldestAndGivesTheRoomBack)
{
    const JournalFile file;
    auto table = MessageTable::open(file.place());
    ASSERT_TRUE(table);
    ASSERT_TRUE(table->append(std::vector<StoredMessage>(2'000, messageAt(1, "something that takes room"))));
    const qint64 before = table->size();
    ASSERT_TRUE(table->dropUpTo(1'500));
    EXPECT_EQ(table->span(), (MessageTable::Span{1'501, 2'000}));
    EXPECT_LT(table->size(), before / 2);
    ASSERT_TRUE(table->dropUpTo(2'000));
    ASSERT_TRUE(table->append({messageAt(1, "next")}));
    EXPECT_EQ(table->span()->first, 2'001); // ids are never reused
}

TEST(MessageTable, RefusesTheFileOfANewerVersion)
{
    const JournalFile file;
    ASSERT_TRUE(MessageTable::open(file.place()));
    file.execute(QStringLiteral("PRAGMA user_version = 2"));
    EXPECT_EQ(errorOf(file).kind, DatabaseError::Kind::newer);
    EXPECT_TRUE(errorOf(file).reason.contains(QStringLiteral("newer Codewheel (version 2")))
        << errorOf(file).reason.toStdString();
}

TEST(MessageTable, LeavesADatabaseOfAnotherProgramAlone)
{
    const JournalFile file;
    file.execute(QStringLiteral("CREATE TABLE song (title TEXT)"));
    const auto bytes = [&] {
        QFile read(file.path);
        EXPECT_TRUE(read.open(QIODevice::ReadOnly));
        return read.readAll();
    };
    const QByteArray before = bytes();
    EXPECT_EQ(errorOf(file).kind, DatabaseError::Kind::foreign);
    EXPECT_EQ(bytes(), before);
}

TEST(MessageTable, TakesNoFileWithTriggersOrOtherColumns)
{
    for (const char *sql :
         {"CREATE TRIGGER t AFTER INSERT ON message BEGIN DELETE FROM message; END",
          "ALTER TABLE message ADD COLUMN more TEXT", "DROP TABLE place", "CREATE VIEW v AS SELECT 1"}) {
        const JournalFile file;
        ASSERT_TRUE(MessageTable::open(file.place()));
        file.execute(QString::fromLatin1(sql));
        EXPECT_EQ(errorOf(file).kind, DatabaseError::Kind::broken) << sql;
    }
}

TEST(MessageTable, SaysThatAFileIsDamaged)
{
    for (const QByteArray &bytes : {QByteArray("SQLite format 3\0 and no more", 28),
                                    JournalFile::header() + QByteArray(100'000, 'x')}) {
        const JournalFile file;
        file.fill(bytes);
        EXPECT_EQ(errorOf(file).kind, DatabaseError::Kind::broken) << bytes.size();
        EXPECT_FALSE(errorOf(file).reason.isEmpty());
    }
}

TEST(MessageTable, LeavesAFileThatIsNoDatabaseAlone)
{
    for (const QByteArray &bytes : {QByteArray("{\"format\": \"codewheel-project\"}"), QByteArray("x"),
                                    QByteArray(100'000, 'x'), QByteArray(4096, '\0')}) {
        const JournalFile file;
        file.fill(bytes);
        EXPECT_EQ(errorOf(file).kind, DatabaseError::Kind::foreign) << bytes.size();
        EXPECT_EQ(errorOf(file).reason, QStringLiteral("it is not a database, and was left as it was."));
        EXPECT_EQ(QFileInfo(file.path).size(), bytes.size());
    }
}

TEST(MessageTable, TakesAnEmptyFileForANewOne)
{
    const JournalFile file;
    file.fill({});
    EXPECT_TRUE(MessageTable::open(file.place()));
}

TEST(MessageTable, SaysThatAGigabyteOfNothingIsDamaged)
{
    const JournalFile file;
    file.fill(JournalFile::header());
    ASSERT_TRUE(QFile::resize(file.path, 1'000'000'000));
    EXPECT_EQ(errorOf(file).kind, DatabaseError::Kind::broken);
}

// Truncated at any length, a file is accepted or reported as damaged, and reading ends.
TEST(MessageTable, SurvivesATruncatedFile)
{
    const JournalFile whole;
    {
        auto table = MessageTable::open(whole.place());
        ASSERT_TRUE(table && table->append(std::vector<StoredMessage>(500, messageAt(1, "something"))));
    }
    QFile file(whole.path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    for (qsizetype length = 0; length < bytes.size(); length += 1'021) {
        const JournalFile cut;
        cut.fill(bytes.first(length));
        const auto table = MessageTable::open(cut.place());
        if (!table)
            continue;
        const auto read = table->read(1, 500);
        EXPECT_TRUE(!read || read->size() <= 500U) << length;
    }
}

// Bytes 36 to 39 of the header: the number of free pages (SQLite's file format, 1.3).
TEST(MessageTable, AListOfFreePagesThatCannotBeIsDamage)
{
    for (const QByteArray &count : {QByteArray("\x7f\xff\xff\xff", 4), QByteArray("\0\0\0\3", 4)}) {
        const JournalFile file;
        ASSERT_TRUE(MessageTable::open(file.place())->append({messageAt(1, "one"), messageAt(2, "two")}));
        QFile raw(file.path);
        ASSERT_TRUE(raw.open(QIODevice::ReadWrite) && raw.seek(36) && raw.write(count) == 4);
        raw.close();
        auto table = MessageTable::open(file.place());
        ASSERT_TRUE(table);
        const auto dropped = table->dropUpTo(1);
        ASSERT_FALSE(dropped);
        EXPECT_EQ(dropped.error().kind, DatabaseError::Kind::broken);
    }
}

TEST(MessageTable, ShowsWhateverValuesAFileHolds)
{
    const JournalFile file;
    ASSERT_TRUE(MessageTable::open(file.place()));
    file.execute(
        QStringLiteral("INSERT INTO message VALUES (-5, 'noon', 77, 'everywhere', x'00FF', '[[[[', '{')"));
    const auto table = MessageTable::open(file.place());
    ASSERT_TRUE(table);
    const auto read = table->read(-10, 10);
    ASSERT_TRUE(read && read->size() == 1U);
    EXPECT_EQ(read->front().severity, Severity::fault);
    EXPECT_EQ(read->front().place, std::nullopt);
    EXPECT_FALSE(messageText(read->front()).isEmpty());
}

} // namespace
} // namespace codewheel
