// SPDX-License-Identifier: GPL-3.0-or-later
// What the trend gets of a recording is what it would get of the values in memory, at another time and place.
// place.
#include "kinds/interbus/ring/ring_messages.h"
#include "recording/recording_archive.h"
#include "tests/recording/recording_file.h"
#include "tests/recording/some_motion.h"
#include "vocabulary/refusal_text.h"

#include <QEventLoop>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using namespace test;

const Place recordedPlace = "1.0"_ring;
const Place placeHere{BusId{9}, recordedPlace.node};
constexpr Instant shift = -3h;

class RecordedHistoryTest : public testing::Test
{
protected:
    void SetUp() override
    {
        std::mt19937_64 random(1602);
        auto writer = file.begin();
        Instant at = noon;
        for (int piece = 0; piece < 12; ++piece) {
            const ShownSeries values = someMotion(random, at, 700);
            for (ShownValues shown : values) {
                shown.at += shift;
                memory.add(shown);
            }
            writer->add(RecordedValues{recordedPlace, values});
            writer->flush();
            if (piece % 5 == 4)
                at += 100s; // the bus was stopped
        }
        writer->add(RecordedMessage{noon + 2s, {.place = recordedPlace, .id = RingMessageId::alarmStop}});
        writer->add(RecordedMessage{noon + 3s, {.place = {}, .id = RingMessageId::alarmStop}});
        writer->add(RecordedNote{noon + 1s, QStringLiteral("knocked")});
        end = at;
        (void)writer->end();
        archive = std::move(RecordingArchive::open(file.path, {{recordedPlace.bus, placeHere.bus}}).value());
        archive->setShift(shift);
    }
    const History &recorded(Channel channel = Channel::position) const
    {
        return *archive->of(placeHere, channel);
    }
    TimeSpan someSpan()
    {
        const Instant from = noon + shift + Instant(static_cast<std::int64_t>(random() % 210'000'000));
        return {from, from + Instant(static_cast<std::int64_t>(random() % 4'000'000))};
    }

    RecordingFile file;
    EncoderHistory memory;
    Instant end{};
    std::mt19937_64 random{7};
    std::unique_ptr<RecordingArchive> archive;
};

TEST_F(RecordedHistoryTest, IsAtItsPlaceHere)
{
    EXPECT_THAT(archive->places(), testing::ElementsAre(placeHere));
    EXPECT_EQ(archive->of(recordedPlace, Channel::position), nullptr);
    EXPECT_EQ(archive->of(placeHere, Channel::cams), nullptr);
    EXPECT_EQ(archive->span(), (TimeSpan{memory.span()->from, memory.span()->to}));
}

TEST_F(RecordedHistoryTest, HasTheSamplesAndGapsThatMemoryHas)
{
    for (const Channel channel : {Channel::position, Channel::in}) {
        const History &wanted = memory.of(channel);
        EXPECT_EQ(recorded(channel).span(), wanted.span());
        EXPECT_EQ(recorded(channel).newest(), wanted.newest());
        for (int i = 0; i < 100; ++i) {
            const TimeSpan span = i == 0 ? TimeSpan{Instant(0), Instant::max()} : someSpan();
            std::vector<Sample> samples;
            recorded(channel).forEach(span, [&](const Sample &sample) { samples.push_back(sample); });
            std::vector<Sample> kept;
            wanted.forEach(span, [&](const Sample &sample) { kept.push_back(sample); });
            ASSERT_EQ(samples, kept);
            ASSERT_EQ(recorded(channel).gaps(span), wanted.gaps(span));
            ASSERT_EQ(recorded(channel).at(span.from), wanted.at(span.from));
            ASSERT_EQ(recorded(channel).after(span.from), wanted.after(span.from));
        }
    }
}

TEST_F(RecordedHistoryTest, LooksAsItDoesInMemory)
{
    const History &wanted = memory.of(Channel::position);
    for (int i = 0; i < 100; ++i) {
        const TimeSpan span = someSpan();
        EXPECT_GE(recorded().count(span), wanted.count(span));
        EXPECT_EQ(recorded().extent(span), wanted.extent(span));
        EXPECT_EQ(recorded().columns(span, 700), wanted.columns(span, 700));
        const auto statistics = recorded().statistics(span);
        ASSERT_EQ(statistics.has_value(), wanted.statistics(span).has_value());
        if (statistics) {
            EXPECT_EQ(statistics->extent, wanted.statistics(span)->extent);
            EXPECT_NEAR(statistics->mean, wanted.statistics(span)->mean, 1e-3);
        }
    }
}

TEST_F(RecordedHistoryTest, MessagesOfDevicesAndNotesAreMarks)
{
    const auto marks = archive->marks();
    ASSERT_EQ(marks.size(), 2U);
    EXPECT_EQ(marks[0], (Mark{noon + shift + 1s, {}, QStringLiteral("knocked")}));
    EXPECT_EQ(marks[1].at, noon + shift + 2s);
    EXPECT_EQ(marks[1].place, placeHere);
}

TEST_F(RecordedHistoryTest, StatisticsThatTakeLongerFollow)
{
    int told = 0;
    QEventLoop loop;
    QObject::connect(archive.get(), &Archive::statisticsReady, &loop, [&] {
        ++told;
        loop.quit();
    });
    const TimeSpan all{noon, end};
    const RecordedKey key{archive->reader().devices()->front().id, Channel::position};
    EXPECT_EQ(archive->slowStatistics(key, all), std::nullopt);
    loop.exec();
    const auto statistics = archive->slowStatistics(key, all);
    ASSERT_TRUE(statistics);
    EXPECT_EQ(statistics->extent, memory.of(Channel::position).extent({all.from + shift, all.to + shift}));
    EXPECT_EQ(told, 1);
}

TEST_F(RecordedHistoryTest, WhatIsDamagedIsAGapAndToldOnce)
{
    file.execute(QStringLiteral("UPDATE samples SET data = x'00' WHERE id IN (SELECT data FROM block JOIN "
                                "channel ON channel.id = block.channel WHERE kind = 'position')"));
    std::vector<Refusal> told;
    QObject::connect(archive.get(), &RecordingArchive::troubled,
                     [&](const Refusal &why) { told.push_back(why); });
    const TimeSpan all = *archive->span();
    for (int i = 0; i < 2; ++i)
        (void)recorded().columns({all.from, all.from + 3s}, 10'000);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].id, RefusalId::damagedBlocks);
}

} // namespace
} // namespace codewheel
