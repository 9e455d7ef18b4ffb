// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/recording/recording_file.h"

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using namespace test;

const auto scattered = [](std::size_t index) { return index * index * 7'919 % 100'003; };

RecordedMessage messageOfSecond(int second)
{
    return {noon + 1s * second, {.id = MessageId::training, .arguments = {QString::number(second)}}};
}

TEST(RecordingLimits, OnlyTheLastHoursAreKept)
{
    const RecordingFile file;
    RecordingSettings settings = file.settings();
    settings.keptFor = 2h;
    auto writer = file.begin(settings);
    const Place standing = "2.0"_ring;
    writer->add(RecordedValues{standing, {{.at = noon, .position = 42}}});
    for (int minute = 0; minute < 300; ++minute) {
        const Instant from = noon + 1min * minute;
        writer->add(positions(from, 2'000, scattered));
        writer->add(messageOfSecond(60 * minute));
        writer->add(RecordedClock{from, from + (minute < 60 ? 0s : 10s)});
        if (minute % 10 == 9)
            writer->flush();
    }
    writer->add(RecordedValues{standing, {{.at = noon + 299min, .position = 42}}});
    EXPECT_FALSE(writer->end().problem);

    const RecordingReader reader = file.reader();
    const Instant until = reader.head()->until;
    const Instant since = reader.head()->since;
    EXPECT_LE(until - since, Instant(2h + 11min));
    EXPECT_GE(until - since, Instant(2h - 1min));
    RecordedChannel channel = file.channel(reader, Channel::position, 1);
    EXPECT_GE(channel.span()->from, since);
    RecordedChannel turning = file.channel(reader, Channel::position, 0);
    const auto samples = samplesOf(turning);
    for (const Sample &sample : samples)
        ASSERT_GE(sample.at, since);
    EXPECT_EQ(channel.at(until - 1min).value_or(std::nullopt).value_or(Sample()).value, scattered(1'999));
    EXPECT_EQ(reader.messages({Instant(0), since}, 1'000)->size(), 0U);
    EXPECT_EQ(reader.clock()->wall(until), until + 10s) << "what the clock said before is still needed";
    EXPECT_LT(file.execute(QStringLiteral("SELECT count(*) FROM samples")).toInt(), 1'000);
    EXPECT_EQ(file.execute(QStringLiteral("SELECT count(*) FROM samples")),
              file.execute(QStringLiteral("SELECT count(*) FROM block")));
}

TEST(RecordingLimits, AValueThatStandsSinceLongAgoStaysKnown)
{
    const RecordingFile file;
    RecordingSettings settings = file.settings();
    settings.keptFor = 1h;
    auto writer = file.begin(settings);
    for (int minute = 0; minute < 200; ++minute) {
        writer->add(RecordedValues{"1.0"_ring, {{.at = noon + 1min * minute, .position = 42}}});
        writer->add(positions(noon + 1min * minute, 100, scattered, "2.0"_ring));
    }
    (void)writer->end();
    const RecordingReader reader = file.reader();
    RecordedChannel channel = file.channel(reader, Channel::position, 0);
    const Instant since = reader.head()->since;
    EXPECT_GT(since, noon + 2h);
    EXPECT_EQ(channel.at(since + 10min).value().value().value, 42);
    EXPECT_EQ(channel.at(since - 10min).value(), std::nullopt) << "left out";
    EXPECT_EQ(channel.statistics({since, since + 10min}).value().value().known, Instant(10min));
}

TEST(RecordingLimits, TheFileStaysAsLargeAsItMayBe)
{
    const RecordingFile file;
    RecordingSettings settings = file.settings();
    settings.largestSize = 1'000'000;
    auto writer = file.begin(settings);
    std::int64_t largest = 0;
    for (int second = 0; second < 3'000; ++second) {
        writer->add(positions(noon + 1s * second, 1'000, scattered));
        if (second % 20 == 19) {
            writer->flush();
            largest = std::max(largest, writer->status().bytes);
        }
    }
    EXPECT_FALSE(writer->end().problem);
    EXPECT_LT(largest, 1'200'000);
    EXPECT_LT(QFile(file.path).size(), 1'300'000);
    const RecordingReader reader = file.reader();
    EXPECT_GT(reader.head()->since, noon + 10min);
    RecordedChannel channel = file.channel(reader, Channel::position);
    EXPECT_EQ(channel.at(noon + 2'999s).value().value().value, 0) << "the newest is there";
}

} // namespace
} // namespace codewheel
