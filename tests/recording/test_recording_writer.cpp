// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/recording/recording_file.h"
#include "tests/support/no_room.h"
#include "vocabulary/refusal_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QTranslator>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using namespace test;
using testing::ElementsAre;

class AnotherLanguage : public QTranslator
{
public:
    AnotherLanguage() { QCoreApplication::installTranslator(this); }
    bool isEmpty() const override { return false; }
    QString translate(const char *, const char *, const char *, int) const override
    {
        return QStringLiteral("?");
    }
};

const auto counting = [](std::size_t index) { return index; };

TEST(RecordingWriter, TrafficIsReadInWhateverLanguageItWasRecorded)
{
    const RecordingFile file;
    {
        const AnotherLanguage language;
        const auto writer = file.begin();
        for (const auto kind : {TrafficKind::sent, TrafficKind::late})
            writer->add(RecordedTraffic{noon, firstLine, {.kind = kind}});
    }
    const auto rows = file.reader().traffic({noon, noon + 1s}, 10).value();
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].row.kind, TrafficKind::sent);
    EXPECT_EQ(rows[1].row.kind, TrafficKind::late);
}

TEST(RecordingWriter, EverythingThatCameIsThere)
{
    const RecordingFile file;
    auto writer = file.begin();
    const Message fault{.place = "1.0"_ring,
                        .severity = Severity::fault,
                        .id = MessageId::deviceFault,
                        .arguments = {std::int64_t{3}, Word{0x86000000}}};
    const TrafficRow request{.place = Place{firstLine, NodeId("esc:05")},
                             .kind = TrafficKind::answer,
                             .bytes = QByteArray("\x1b"
                                                 "05P\r\n"),
                             .meaning = [] { return QStringLiteral("position"); },
                             .isTyped = true};
    writer->add(RecordedBus{firstBus, QStringLiteral("Ring")});
    writer->add(RecordedDescription{"1.0"_ring, noon, "{\"steps\": 4096}"});
    writer->add(positions(noon, 10, counting));
    writer->add(RecordedDescription{"1.0"_ring, noon + 1s, "{\"steps\": 8192}"});
    writer->add(RecordedMessage{noon + 3ms, fault});
    writer->add(RecordedTraffic{noon + 4ms, firstLine, request});
    writer->add(RecordedNote{noon + 5ms, QStringLiteral("knocked")});
    writer->add(RecordedNote{noon + 6ms, QStringLiteral("wrong")});
    writer->add(RecordedNote{noon + 6ms, {}});
    writer->add(RecordedLoss{noon + 7ms, firstBus, 12});
    writer->add(RecordedClock{noon, noon + 1h});
    EXPECT_FALSE(writer->end().problem);

    const RecordingReader reader = file.reader();
    const RecordingHead head = reader.head().value();
    EXPECT_EQ(head, (RecordingHead{QStringLiteral("test"), QStringLiteral("UTC"), noon, Instant(0), noon + 1s,
                                   true}));
    EXPECT_EQ(reader.buses()->at(0).name, QStringLiteral("Ring"));
    const auto devices = reader.devices().value();
    ASSERT_EQ(devices.size(), 1U);
    EXPECT_EQ(devices[0].place, "1.0"_ring);
    EXPECT_THAT(devices[0].channels, ElementsAre(Channel::position));
    const auto descriptions = reader.descriptions(devices[0]).value();
    ASSERT_EQ(descriptions.size(), 2U);
    EXPECT_EQ(descriptions[1].since, noon + 1s);
    EXPECT_EQ(descriptions[1].json, "{\"steps\": 8192}");
    const TimeSpan all{noon, noon + 1s};
    const auto messages = reader.messages(all, 100).value();
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_EQ(messages[0].at, noon + 3ms);
    EXPECT_EQ(messageOf(messages[0].message), fault);
    const auto traffic = reader.traffic(all, 100).value();
    ASSERT_EQ(traffic.size(), 1U);
    EXPECT_EQ(traffic[0].row.bytes, request.bytes);
    EXPECT_EQ(traffic[0].row.kind, TrafficKind::answer);
    EXPECT_EQ(traffic[0].row.place, request.place);
    EXPECT_TRUE(traffic[0].row.isTyped);
    EXPECT_FALSE(traffic[0].row.isAutomatic);
    const auto notes = reader.notes(all, 100).value();
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].text, QStringLiteral("knocked"));
    EXPECT_EQ(reader.losses()->at(0).count, 12U);
    EXPECT_EQ(reader.clock()->wall(noon + 10s), noon + 1h + 10s);
    RecordedChannel channel = file.channel(reader, Channel::position);
    EXPECT_EQ(samplesOf(channel).size(), 10U);
    EXPECT_EQ(reader.channel(devices[0], Channel::cams).error().id, RefusalId::unknownDevice);
}

TEST(RecordingWriter, BusesMayHaveTheSamePlaces)
{
    const RecordingFile file;
    auto writer = file.begin();
    const Place other{{7}, NodeId("1.0")};
    writer->add(positions(noon, 5, counting));
    writer->add(positions(
        noon, 5, [](std::size_t index) { return 100 + index; }, other));
    (void)writer->end();
    const RecordingReader reader = file.reader();
    EXPECT_EQ(reader.devices()->at(1).place, other);
    RecordedChannel channel = file.channel(reader, Channel::position, 1);
    EXPECT_EQ(samplesOf(channel).front().value, 100);
}

TEST(RecordingWriter, WhileABusIsClosedItsDevicesAreInAGap)
{
    const RecordingFile file;
    auto writer = file.begin();
    const Place other{{7}, NodeId("1.0")};
    for (const Instant from : {noon, noon + 1s}) {
        writer->add(positions(from, 10, counting));
        writer->add(positions(from, 10, counting, other));
        writer->add(RecordedInterruption{Place{firstBus, {}}, from + 20ms});
    }
    (void)writer->end();
    const RecordingReader reader = file.reader();
    RecordedChannel closed = file.channel(reader, Channel::position, 0);
    RecordedChannel open = file.channel(reader, Channel::position, 1);
    EXPECT_TRUE(closed.at(noon + 15ms).value());
    EXPECT_FALSE(closed.at(noon + 500ms).value());
    EXPECT_TRUE(open.at(noon + 500ms).value());
}

TEST(RecordingWriter, ItCanBeReadWhileItIsWritten)
{
    const RecordingFile file;
    auto writer = file.begin();
    writer->add(positions(noon, 100, counting));
    writer->flush();
    EXPECT_EQ(writer->status().written, noon + 99ms);
    const RecordingReader reader = file.reader();
    EXPECT_FALSE(reader.head()->hasEnded);
    RecordedChannel before = file.channel(reader, Channel::position);
    EXPECT_EQ(samplesOf(before).size(), 100U);
    writer->add(positions(noon + 100ms, 1'000, [](std::size_t) { return 99; }));
    writer->flush();
    RecordedChannel after = file.channel(reader, Channel::position);
    EXPECT_EQ(samplesOf(after).size(), 101U);
    EXPECT_EQ(after.at(noon + 1s).value(), (Sample{noon + 99ms, 99})) << "it stands";
    EXPECT_EQ(after.span()->to, noon + 1'099ms + Instant(1));
}

TEST(RecordingWriter, ItBeginsWithWhatWasShownBefore)
{
    const RecordingFile file;
    auto writer = file.begin();
    writer->add(RecordedPast{.place = "1.0"_ring,
                             .samples = {{noon - 5s, 1}, {noon - 4s, 2}, {noon - 2s, 3}},
                             .gaps = {{noon - 3s, noon - 2s}},
                             .until = noon - 1s});
    writer->add(positions(noon, 2, counting));
    (void)writer->end();
    const RecordingReader reader = file.reader();
    RecordedChannel channel = file.channel(reader, Channel::position);
    EXPECT_THAT(samplesOf(channel, {noon - 10s, noon}),
                ElementsAre(Sample{noon - 5s, 1}, Sample{noon - 4s, 2}, Sample{noon - 2s, 3}));
    EXPECT_EQ(channel.at(noon - 2500ms).value(), std::nullopt);
}

// The clock of the computer is set back by an hour: the times of the bus go on, and both are known.
TEST(RecordingWriter, AClockThatIsSetBackTearsNothing)
{
    const RecordingFile file;
    auto writer = file.begin();
    for (int second = 0; second < 10; ++second) {
        const Instant at = noon + 1s * second;
        writer->add(positions(at, 1'000, counting));
        writer->add(RecordedClock{at, second < 5 ? at : at - 1h});
    }
    (void)writer->end();
    const RecordingReader reader = file.reader();
    RecordedChannel channel = file.channel(reader, Channel::position);
    EXPECT_EQ(samplesOf(channel).size(), 10'000U);
    const WallClock clock = reader.clock().value();
    EXPECT_EQ(clock.changes().size(), 2U);
    EXPECT_EQ(clock.wall(noon + 4s), noon + 4s);
    EXPECT_EQ(clock.wall(noon + 6s), noon + 6s - 1h);
}

TEST(RecordingWriter, ABusThatBeginsAnewFurtherBackLosesWhatIsOlder)
{
    const RecordingFile file;
    auto writer = file.begin();
    writer->add(positions(noon + 1h, 10, counting));
    writer->add(RecordedInterruption{{}, noon + 1h + 20ms});
    writer->add(positions(noon, 10, counting));
    writer->add(positions(noon + 1h + 30ms, 10, counting));
    (void)writer->end();
    const RecordingReader reader = file.reader();
    RecordedChannel channel = file.channel(reader, Channel::position);
    EXPECT_EQ(samplesOf(channel).size(), 20U);
    EXPECT_EQ(channel.at(noon + 1h + 25ms).value(), std::nullopt);
}

QString refusedAt(const QString &file)
{
    RecordingFile unused;
    RecordingSettings settings = unused.settings();
    settings.file = file;
    const auto writer = RecordingWriter::begin(settings);
    return writer ? QString() : refusalText(writer.error());
}

TEST(RecordingWriter, AFileThatIsThereIsNeverWrittenOver)
{
    const RecordingFile file;
    file.fill("mine");
    EXPECT_TRUE(refusedAt(file.path).startsWith(QStringLiteral("There is already a file ") + file.path));
    EXPECT_EQ(file.bytes(), "mine");
    QFile::remove(file.path);
    auto first = file.begin();
    EXPECT_TRUE(refusedAt(file.path).startsWith(QStringLiteral("There is already a file ")))
        << "a second writer";
    first->add(positions(noon, 10, counting));
    EXPECT_FALSE(first->end().problem);
}

TEST(RecordingWriter, WhereNoFileCanBeMadeItSaysWhy)
{
    const RecordingFile file;
    EXPECT_EQ(
        refusedAt(QStringLiteral("/proc/night.cwrec")),
        QStringLiteral("/proc/night.cwrec cannot be used: its folder is not there, or you may not use it."));
    const NoRoom disk(10'000);
    EXPECT_NE(refusedAt(file.path), QString());
    EXPECT_TRUE(QDir(file.folder()).isEmpty(QDir::Files | QDir::Hidden)) << "nothing is left of it";
}

TEST(RecordingWriter, OnAFullDiskItWaitsAndGoesOn)
{
    const RecordingFile file;
    auto writer = file.begin();
    writer->add(positions(noon, 1'000, counting));
    writer->flush();
    {
        const NoRoom disk(static_cast<rlim_t>(file.bytes().size()));
        for (int second = 1; second < 300; ++second)
            writer->add(positions(noon + 1s * second, 1'000,
                                  [](std::size_t index) { return index * index * 7'919 % 100'003; }));
        writer->flush();
        const RecordingStatus status = writer->status();
        ASSERT_TRUE(status.problem);
        EXPECT_TRUE(refusalText(*status.problem).startsWith(file.path))
            << refusalText(*status.problem).toStdString();
        EXPECT_EQ(status.written, noon + 999ms);
        EXPECT_FALSE(status.hasEnded);
        const RecordingReader reader = file.reader();
        RecordedChannel channel = file.channel(reader, Channel::position);
        EXPECT_EQ(samplesOf(channel).size(), 1'000U) << "what was written can be read";
    }
    writer->flush();
    EXPECT_FALSE(writer->status().problem);
    EXPECT_FALSE(writer->end().problem);
    const RecordingReader reader = file.reader();
    RecordedChannel channel = file.channel(reader, Channel::position);
    EXPECT_GE(samplesOf(channel).size(), 299'000U);
    EXPECT_TRUE(reader.losses()->empty());
}

TEST(RecordingWriter, WhatHasNoRoomInMemoryIsLostCountedAndAGap)
{
    const RecordingFile file;
    RecordingSettings settings = file.settings();
    settings.mostWaiting = 100'000;
    auto writer = file.begin(settings);
    {
        const NoRoom disk(static_cast<rlim_t>(file.bytes().size()));
        for (int second = 0; second < 100; ++second)
            writer->add(positions(noon + 1s * second, 1'000,
                                  [&](std::size_t index) { return index * index * 7'919 % 100'003; }));
        writer->flush();
        EXPECT_TRUE(writer->status().problem);
    }
    const std::uint64_t lost = writer->status().lost;
    EXPECT_GT(lost, 10'000U);
    writer->flush();
    writer->add(positions(noon + 200s, 1'000, counting));
    EXPECT_FALSE(writer->end().problem);
    const RecordingReader reader = file.reader();
    const auto losses = reader.losses().value();
    std::uint64_t told = 0; // in one gap, or in several if some room came in between
    for (const auto &loss : losses)
        told += loss.count;
    EXPECT_EQ(told, lost);
    RecordedChannel channel = file.channel(reader, Channel::position);
    EXPECT_EQ(samplesOf(channel, {noon + 200s, noon + 300s}).size(), 1'000U);
    for (const auto &loss : losses)
        EXPECT_EQ(channel.at(loss.at).value(), std::nullopt) << "from there on";
}

TEST(RecordingWriter, BeforeTheDiskIsFullForOthersItWaits)
{
    const RecordingFile file;
    RecordingSettings settings = file.settings();
    settings.leastFree = std::numeric_limits<std::int64_t>::max();
    auto writer = file.begin(settings);
    writer->add(positions(noon, 10, counting));
    writer->flush();
    ASSERT_TRUE(writer->status().problem);
    EXPECT_EQ(writer->status().problem->id, RefusalId::diskAlmostFull);
    EXPECT_FALSE(writer->status().hasEnded);
    EXPECT_GT(writer->status().freeBytes, 0);
}

TEST(RecordingWriter, AFileThatIsTakenAwayEndsIt)
{
    const RecordingFile file;
    auto writer = file.begin();
    writer->add(positions(noon, 10, counting));
    writer->flush();
    const QString moved = file.path + QStringLiteral(".moved");
    ASSERT_TRUE(QFile::rename(file.path, moved));
    writer->add(positions(noon + 1s, 10, counting));
    writer->flush();
    const RecordingStatus status = writer->status();
    ASSERT_TRUE(status.problem);
    EXPECT_EQ(status.problem->id, RefusalId::recordingGone);
    EXPECT_TRUE(status.hasEnded);
    writer->add(positions(noon + 2s, 10, counting));
    writer->flush(); // does not wait for ever
    EXPECT_FALSE(QFile::exists(file.path));
    const auto reader = RecordingReader::open(moved);
    RecordedChannel channel = file.channel(*reader, Channel::position);
    EXPECT_EQ(samplesOf(channel).size(), 10U);
}

TEST(RecordingWriter, WhileAnotherProgramHoldsTheFileNothingIsLost)
{
    const RecordingFile file;
    auto writer = file.begin();
    {
        auto other = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("other"));
        other.setDatabaseName(file.path);
        ASSERT_TRUE(other.open());
        QSqlQuery query(other);
        ASSERT_TRUE(query.exec(QStringLiteral("BEGIN EXCLUSIVE")));
        writer->add(positions(noon, 10, counting));
        writer->flush();
        EXPECT_TRUE(writer->status().problem);
        ASSERT_TRUE(query.exec(QStringLiteral("COMMIT")));
    }
    QSqlDatabase::removeDatabase(QStringLiteral("other"));
    EXPECT_FALSE(writer->end().problem);
    const RecordingReader reader = file.reader();
    RecordedChannel channel = file.channel(reader, Channel::position);
    EXPECT_EQ(samplesOf(channel).size(), 10U);
}

} // namespace
} // namespace codewheel
