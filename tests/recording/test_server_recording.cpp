// SPDX-License-Identifier: GPL-3.0-or-later
// A recording on a PostgreSQL server has what a file has, whatever happens to the server meanwhile.
#include "tests/recording/server_fixture.h"

namespace codewheel {
namespace {

using namespace test;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

const TimeSpan ever{Instant(0), Instant::max()};

// As text, table by table.
QStringList contents(const SqlConnection &database)
{
    QStringList rows;
    for (const RecordingTable &table : allRecordingTables()) {
        QSqlQuery query = database.query(
            QStringLiteral("SELECT %1 FROM %2 ORDER BY %3")
                .arg(table.columns.join(u','), table.name, table.columns.first(table.keys).join(u',')));
        EXPECT_TRUE(database.run(query));
        while (query.next()) {
            QString row = table.name;
            for (int column = 0; column < static_cast<int>(table.columns.size()); ++column) {
                const QVariant value = query.value(column);
                row += u' ' + (value.isNull() ? QStringLiteral("NULL")
                               : value.typeId() == QMetaType::QByteArray
                                   ? QString::fromLatin1(value.toByteArray().toHex())
                                   : value.toString());
            }
            rows << row;
        }
    }
    return rows;
}

QStringList contentsOnServer(const QString &recording)
{
    ServerAddress address = ServerAddress::parse(recording).value();
    const auto database = PostgresDatabase::connectToRead(address);
    EXPECT_TRUE(database) << (database ? "" : database.error().reason.toStdString());
    return database ? contents(**database) : QStringList();
}

void addSomeOfAll(RecordingTarget &target)
{
    target.add(RecordedBus{firstBus, QStringLiteral("Ring 'Ä' \\ \"1\"")});
    target.add(RecordedBus{firstLine, QString()});
    target.add(RecordedDescription{"1.0"_ring, noon, "{\"steps\": 4096}"});
    target.add(positions(noon, 400, [](std::size_t index) { return index % 7 * 1'000'000'000; }));
    target.add(positions(
        noon, 400, [](std::size_t index) { return index % 3; }, "2.0"_ring));
    target.add(RecordedMessage{noon + 3ms,
                               {.place = "1.0"_ring,
                                .severity = Severity::fault,
                                .id = MessageId::deviceFault,
                                .arguments = {std::int64_t{3}, Word{0x86000000}}}});
    target.add(RecordedMessage{noon + 3ms, {.id = MessageId::busStarted}});
    target.add(RecordedTraffic{noon + 4ms,
                               firstLine,
                               {.place = Place{firstLine, NodeId("esc:05")},
                                .kind = TrafficKind::answer,
                                .bytes = QByteArray("\x00\x1b'\\\xff\r\n", 7),
                                .isTyped = true}});
    target.add(RecordedTraffic{noon + 5ms, firstBus, {.cycle = 7, .out = 0xFFFFFFFF, .in = 1}});
    target.add(RecordedNote{noon + 5ms, QStringLiteral("knocked, „twice“ 'here' \\")});
    target.add(RecordedNote{noon + 6ms, QStringLiteral("wrong")});
    target.add(RecordedLoss{noon + 7ms, firstBus, 12});
    target.add(RecordedClock{noon, noon + 1h});
    target.add(RecordedInterruption{"2.0"_ring, noon + 500ms});
}

TEST_F(ServerRecordings, HasWhatAFileHas)
{
    const auto onServer = begin(settings());
    const auto inFile = file.begin();
    for (RecordingTarget *target : std::initializer_list<RecordingTarget *>{onServer.get(), inFile.get()}) {
        addSomeOfAll(*target);
        target->flush();
        target->add(RecordedNote{noon + 6ms, {}});
        target->add(positions(noon + 1s, 50, [](std::size_t index) { return index; }));
    }
    const RecordingStatus status = onServer->end();
    (void)inFile->end();
    EXPECT_FALSE(status.problem);
    ASSERT_TRUE(status.server);
    EXPECT_EQ(status.server->waitingBytes, 0);
    const auto there = contentsOnServer(status.server->address);
    EXPECT_EQ(there, contents(*Database::openToRead(file.path, recordingSchema())));
    EXPECT_THAT(there, SizeIs(testing::Gt(15)));
    EXPECT_THAT(waitingFiles(), SizeIs(0)) << "all has been sent";
    EXPECT_EQ(QDir(file.folder()).entryList({QStringLiteral("*.lock")}, QDir::Files), QStringList());
}

TEST_F(ServerRecordings, TheStoreWorksOnAServerTheSameWay)
{
    const ServerAddress to = ServerAddress::parse(address)->withRecording(QStringLiteral("codewheel_store"));
    const auto database = PostgresDatabase::connect(to);
    ASSERT_TRUE(database && (*database)->useRecording(to.recording));
    ASSERT_TRUE(RecordingStore::create(file.path, {.program = {}, .zone = {}, .begun = noon}));
    RecordingStore onServer{*database};
    ASSERT_TRUE(onServer.begin({.program = {}, .zone = {}, .begun = noon}));
    auto inFile = RecordingStore::open(file.path);
    RecordingComposer composer;
    composer.add(RecordedBus{firstBus, {}});
    composer.add(RecordedDescription{"1.0"_ring, noon, "{}"});
    for (int minute = 0; minute < 200; ++minute)
        composer.add(positions(noon + 1min * minute, 300, [](std::size_t index) { return index; }));
    composer.add(RecordedNote{noon + 2s, QStringLiteral("a")});
    composer.add(RecordedNote{noon + 2s, {}});
    composer.add(RecordedMessage{noon + 3s, {.id = MessageId::busStarted}});
    composer.add(RecordedTraffic{noon + 3s, firstBus, {}});
    composer.add(RecordedLoss{noon + 3s, firstBus, 1});
    composer.add(RecordedClock{noon, noon});
    for (RecordingStore *store : {&onServer, &*inFile}) {
        ASSERT_TRUE(store->write(composer.gathered()));
        ASSERT_TRUE(store->write(composer.gathered())) << "it may be written twice";
        ASSERT_TRUE(store->forgetBefore(noon + 100min));
        ASSERT_TRUE(store->end(noon + 1h));
    }
    EXPECT_EQ(contents(**database), contents(*Database::openToRead(file.path, recordingSchema())));
}

TEST_F(ServerRecordings, CanBeReadAsAFileCan)
{
    const auto target = begin(settings());
    target->add(positions(noon, 5'000, [](std::size_t index) { return index * 3; }));
    target->flush();
    const RecordingReader recording = reader(target->status().server->address);
    EXPECT_FALSE(recording.head()->hasEnded);
    EXPECT_EQ(recording.head()->until, noon + 4'999ms);
    EXPECT_EQ(*Database::openToRead(waitingFiles().front(), recordingSchema())
                   ->number(QStringLiteral("SELECT count(*) FROM samples")),
              0)
        << "only what waits is in the file";
    RecordedChannel channel = RecordingFile::channel(recording, Channel::position);
    const auto samples = samplesOf(channel);
    ASSERT_EQ(samples.size(), 5'000U);
    EXPECT_EQ(samples.back(), (Sample{noon + 4'999ms, 3 * 4'999}));
    EXPECT_EQ(channel.at(noon + 1s).value(), (Sample{noon + 1s, 3'000}));
    EXPECT_EQ(channel.look(*channel.span(), 10)->columns.at(9)->last, 3 * 4'999);
    EXPECT_EQ(channel.statistics(*channel.span())->value().extent.greatest, 3 * 4'999);
    EXPECT_FALSE(channel.damage());
    target->add(positions(noon + 5s, 10, [](std::size_t) { return 1; }));
    (void)target->end();
    EXPECT_TRUE(recording.head()->hasEnded) << "it follows";
}

TEST_F(ServerRecordings, WhileTheServerIsAwaySamplesWaitAndFollow)
{
    const auto target = begin(settings());
    const QString recording = target->status().server->address;
    target->add(positions(noon, 1'000, [](std::size_t index) { return index; }));
    target->flush();
    EXPECT_TRUE(target->status().server->isConnected);
    server->stop();
    for (int second = 1; second < 20; ++second) {
        target->add(positions(noon + 1s * second, 1'000, [](std::size_t index) { return index; }));
        target->add(RecordedMessage{noon + 1s * second, {.id = MessageId::busStarted}});
        target->flush();
    }
    const RecordingStatus away = target->status();
    EXPECT_FALSE(away.server->isConnected);
    EXPECT_GT(away.server->waitingBytes, 20'000);
    EXPECT_EQ(away.written, noon + 19'999ms) << "on the disk";
    ASSERT_TRUE(away.problem);
    EXPECT_EQ(away.problem->id, RefusalId::serverAway);
    server->start();
    target->flush();
    const RecordingStatus back = target->status();
    EXPECT_TRUE(back.server->isConnected);
    EXPECT_EQ(back.server->waitingBytes, 0);
    EXPECT_FALSE(back.problem);
    const RecordingReader there = reader(recording);
    RecordedChannel channel = RecordingFile::channel(there, Channel::position);
    const auto samples = samplesOf(channel);
    ASSERT_EQ(samples.size(), 20'000U) << "everything, and nothing twice";
    for (std::size_t i = 0; i < samples.size(); ++i)
        ASSERT_EQ(samples[i], (Sample{noon + 1ms * i, static_cast<std::int64_t>(i % 1'000)}));
    EXPECT_EQ(there.messages(ever, 100)->size(), 19U);
    EXPECT_FALSE(target->end().problem);
}

TEST_F(ServerRecordings, ALostConnectionLosesNothing)
{
    const auto target = begin(settings());
    for (int second = 0; second < 20; ++second) {
        target->add(positions(noon + 1s * second, 1'000, [](std::size_t index) { return index; }));
        server->execute(QStringLiteral("postgres"),
                        QStringLiteral("SELECT pg_terminate_backend(pid) FROM pg_stat_activity "
                                       "WHERE application_name = 'codewheel'"));
        target->flush();
    }
    const RecordingStatus status = target->end();
    EXPECT_FALSE(status.problem);
    const RecordingReader there = reader(status.server->address);
    RecordedChannel channel = RecordingFile::channel(there, Channel::position);
    EXPECT_EQ(samplesOf(channel).size(), 20'000U);
    EXPECT_FALSE(channel.damage());
}

TEST_F(ServerRecordings, WhatWasNotSentFollowsWithTheNextRecording)
{
    auto target = begin(settings());
    const QString first = target->status().server->address;
    target->add(positions(noon, 10, [](std::size_t index) { return index; }));
    target->flush();
    server->stop();
    target->add(positions(noon + 1s, 10, [](std::size_t index) { return index; }));
    const RecordingStatus status = target->end();
    ASSERT_TRUE(status.problem);
    EXPECT_EQ(status.problem->id, RefusalId::notAllSent);
    ASSERT_THAT(waitingFiles(), SizeIs(1));
    EXPECT_EQ(std::get<QString>(status.problem->arguments.back()), waitingFiles().front());
    target = begin(settings());
    EXPECT_EQ(target->status().problem.value_or(Refusal()).id, RefusalId::serverAway) << "it waits for it";
    server->start();
    while (waitingFiles().size() > 1)
        target->flush();
    EXPECT_FALSE(target->end().problem);
    const RecordingReader there = reader(first);
    EXPECT_TRUE(there.head()->hasEnded);
    RecordedChannel channel = RecordingFile::channel(there, Channel::position);
    EXPECT_EQ(samplesOf(channel).size(), 20U);
}

TEST_F(ServerRecordings, ABlockMayBeWrittenAgainWhileItIsSent)
{
    const auto target = begin(settings());
    target->add(positions(noon, 1, [](std::size_t) { return 0; }));
    target->flush();
    std::mutex mutex;
    std::int64_t last = 0;
    const auto recordAndRead = [&] {
        const RecordingReader there = reader(target->status().server->address);
        for (int round = 0; round < 50; ++round) {
            std::int64_t mine = 0;
            {
                const std::lock_guard lock(mutex);
                mine = ++last;
                target->add(positions(noon + 1ms * mine, 1, [mine](std::size_t) { return mine; }));
            }
            target->flush();
            RecordedChannel channel = RecordingFile::channel(there, Channel::position);
            EXPECT_EQ(channel.at(noon + 1ms * mine).value(), (Sample{noon + 1ms * mine, mine}));
        }
    };
    {
        std::vector<std::jthread> threads;
        for (int thread = 0; thread < 4; ++thread)
            threads.emplace_back(recordAndRead);
    }
    const RecordingReader there = reader(target->status().server->address);
    RecordedChannel channel = RecordingFile::channel(there, Channel::position);
    EXPECT_EQ(samplesOf(channel).size(), 201U);
    EXPECT_FALSE(channel.damage());
}

TEST_F(ServerRecordings, SeveralStationsRecordAtOnce)
{
    std::vector<std::unique_ptr<RecordingTarget>> stations;
    for (int station = 0; station < 4; ++station)
        stations.push_back(begin(settings()));
    for (std::size_t station = 0; station < stations.size(); ++station)
        stations[station]->add(
            positions(noon, 100, [&](std::size_t index) { return 1'000 * station + index; }));
    for (std::size_t station = 0; station < stations.size(); ++station) {
        const RecordingStatus status = stations[station]->end();
        EXPECT_FALSE(status.problem);
        const RecordingReader there = reader(status.server->address);
        RecordedChannel channel = RecordingFile::channel(there, Channel::position);
        EXPECT_EQ(samplesOf(channel).back().value, static_cast<std::int64_t>(1'000 * station + 99));
    }
    const auto all = RecordingReader::open(address);
    ASSERT_FALSE(all) << "it has to be said which one";
    EXPECT_THAT(refusalText(all.error()).toStdString(), HasSubstr("recording="));
}

TEST_F(ServerRecordings, TheOnlyOneNeedNotBeNamed)
{
    EXPECT_FALSE(RecordingReader::open(address)) << "there is none";
    const auto target = begin(settings());
    target->add(positions(noon, 10, [](std::size_t index) { return index; }));
    EXPECT_FALSE(target->end().problem);
    EXPECT_EQ(reader(address).file(), target->status().server->address);
    EXPECT_FALSE(RecordingReader::open(address + QStringLiteral("?recording=codewheel_other")));
}

TEST_F(ServerRecordings, IsKeptToItsLastHours)
{
    RecordingSettings kept = settings();
    kept.keptFor = 1min;
    const auto target = begin(kept);
    for (int minute = 0; minute < 10; ++minute) {
        target->add(positions(noon + 1min * minute, 600, [](std::size_t index) { return index; }));
        target->flush();
    }
    const RecordingStatus status = target->end();
    const RecordingReader there = reader(status.server->address);
    EXPECT_GE(there.head()->since, noon + 7min);
    EXPECT_LT(server
                  ->execute(database(), QStringLiteral("SELECT count(*) FROM %1.block")
                                            .arg(status.server->address.section(u'=', -1)))
                  .toInt(),
              6);
    kept.keptFor = {};
    kept.largestSize = 1'000'000;
    EXPECT_EQ(RecordingTarget::begin(kept).error().id, RefusalId::noSizeOnServer);
}

} // namespace
} // namespace codewheel
