// SPDX-License-Identifier: GPL-3.0-or-later
// `record --to` with a real server.
#include "tests/cli/cli_run.h"
#include "tests/recording/server_fixture.h"

#include <QJsonArray>
#include <QJsonObject>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::Not;
using namespace std::chrono_literals;

class CliRecordOnServer : public test::ServerRecordings
{
protected:
    void SetUp() override
    {
        ServerRecordings::SetUp();
        qputenv("XDG_DATA_HOME", file.folder().toLocal8Bit());
    }
    void TearDown() override { qunsetenv("XDG_DATA_HOME"); }
    CliRun record(const QString &line) const
    {
        return runLine(QStringLiteral("record --to %1 ").arg(address) + line);
    }
};

TEST_F(CliRecordOnServer, WhatIsRecordedIsThereAndIsExported)
{
    const CliRun run = record(QStringLiteral("2.0 --for 2 --json"));
    ASSERT_EQ(run.exit, 0) << run.err;
    const QString recording = run.json()[QLatin1String("file")].toString();
    EXPECT_TRUE(recording.startsWith(QLatin1String("postgresql://"))) << recording.toStdString();
    EXPECT_TRUE(run.json()[QLatin1String("bytes")].isNull());
    EXPECT_TRUE(run.json()[QLatin1String("ended")].toBool());
    EXPECT_THAT(run.out + run.err, Not(HasSubstr(test::PostgresServer::password)));
    EXPECT_TRUE(waitingFiles().isEmpty());
    const QString table = file.folder() + QStringLiteral("/table.csv");
    const CliRun exported = runLine(QStringLiteral("export %1 -o %2 --tracks 2.0/in").arg(recording, table));
    ASSERT_EQ(exported.exit, 0) << exported.err;
    QFile csv(table);
    ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
    EXPECT_GT(csv.readAll().count('\n'), 1'000);
}

TEST_F(CliRecordOnServer, AnAwayServerIsSaidAndTheRestFollows)
{
    server->stop();
    const CliRun away = record(QStringLiteral("2.0 --for 1"));
    EXPECT_EQ(away.exit, 1);
    EXPECT_THAT(away.err, HasSubstr("follows with the next recording"));
    EXPECT_EQ(away.err.find("follows with the next"), away.err.rfind("follows with the next")) << "once";
    EXPECT_EQ(waitingFiles().size(), 1);
    server->start();
    const CliRun next = record(QStringLiteral("2.0 --for 1"));
    EXPECT_EQ(next.exit, 0) << next.err;
}

TEST_F(CliRecordOnServer, BadInputIsSaid)
{
    EXPECT_THAT(runLine(QStringLiteral("record --to %1 -o x.cwrec").arg(address)).err,
                HasSubstr("Give -o or --to, not both"));
    const CliRun secret = runLine(QStringLiteral("record --to postgresql://me:secret@localhost/db --for 1"));
    EXPECT_EQ(secret.exit, 2);
    EXPECT_THAT(secret.err, HasSubstr("~/.pgpass"));
    EXPECT_THAT(secret.err, Not(HasSubstr("secret@")));
    EXPECT_THAT(record(QStringLiteral("2.0 --for 1 --max-size 5")).err, HasSubstr("not to a size"));
    EXPECT_THAT(runLine(QStringLiteral("record --to http://host/db --for 1")).err,
                HasSubstr("The address of the server is wrong"));
}

} // namespace
} // namespace codewheel
