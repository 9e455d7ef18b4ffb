// SPDX-License-Identifier: GPL-3.0-or-later
// A recording may come from anybody.
#include "tests/recording/recording_file.h"
#include "vocabulary/refusal_text.h"

#include <gmock/gmock.h>
#include <random>
#include <unistd.h>

namespace codewheel {
namespace {

using namespace test;

void record(const RecordingFile &file)
{
    auto writer = file.begin();
    for (std::size_t second = 0; second < 30; ++second) {
        writer->add(positions(noon + 1s * second, 1'000,
                              [second](std::size_t index) { return 1'000 * second + index; }));
        writer->add(RecordedMessage{noon + 1s * second, {.id = MessageId::busStarted}});
        writer->flush();
    }
    EXPECT_FALSE(writer->end().problem);
}

QString whyNot(const QString &file)
{
    const auto reader = RecordingReader::open(file);
    return reader ? QString() : refusalText(reader.error());
}

TEST(RecordingReader, SaysWhyAFileIsNoRecording)
{
    const RecordingFile file;
    EXPECT_EQ(whyNot(file.path), file.path + QStringLiteral(" cannot be used: it does not exist."));
    EXPECT_FALSE(QFile::exists(file.path));
    EXPECT_EQ(whyNot(file.folder()), file.folder() + QStringLiteral(" cannot be used: it is not a file."));
    file.fill("position,speed\r\n1,2\r\n");
    EXPECT_EQ(whyNot(file.path),
              file.path + QStringLiteral(" cannot be used: it is not a database, and was left as it was."));
    EXPECT_EQ(file.bytes(), "position,speed\r\n1,2\r\n");
}

// Killed within its first milliseconds.
TEST(RecordingReader, AFileThatWasOnlyJustMadeIsEmpty)
{
    const RecordingFile file;
    const QString empty =
        file.path +
        QStringLiteral(
            " cannot be used: it is empty: the program that made it ended before anything was in it.");
    file.fill({});
    EXPECT_EQ(whyNot(file.path), empty);
    file.execute(QStringLiteral("PRAGMA auto_vacuum = INCREMENTAL"));
    file.execute(QStringLiteral("VACUUM"));
    EXPECT_GT(file.bytes().size(), 0);
    EXPECT_EQ(whyNot(file.path), empty);
    file.execute(QStringLiteral("CREATE TABLE theirs (a)"));
    EXPECT_EQ(whyNot(file.path),
              file.path + QStringLiteral(" cannot be used: it is the database of another program."));
}

TEST(RecordingReader, SaysThatANewerVersionMadeIt)
{
    const RecordingFile file;
    record(file);
    file.execute(QStringLiteral("PRAGMA user_version = 99"));
    EXPECT_TRUE(whyNot(file.path).contains(
        QStringLiteral("it was made by a newer Codewheel (version 99 of the file")));
}

TEST(RecordingReader, AFileWithOtherTablesIsDamaged)
{
    const RecordingFile file;
    record(file);
    file.execute(QStringLiteral("CREATE VIEW trap AS SELECT * FROM block"));
    EXPECT_TRUE(whyNot(file.path).contains(QStringLiteral("damaged")));
}

TEST(RecordingReader, ReadsWhereNothingMayBeWritten)
{
    const RecordingFile file;
    record(file);
    const QByteArray before = file.bytes();
    QFile::setPermissions(file.path, QFile::ReadOwner);
    QFile::setPermissions(file.folder(), QFile::ReadOwner | QFile::ExeOwner);
    {
        const RecordingReader reader = file.reader();
        RecordedChannel channel = file.channel(reader, Channel::position);
        EXPECT_EQ(samplesOf(channel).size(), 30'000U);
    }
    QFile::setPermissions(file.folder(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    EXPECT_EQ(file.bytes(), before);
}

TEST(RecordingReader, WhereASecondIsDamagedThereIsAGapAndASentence)
{
    const RecordingFile file;
    record(file);
    file.execute(QStringLiteral("UPDATE samples SET data = zeroblob(length(data)) WHERE id = 12"));
    file.execute(QStringLiteral("DELETE FROM samples WHERE id = 20"));
    const RecordingReader reader = file.reader();
    RecordedChannel channel = file.channel(reader, Channel::position);
    std::vector<TimeSpan> gaps;
    std::size_t count = 0;
    ASSERT_TRUE(
        channel.forEach({noon, noon + 1h}, [&](const Sample &sample, const std::optional<Instant> &gapFrom) {
            if (gapFrom)
                gaps.push_back({*gapFrom, sample.at});
            ++count;
            return true;
        }));
    EXPECT_EQ(count, 28'000U);
    EXPECT_THAT(gaps, testing::ElementsAre(TimeSpan{noon + 10'999ms, noon + 12s},
                                           TimeSpan{noon + 18'999ms, noon + 20s}));
    ASSERT_TRUE(channel.damage());
    EXPECT_EQ(
        refusalText(*channel.damage()),
        QStringLiteral(
            "Some values of %1 cannot be read: the file is damaged (blocks: 2). There are gaps instead.")
            .arg(file.path));
    EXPECT_EQ(channel.at(noon + 11'500ms).value(), std::nullopt);
    const auto look = channel.look({noon, noon + 30s}, 300);
    EXPECT_FALSE(look->columns.at(115));
    EXPECT_TRUE(look->columns.at(125));
    EXPECT_TRUE(channel.statistics({noon, noon + 30s}));
}

// Everything that can be asked; it is answered, or refused with a sentence.
void askEverything(const QString &file)
{
    auto reader = RecordingReader::open(file);
    if (!reader) {
        EXPECT_FALSE(refusalText(reader.error()).isEmpty());
        return;
    }
    const TimeSpan all{Instant(0), Instant::max() / 2'000};
    (void)reader->head();
    (void)reader->buses();
    (void)reader->messages(all, 1'000);
    (void)reader->notes(all, 1'000);
    (void)reader->traffic(all, 1'000);
    (void)reader->losses();
    (void)reader->clock();
    const auto devices = reader->devices();
    if (!devices)
        return;
    for (const auto &device : *devices) {
        (void)reader->descriptions(device);
        for (const Channel channel : device.channels)
            if (auto found = reader->channel(device, channel)) {
                (void)found->span();
                (void)found->look(all, 100);
                (void)found->look({noon, noon + 30s}, 1'000);
                (void)found->at(noon + 5s);
                (void)found->statistics({noon, noon + 30s});
                (void)found->forEach(all, [](const Sample &, const auto &) { return true; });
            }
    }
}

TEST(RecordingReader, AFileThatWasCutOffIsReadOrRefused)
{
    const RecordingFile file;
    record(file);
    const QByteArray whole = file.bytes();
    int refused = 0;
    for (int tenth = 0; tenth <= 10; ++tenth) {
        file.fill(whole.first(whole.size() * tenth / 10));
        askEverything(file.path);
        refused += whyNot(file.path).isEmpty() ? 0 : 1;
    }
    EXPECT_GT(refused, 0);
}

TEST(RecordingReader, ScratchesAnywhereAreReadOrRefused)
{
    const RecordingFile file;
    record(file);
    const QByteArray whole = file.bytes();
    std::mt19937 random(1616);
    for (int i = 0; i < 60; ++i) {
        QByteArray scratched = whole;
        for (int scratch = 0; scratch < 20; ++scratch) {
            const auto at =
                static_cast<qsizetype>(random() % static_cast<unsigned>(i % 2 == 0 ? 20'000 : whole.size()));
            scratched[at % whole.size()] = static_cast<char>(random());
        }
        file.fill(scratched);
        askEverything(file.path);
    }
}

TEST(RecordingReader, NumbersBeyondAllMeasureDoNoHarm)
{
    for (const char *sql :
         {"UPDATE block SET length = 9223372036854775807", "UPDATE block SET length = -9223372036854775807",
          "UPDATE block SET start = 9223372036854775807 - data",
          "UPDATE block SET start = -9223372036854775807 + data",
          "UPDATE block SET start = 'x', lowest = 'y', gap = x'00'",
          "UPDATE block SET data = 1, start = data", "UPDATE device SET until = 9223372036854775807",
          "UPDATE device SET until = -5, place = 'a/b/c'", "UPDATE device SET place = 'x'",
          "UPDATE channel SET gap_since = 'z'", "UPDATE channel SET device = 77",
          "UPDATE recording SET since = 9223372036854775807", "DELETE FROM recording",
          "UPDATE message SET code = x'FF', severity = 99, place = '999999999999999/'",
          "INSERT INTO summary VALUES (1, 60000000, -9223372036854775807, 1, 1, 1, 1, 1, 1, 1, 1), "
          "(1, 60000000, 9223372036854775807, 1, 1, 1, 1, 1, 1, 1, 1), "
          "(1, 3600000000, 'abc', 1, 1, 1, 1, 1, 1, 1, 1)"}) {
        const RecordingFile file;
        record(file);
        file.execute(QString::fromLatin1(sql));
        SCOPED_TRACE(sql);
        askEverything(file.path);
    }
}

TEST(RecordingReader, ReadsOnlyWhatIsAskedFor)
{
    const RecordingFile file;
    record(file);
    file.execute(QStringLiteral("UPDATE samples SET data = zeroblob(10) WHERE id <> 16"));
    const RecordingReader reader = file.reader();
    RecordedChannel channel = file.channel(reader, Channel::position);
    EXPECT_TRUE(channel.look({noon, noon + 30s}, 3)->columns.at(2)) << "from what stands above the blocks";
    EXPECT_FALSE(channel.damage());
    EXPECT_EQ(samplesOf(channel, {noon + 15s + 1ms, noon + 16s}).size(), 999U);
    EXPECT_FALSE(channel.damage());
}

// The row of a block and its samples are read one after the other.
TEST(RecordingReader, ABlockMayBeWrittenAgainWhileItIsRead)
{
    const RecordingFile file;
    auto writer = file.begin();
    writer->add(positions(noon, 100, [](std::size_t index) { return index; }));
    (void)writer->end();
    file.execute(QStringLiteral("UPDATE block SET length = 49000, samples = 50, last = 49"));
    const RecordingReader reader = file.reader();
    RecordedChannel channel = file.channel(reader, Channel::position);
    const auto samples = samplesOf(channel, {noon, noon + 60ms});
    EXPECT_EQ(samples.size(), 50U);
    EXPECT_EQ(channel.at(noon + 30ms).value(), (Sample{noon + 30ms, 30}));
    EXPECT_FALSE(channel.damage());
}

} // namespace
} // namespace codewheel
