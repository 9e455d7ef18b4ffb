// SPDX-License-Identifier: GPL-3.0-or-later
// What a recording says is what a history of the same values says.
#include "tests/recording/recording_file.h"
#include "tests/recording/some_motion.h"

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using namespace test;

class RecordedChannelTest : public testing::TestWithParam<Channel>
{
protected:
    void SetUp() override
    {
        std::mt19937_64 random(1602);
        auto writer = file.begin();
        Instant at = noon;
        for (int piece = 0; piece < 12; ++piece) {
            const ShownSeries values = someMotion(random, at, 700);
            for (const ShownValues &shown : values)
                history.add(shown);
            writer->add(RecordedValues{"1.0"_ring, values});
            writer->flush();
            if (piece % 5 == 4)
                at += 100s; // the bus was stopped
        }
        span = {noon - 1s, at + 1s};
        (void)writer->end();
    }

    RecordingFile file;
    EncoderHistory history;
    TimeSpan span;
};

TEST_P(RecordedChannelTest, HasTheSamplesOfTheHistory)
{
    const RecordingReader reader = file.reader();
    RecordedChannel channel = file.channel(reader, GetParam());
    const History &expected = history.of(GetParam());
    ASSERT_EQ(channel.span(), expected.span());
    std::mt19937_64 random(5);
    for (int i = 0; i < 40; ++i) {
        const Instant from = noon + Instant(static_cast<std::int64_t>(random() % 200'000'000));
        const TimeSpan part =
            i == 0 ? span : TimeSpan{from, from + Instant(static_cast<std::int64_t>(random() % 3'000'000))};
        std::vector<Sample> wanted;
        expected.forEach(part, [&](const Sample &sample) { wanted.push_back(sample); });
        ASSERT_EQ(samplesOf(channel, part), wanted);
    }
    EXPECT_FALSE(channel.damage());
}

TEST_P(RecordedChannelTest, HasTheGapsOfTheHistory)
{
    const RecordingReader reader = file.reader();
    RecordedChannel channel = file.channel(reader, GetParam());
    std::vector<History::Gap> gaps;
    ASSERT_TRUE(channel.forEach(span, [&](const Sample &sample, const std::optional<Instant> &gapFrom) {
        if (gapFrom)
            gaps.push_back({*gapFrom, sample.at});
        return true;
    }));
    std::vector<History::Gap> wanted(history.of(GetParam()).gaps().begin(),
                                     history.of(GetParam()).gaps().end());
    if (!wanted.empty() && wanted.back().to == Instant::max())
        wanted.pop_back(); // no sample has followed
    EXPECT_EQ(gaps, wanted);
    EXPECT_EQ(gaps.empty(), GetParam() == Channel::speed);
}

TEST_P(RecordedChannelTest, HasTheColumnsOfTheHistoryWhereTheyAreNarrow)
{
    const RecordingReader reader = file.reader();
    RecordedChannel channel = file.channel(reader, GetParam());
    for (const auto &[part, count] : {std::pair{span, std::size_t{1'000}},
                                      {span, 333},
                                      {TimeSpan{noon + 300ms, noon + 900ms}, 1'000},
                                      {TimeSpan{noon + 1s, noon + 8s}, 100},
                                      {TimeSpan{noon + 8s, noon + 160s}, 200}})
        ASSERT_EQ(channel.look(part, count)->columns, history.of(GetParam()).columns(part, count)) << count;
}

TEST_P(RecordedChannelTest, KnowsTheValueAtAnyTime)
{
    const RecordingReader reader = file.reader();
    RecordedChannel channel = file.channel(reader, GetParam());
    std::mt19937_64 random(6);
    int unknown = 0;
    for (int i = 0; i < 500; ++i) {
        const Instant at = noon + Instant(static_cast<std::int64_t>(random() % 210'000'000));
        const auto wanted = history.of(GetParam()).at(at);
        ASSERT_EQ(channel.at(at).value(), wanted) << (at - noon).count();
        unknown += wanted ? 0 : 1;
    }
    EXPECT_GT(unknown, 0);
    EXPECT_LT(unknown, 500);
}

TEST_P(RecordedChannelTest, HasTheStatisticsOfTheHistory)
{
    const RecordingReader reader = file.reader();
    RecordedChannel channel = file.channel(reader, GetParam());
    std::mt19937_64 random(7);
    for (int i = 0; i < 60; ++i) {
        const Instant from = noon + Instant(static_cast<std::int64_t>(random() % 210'000'000));
        const TimeSpan part =
            i == 0 ? span : TimeSpan{from, from + Instant(static_cast<std::int64_t>(random() % 30'000'000))};
        const auto found = channel.statistics(part);
        const auto wanted = history.of(GetParam()).statistics(part);
        ASSERT_TRUE(found);
        ASSERT_EQ(found->has_value(), wanted.has_value());
        if (!wanted)
            continue;
        EXPECT_EQ((*found)->extent, wanted->extent);
        EXPECT_EQ((*found)->known, wanted->known);
        EXPECT_NEAR((*found)->mean, wanted->mean, 1e-9 * (1 + std::abs(wanted->mean)));
        EXPECT_NEAR((*found)->deviation, wanted->deviation, 1e-6 * (1 + wanted->deviation));
    }
}

INSTANTIATE_TEST_SUITE_P(All, RecordedChannelTest,
                         testing::Values(Channel::position, Channel::in, Channel::out));

// A day of a value each second, with one spike: the columns come from minutes and hours.
class LongRecordingTest : public testing::Test
{
protected:
    static constexpr std::size_t hours = 40;

    void SetUp() override
    {
        auto writer = file.begin();
        RecordedValues values{"1.0"_ring, {}};
        for (std::size_t second = 0; second < hours * 3600; ++second)
            values.values.push_back(
                {.at = noon + 1s * second,
                 .position = second == spike ? 1'000'000 : static_cast<std::int64_t>(second % 100)});
        writer->add(std::move(values));
        (void)writer->end();
    }
    std::size_t columnsWithSpike(Instant from, std::size_t count)
    {
        const RecordingReader reader = file.reader();
        RecordedChannel channel = file.channel(reader, Channel::position);
        const auto look = channel.look({from, noon + 1h * hours}, count);
        std::size_t found = 0;
        for (const auto &column : look->columns) {
            EXPECT_TRUE(column);
            found += column && column->summary.extent.greatest == 1'000'000 ? 1 : 0;
        }
        return found;
    }

    RecordingFile file;
    std::size_t spike = 12'345;
};

TEST_F(LongRecordingTest, ASpikeIsSeenAtEveryZoom)
{
    EXPECT_GT(file.execute(QStringLiteral("SELECT count(*) FROM summary WHERE length = 3600000000")).toInt(),
              37);
    for (const std::size_t count : {1U, 2U, 4U, 5U, 30U, 100U, 299U, 1'000U, 10'000U})
        EXPECT_EQ(columnsWithSpike(noon, count), 1U) << count;
    EXPECT_EQ(columnsWithSpike(noon + 20h, 4), 0U);
}

TEST_F(LongRecordingTest, WhatIsInTheFirstMinutesIsSeenEvenWhereThePictureBeginsAmongThem)
{
    EXPECT_EQ(columnsWithSpike(noon + 12'345s, 4), 1U);
    EXPECT_EQ(columnsWithSpike(noon + 12'340s, 30), 1U);
}

TEST_F(LongRecordingTest, AWideColumnIsRightButForAHalfAtItsEdges)
{
    const RecordingReader reader = file.reader();
    RecordedChannel channel = file.channel(reader, Channel::position);
    const auto columns = channel.look({noon, noon + 1h * hours}, 100)->columns;
    const Instant width = Instant(1h) * static_cast<std::int64_t>(hours) / 100;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const bool has = columns[i]->summary.extent.greatest == 1'000'000;
        const Instant begin = noon + width * static_cast<std::int64_t>(i);
        const Instant at = noon + 1s * spike;
        EXPECT_TRUE(!has || (at >= begin - width / 2 && at < begin + width + width / 2)) << i;
    }
}

TEST(RecordedChannelSteps, FindsTheSamplesBesideATimeWhateverGapsLieBetween)
{
    RecordingFile file;
    auto writer = file.begin();
    writer->add(positions(noon, 1'000, [](auto i) { return i; }));
    writer->add(RecordedInterruption{"1.0"_ring, noon + 1s});
    writer->add(positions(noon + 1h, 1'000, [](auto i) { return 5'000 + i; }));
    writer->end();
    const RecordingReader reader = file.reader();
    RecordedChannel channel = RecordingFile::channel(reader, Channel::position);
    EXPECT_EQ(channel.before(noon + 30min).value(), (Sample{noon + 999ms, 999}));
    EXPECT_EQ(channel.before(noon + 700ms).value(), (Sample{noon + 699ms, 699}));
    EXPECT_EQ(channel.before(noon).value(), std::nullopt);
    EXPECT_EQ(channel.after(noon + 30min).value(), (Sample{noon + 1h, 5'000}));
    EXPECT_EQ(channel.after(noon + 700ms).value(), (Sample{noon + 701ms, 701}));
    EXPECT_EQ(channel.after(noon + 2h).value(), std::nullopt);
}

TEST(RecordedChannelSteps, SaysWhatTheSamplesOfASpanHaveBeenWhateverBlockIsAtHand)
{
    RecordingFile file;
    auto writer = file.begin();
    writer->add(positions(noon, 3'000, [](auto i) { return i; }));
    writer->end();
    const RecordingReader reader = file.reader();
    RecordedChannel channel = RecordingFile::channel(reader, Channel::position);
    const TimeSpan span{noon + 100ms, noon + 104ms};
    const auto cold = channel.summary(span).value();
    ASSERT_TRUE(cold);
    EXPECT_EQ(cold->extent, (Extent{100, 103}));
    EXPECT_EQ(cold->ever & ~cold->always, 0b11U);
    EXPECT_EQ(channel.at(noon + 50ms).value()->value, 50);
    EXPECT_EQ(channel.summary(span).value(), cold);
    EXPECT_EQ(channel.summary({noon + 1h, noon + 2h}).value(), std::nullopt);
    EXPECT_EQ(channel.at(noon + 2'500ms).value()->value, 2'500) << "of another block";
    EXPECT_EQ(channel.at(noon + 50ms).value()->value, 50);
}

} // namespace
} // namespace codewheel
