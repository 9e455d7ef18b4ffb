// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/message_search.h"
#include "journal/message_store.h"
#include "tests/journal/journal_file.h"

#include <unistd.h>

namespace codewheel {
namespace {

using test::JournalFile;

const QDateTime noon(QDate(2026, 3, 1), QTime(12, 0), Qt::UTC);

Message training(const char *what, Severity severity = Severity::information)
{
    return {.severity = severity, .id = MessageId::training, .arguments = {QString::fromUtf8(what)}};
}

std::vector<StoredMessage> all(const MessageStore &store)
{
    const auto table = MessageTable::open(*store.place());
    EXPECT_TRUE(table);
    if (!table)
        return {};
    const auto span = table->span();
    return table->read(span->first, span->last).value_or(std::vector<StoredMessage>());
}

QStringList codes(const MessageStore &store)
{
    QStringList codes;
    for (const StoredMessage &message : all(store))
        codes << message.code;
    return codes;
}

TEST(MessageStore, KeepsMessagesOverTheEndOfTheProgram)
{
    const JournalFile file;
    {
        MessageStore store({.file = file.path});
        store.add(training("one"), noon);
        store.add(training("two", Severity::fault), noon.addMSecs(1));
    }
    MessageStore store({.file = file.path});
    store.add(training("three"), noon.addMSecs(2));
    store.flush();
    ASSERT_EQ(all(store).size(), 3U);
    EXPECT_EQ(messageText(all(store)[1]), QStringLiteral("two"));
    EXPECT_EQ(all(store)[2].at, noon.toMSecsSinceEpoch() + 2);
}

TEST(MessageStore, MakesTheFoldersOfItsFile)
{
    const JournalFile file;
    MessageStore store({.file = file.folder() + QStringLiteral("/a/b/messages.sqlite")});
    store.add(training("one"), noon);
    store.flush();
    EXPECT_TRUE(QFile::exists(file.folder() + QStringLiteral("/a/b/messages.sqlite")));
}

TEST(MessageStore, WorksInMemoryWithoutAFile)
{
    MessageStore store({});
    store.add(training("one"), noon);
    store.flush();
    EXPECT_TRUE(store.place()->inMemory);
    EXPECT_EQ(codes(store), QStringList(QStringLiteral("training")));
}

TEST(MessageStore, TwoOfThemShareAFile)
{
    const JournalFile file;
    MessageStore one({.file = file.path});
    MessageStore two({.file = file.path});
    for (int i = 0; i < 200; ++i) {
        one.add(training("one", Severity::fault), noon);
        two.add(training("two", Severity::fault), noon);
    }
    one.flush();
    two.flush();
    EXPECT_EQ(all(one).size(), 400U);
    EXPECT_FALSE(one.place()->inMemory || two.place()->inMemory);
}

TEST(MessageStore, PutsADamagedFileAsideAndBeginsAnother)
{
    const JournalFile file;
    file.fill(JournalFile::header().leftJustified(10'000, 'x'));
    MessageStore store({.file = file.path});
    store.add(training("one"), noon);
    store.flush();
    EXPECT_FALSE(store.place()->inMemory);
    EXPECT_EQ(codes(store), (QStringList{QStringLiteral("databasePutAside"), QStringLiteral("training")}));
    const QStringList aside = file.names().filter(QStringLiteral("journal.sqlite.damaged-"));
    ASSERT_EQ(aside.size(), 1);
    EXPECT_EQ(QFileInfo(file.folder() + u'/' + aside.front()).size(), 10'000);
    EXPECT_TRUE(messageText(all(store).front()).contains(aside.front()));
}

TEST(MessageStore, LeavesAFileThatIsNoDatabaseWhereItIs)
{
    const JournalFile file;
    file.fill("a letter");
    MessageStore store({.file = file.path});
    store.add(training("one"), noon);
    store.flush();
    EXPECT_TRUE(store.place()->inMemory);
    EXPECT_EQ(codes(store), (QStringList{QStringLiteral("notKept"), QStringLiteral("training")}));
    EXPECT_EQ(file.names(), QStringList{QStringLiteral("journal.sqlite")});
}

TEST(MessageStore, GoesOnInMemoryAndSaysSoOnceWhereTheFileCannotBeUsed)
{
    const JournalFile file;
    file.execute(QStringLiteral("CREATE TABLE song (title TEXT)"));
    MessageStore store({.file = file.path});
    store.add(training("one"), noon);
    store.add(training("two", Severity::fault), noon);
    store.flush();
    EXPECT_TRUE(store.place()->inMemory);
    EXPECT_EQ(codes(store), (QStringList{QStringLiteral("notKept"), QStringLiteral("training"),
                                         QStringLiteral("training")}));
    EXPECT_TRUE(messageText(all(store).front()).contains(QStringLiteral("another program")));
    EXPECT_EQ(file.names(), QStringList(QStringLiteral("journal.sqlite")));
}

TEST(MessageStore, GoesOnInMemoryWhereTheFolderCannotBeMade)
{
    const JournalFile file;
    file.fill("a file, no folder");
    MessageStore store({.file = file.path + QStringLiteral("/messages.sqlite")});
    store.add(training("one"), noon);
    store.flush();
    EXPECT_EQ(codes(store), (QStringList{QStringLiteral("notKept"), QStringLiteral("training")}));
}

TEST(MessageStore, NewestMessagesStayInSightWhenTheFileFails)
{
    const JournalFile file;
    MessageStore store({.file = file.path});
    store.add(training("before"), noon);
    store.flush();
    file.execute(QStringLiteral("CREATE TRIGGER full BEFORE INSERT ON message BEGIN "
                                "SELECT raise(ABORT, 'no room'); END"));
    store.add(training("after"), noon);
    store.flush();
    EXPECT_TRUE(store.place()->inMemory);
    EXPECT_EQ(codes(store), (QStringList{QStringLiteral("training"), QStringLiteral("notKept"),
                                         QStringLiteral("training")}));
    EXPECT_EQ(messageText(all(store).front()), QStringLiteral("before"));
}

TEST(MessageStore, TheNewestTenThousandGoOnWhenTheFileFails)
{
    constexpr int kept = 10'000;
    const JournalFile file;
    MessageStore store({.file = file.path});
    for (int i = 1; i <= kept + 100; ++i)
        store.add(training(std::to_string(i).c_str()), noon);
    store.flush();
    ASSERT_EQ(all(store).size(), kept + 100U);
    file.execute(QStringLiteral("CREATE TRIGGER full BEFORE INSERT ON message BEGIN "
                                "SELECT raise(ABORT, 'no room'); END"));
    store.add(training("after"), noon);
    store.flush();
    ASSERT_TRUE(store.place()->inMemory);
    const std::vector<StoredMessage> left = all(store);
    ASSERT_EQ(left.size(), kept + 2U);
    EXPECT_EQ(messageText(left.front()), QStringLiteral("101"));
    EXPECT_EQ(messageText(left[kept - 1]), QString::number(kept + 100));
    EXPECT_EQ(left[kept].code, QStringLiteral("notKept"));
    EXPECT_EQ(messageText(left.back()), QStringLiteral("after"));
}

TEST(MessageStore, PutsAFileAsideThatAReaderFoundDamaged)
{
    const JournalFile file;
    MessageStore store({.file = file.path});
    store.add(training("before"), noon);
    store.flush();
    store.reportBroken(*store.place(), {DatabaseError::Kind::broken, QStringLiteral("damaged.")});
    store.add(training("after"), noon);
    store.flush();
    EXPECT_EQ(codes(store), (QStringList{QStringLiteral("databasePutAside"), QStringLiteral("training")}));
}

TEST(MessageStore, DropsTheOldestBeyondItsSize)
{
    const JournalFile file;
    constexpr qint64 largest = 300'000;
    MessageStore store({.file = file.path, .largestSize = largest});
    for (int i = 0; i < 8'000; ++i)
        store.add(training("something that takes some room in the file"), noon);
    store.flush();
    for (int i = 0; i < 50; ++i) {
        store.add(training("more", Severity::fault), noon);
        store.flush();
    }
    EXPECT_LT(QFileInfo(file.path).size(), 2 * largest);
    EXPECT_EQ(messageText(all(store).back()).startsWith(QStringLiteral("more")) ||
                  all(store).back().code == QStringLiteral("oldMessagesDropped"),
              true);
    EXPECT_GT(codes(store).count(QStringLiteral("oldMessagesDropped")), 0);
    EXPECT_LT(all(store).size(), 6'000U);
    EXPECT_GT(all(store).size(), 1'000U);
}

TEST(MessageSearch, FindsTheNewestFirstAndComesToAnEnd)
{
    MessageStore store({});
    for (int i = 0; i < 30'000; ++i)
        store.add(training(i % 100 == 0 ? "a needle" : "hay"), noon);
    store.flush();
    MessageSearch search;
    search.start(*store.place(), {.text = QStringLiteral("NEEDLE")}, 1, 30'000);
    search.wait();
    const MessageSearch::Found found = search.take();
    EXPECT_TRUE(found.done);
    EXPECT_FALSE(search.isRunning());
    ASSERT_EQ(found.messages.size(), 300U);
    EXPECT_EQ(found.messages.front().id, 1);
    EXPECT_EQ(found.messages.back().id, 29'901);
    EXPECT_TRUE(std::ranges::is_sorted(found.messages, {}, &SightedMessage::id));
}

TEST(MessageSearch, ANewOneEndsTheOneBefore)
{
    MessageStore store({});
    for (int i = 0; i < 5'000; ++i)
        store.add(training("hay", i == 7 ? Severity::fault : Severity::information), noon);
    store.flush();
    MessageSearch search;
    for (int i = 0; i < 20; ++i)
        search.start(*store.place(), {.text = QStringLiteral("hay")}, 1, 5'000);
    search.start(*store.place(), {.least = Severity::fault}, 1, 5'000);
    search.wait();
    const auto found = search.take().messages;
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().id, 8);
}

} // namespace
} // namespace codewheel
