// SPDX-License-Identifier: GPL-3.0-or-later
// Killed at any time, the program leaves both databases intact, with everything that was promised to be kept.
#include "journal/ledger.h"
#include "tests/journal/journal_file.h"
#include "tests/support/places.h"
#include "tests/support/times.h"
#include "vocabulary/refusal_text.h"

#include <QProcess>
#include <QRandomGenerator>

namespace codewheel {
namespace {

using test::JournalFile;

const int kills = test::times(100);
constexpr int linesAtMost = 60;   // until it is killed
constexpr int generous = 120'000; // ms

struct Promised
{
    int message = -1; // 0 to this
    int jobs = 0;
    int writes = 0;
};

// Runs the child until it has printed this many lines, then kills it.
Promised runAndKill(const JournalFile &messages, const JournalFile &ledger, int run, int lines)
{
    QProcess child;
    child.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    child.start(QStringLiteral(JOURNAL_WRITER), {messages.path, ledger.path, QString::number(run)});
    EXPECT_TRUE(child.waitForStarted(generous));
    Promised promised;
    const auto read = [&] {
        const QByteArray line = child.readLine().trimmed();
        if (line.startsWith("message "))
            promised.message = line.mid(8).toInt();
        promised.jobs += line == "job" ? 1 : 0;
        promised.writes += line == "write" ? 1 : 0;
    };
    for (int line = 0; line < lines; ++line) {
        while (!child.canReadLine())
            if (!child.waitForReadyRead(generous)) {
                ADD_FAILURE() << "the child says nothing";
                return promised;
            }
        read();
    }
    child.kill(); // SIGKILL
    EXPECT_TRUE(child.waitForFinished(generous));
    while (child.canReadLine()) // said before it was killed
        read();
    return promised;
}

QString integrity(const JournalFile &file)
{
    QString result;
    {
        auto connection = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), file.path);
        connection.setDatabaseName(file.path);
        EXPECT_TRUE(connection.open());
        QSqlQuery query(connection);
        if (query.exec(QStringLiteral("PRAGMA integrity_check")) && query.next())
            result = query.value(0).toString();
    }
    QSqlDatabase::removeDatabase(file.path);
    return result;
}

// The messages of a run start at 0 and have no gap.
int lastMessageOf(const JournalFile &file, int run)
{
    const auto table = MessageTable::open(file.place());
    EXPECT_TRUE(table);
    const auto span = table->span();
    const auto all = table->read(span->first, span->last);
    int next = 0;
    for (const StoredMessage &message : all.value_or(std::vector<StoredMessage>())) {
        const QStringList parts = messageText(message).split(u' ');
        if (parts.front().toInt() != run)
            continue;
        EXPECT_EQ(parts.back().toInt(), next);
        ++next;
    }
    return next - 1;
}

TEST(Killed, LeavesBothDatabasesWholeWithWhatWasPromised)
{
    const JournalFile messages;
    const JournalFile ledger;
    const EncoderIdentity fraba{
        .by = CountedBy::place, .vendor = {}, .serialNumber = {}, .project = {}, .place = "1.0"_ring};
    int writes = 0;
    for (int run = 0; run < kills; ++run) {
        const int lines = static_cast<int>(QRandomGenerator::global()->bounded(linesAtMost));
        const Promised promised = runAndKill(messages, ledger, run, lines);
        writes += promised.writes;
        ASSERT_TRUE(integrity(messages) == QStringLiteral("ok") || lines == 0);
        ASSERT_TRUE(integrity(ledger) == QStringLiteral("ok") || lines == 0);
        ASSERT_GE(lastMessageOf(messages, run), promised.message);
        const auto account = Ledger::open(ledger.place());
        ASSERT_TRUE(account);
        const EepromCount count = account->writes(fraba);
        ASSERT_GE(count.writes, writes);
        // The job under way when it was killed is counted as possible writes.
        if (promised.jobs > 0) {
            ASSERT_GT(count.atMost(), 0);
        }
        writes = count.writes; // it may have counted more than it printed
    }
    EXPECT_GT(writes, kills / 2);
    EXPECT_EQ(messages.names().filter(QStringLiteral("damaged")), QStringList());
    EXPECT_EQ(ledger.names().filter(QStringLiteral("damaged")), QStringList());
}

} // namespace
} // namespace codewheel
