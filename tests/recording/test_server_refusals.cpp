// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with the server of a recording is said in a sentence, and never with a password in it.
#include "tests/recording/server_fixture.h"

namespace codewheel {
namespace {

using namespace test;
using testing::HasSubstr;
using testing::Not;

std::string sentence(const Refusal &refusal)
{
    const std::string text = refusalText(refusal).toStdString();
    EXPECT_THAT(text, Not(HasSubstr("secret")));
    EXPECT_THAT(text, Not(HasSubstr("\n")));
    return text;
}

TEST_F(ServerRecordings, AWrongPasswordIsRefused)
{
    server->setPassword(QStringLiteral("another-secret"));
    EXPECT_THAT(sentence(refused(address)), HasSubstr("user or password is wrong"));
    const auto read = RecordingReader::open(address);
    ASSERT_FALSE(read);
    EXPECT_THAT(sentence(read.error()), HasSubstr("user or password is wrong"));
    qputenv("PGPASSFILE", "/nowhere");
    EXPECT_THAT(sentence(refused(address)), HasSubstr("PGPASSWORD"));
    qputenv("PGPASSWORD", PostgresServer::password);
    EXPECT_FALSE(begin(settings())->end().problem) << "it may be in the environment as well";
}

TEST_F(ServerRecordings, WhatTheServerDoesNotHaveIsRefused)
{
    EXPECT_THAT(sentence(refused(server->addressOf(QStringLiteral("nothing")))),
                HasSubstr("no database nothing"));
    const QString guest = QStringLiteral("guest_of_") + database();
    server->execute(database(), QStringLiteral("CREATE ROLE %1 LOGIN PASSWORD '%2'")
                                    .arg(guest, QString::fromLatin1(PostgresServer::password)));
    EXPECT_THAT(sentence(refused(server->addressOf(database(), guest))), HasSubstr("GRANT CREATE"));
    const QString ascii = server->newDatabase(QStringLiteral("ENCODING 'SQL_ASCII' TEMPLATE template0"));
    EXPECT_THAT(sentence(refused(ascii)), HasSubstr("SQL_ASCII"));
    const QString standby = server->newDatabase();
    server->execute(database(), QStringLiteral("ALTER DATABASE %1 SET default_transaction_read_only TO on")
                                    .arg(standby.section(u'/', -1)));
    EXPECT_THAT(sentence(refused(standby)), HasSubstr("only lets it be read"));
}

TEST_F(ServerRecordings, AServerThatCannotBeReachedIsWaitedFor)
{
    for (const auto &[to, said] :
         {std::pair("postgresql://127.0.0.1:1/all", "no server answers"),
          std::pair("postgresql://%2Fnowhere/all", "no server answers"),
          std::pair("postgresql://nowhere.invalid/all", "no computer of the name")}) {
        const auto target = begin(settings(QString::fromLatin1(to)));
        target->add(positions(noon, 10, [](std::size_t index) { return index; }));
        target->flush();
        const RecordingStatus status = target->status();
        ASSERT_TRUE(status.problem);
        EXPECT_EQ(status.problem->id, RefusalId::serverAway);
        EXPECT_THAT(sentence(*status.problem), HasSubstr(said));
        EXPECT_FALSE(status.server->isConnected);
        EXPECT_THAT(sentence(target->end().problem.value()), HasSubstr(said));
    }
}

TEST_F(ServerRecordings, ThePasswordIsInNoFile)
{
    server->stop();
    const auto target = begin(settings());
    target->add(positions(noon, 10, [](std::size_t index) { return index; }));
    EXPECT_THAT(sentence(target->end().problem.value()), HasSubstr("no server answers"));
    server->start();
    ASSERT_EQ(waitingFiles().size(), 1);
    QFile waiting(waitingFiles().front());
    ASSERT_TRUE(waiting.open(QIODevice::ReadOnly));
    EXPECT_FALSE(waiting.readAll().contains(PostgresServer::password));
}

} // namespace
} // namespace codewheel
