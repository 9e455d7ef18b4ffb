// SPDX-License-Identifier: GPL-3.0-or-later
// Several programs on the same files: none loses what another one keeps.
#include "journal/ledger.h"
#include "tests/journal/journal_file.h"

#include <QProcess>

namespace codewheel {
namespace {

using test::JournalFile;

constexpr int longest = 120'000; // ms

class Peer
{
public:
    Peer(const char *what, const QString &file, int times)
    {
        m_process.start(QStringLiteral(JOURNAL_PEER),
                        {QString::fromLatin1(what), file, QString::number(times)});
    }
    int exitCode()
    {
        EXPECT_TRUE(m_process.waitForFinished(longest));
        EXPECT_EQ(m_process.readAllStandardError().toStdString(), "");
        return m_process.exitStatus() == QProcess::NormalExit ? m_process.exitCode() : -1;
    }
    // Lets it keep a message; returns its number.
    int next()
    {
        m_process.write("\n");
        while (!m_process.canReadLine())
            if (!m_process.waitForReadyRead(longest))
                return -1;
        return m_process.readLine().trimmed().toInt();
    }
    void kill()
    {
        m_process.kill();
        m_process.waitForFinished(longest);
    }

private:
    QProcess m_process;
};

TEST(ParallelPrograms, LoseNoWrite)
{
    constexpr std::size_t programs = 32;
    constexpr int times = 10;
    const JournalFile file;
    std::vector<std::unique_ptr<Peer>> peers;
    for (std::size_t i = 0; i < programs; ++i)
        peers.push_back(std::make_unique<Peer>("count", file.path, times));
    for (const auto &peer : peers)
        EXPECT_EQ(peer->exitCode(), 0);
    const auto accounts = Ledger::open(file.place())->accounts();
    ASSERT_EQ(accounts.size(), 1U);
    EXPECT_EQ(accounts[0].count.writes, int{programs} * times);
    EXPECT_EQ(accounts[0].count.perhaps, 0);
    EXPECT_EQ(file.names(), QStringList{QStringLiteral("journal.sqlite")});
}

TEST(ParallelPrograms, ThatLookTakeNoMessageFromTheOneThatKeepsThem)
{
    constexpr int times = 24;
    const JournalFile file;
    Peer keeper("keep", file.path, times);
    int kept = -1;
    while (kept < times - 1) {
        const int next = keeper.next();
        ASSERT_EQ(next, kept + 1);
        kept = next;
        if (kept % 4 == 0) {
            EXPECT_EQ(Peer("look", file.path, 1).exitCode(), 0);
        }
    }
    keeper.kill();
    const auto table = MessageTable::open(file.place());
    ASSERT_TRUE(table);
    EXPECT_EQ(table->read(0, 1'000)->size(), std::size_t{times});
}

} // namespace
} // namespace codewheel
