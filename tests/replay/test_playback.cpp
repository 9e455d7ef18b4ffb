// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/replay/replay_recording.h"

namespace codewheel {
namespace {

using namespace test;
using Direction = Playback::Direction;

class PlaybackTest : public testing::Test
{
protected:
    ReplayRecording recording;
    std::shared_ptr<Playback> playback = recording.playback();
};

TEST_F(PlaybackTest, StandsAtTheBeginningUntilItIsPlayed)
{
    EXPECT_EQ(playback->span(), (TimeSpan{noon, noon + 10s}));
    EXPECT_EQ(playback->position(), noon);
    playback->advance(1s);
    EXPECT_EQ(playback->position(), noon);
    EXPECT_EQ(playback->dateTime(noon).toUTC(), QDateTime(QDate(2026, 3, 1), QTime(12, 0), Qt::UTC));
}

TEST_F(PlaybackTest, PlaysForwardAndBackwardAtAnySpeedAndPausesAtTheEnds)
{
    playback->play(Direction::forward);
    playback->advance(100ms);
    EXPECT_EQ(playback->position(), noon + 100ms);
    playback->setFactor(10);
    playback->advance(100ms);
    EXPECT_EQ(playback->position(), noon + 1'100ms);
    playback->setFactor(0.1);
    playback->advance(100ms);
    EXPECT_EQ(playback->position(), noon + 1'110ms);
    const int jumps = playback->jumps();
    playback->setFactor(1);
    playback->play(Direction::backward);
    playback->advance(1s);
    EXPECT_EQ(playback->position(), noon + 110ms);
    EXPECT_GT(playback->jumps(), jumps);
    playback->advance(1s);
    EXPECT_EQ(playback->position(), noon);
    EXPECT_FALSE(playback->isPlaying());
    playback->setFactor(1e300);
    playback->play(Direction::forward);
    playback->advance(1h);
    EXPECT_EQ(playback->position(), noon + 10s);
    EXPECT_FALSE(playback->isPlaying());
    playback->play(Direction::forward);
    EXPECT_EQ(playback->position(), noon) << "from the end it begins again";
}

TEST_F(PlaybackTest, StepsToTheSamplesOfAnEncoderOrOfAll)
{
    EXPECT_TRUE(playback->step(Direction::forward, hoist));
    EXPECT_EQ(playback->position(), noon + 10ms);
    EXPECT_TRUE(playback->step(Direction::forward, atTheGate));
    EXPECT_EQ(playback->position(), noon + 100ms);
    EXPECT_TRUE(playback->step(Direction::forward));
    EXPECT_EQ(playback->position(), noon + 110ms);
    EXPECT_TRUE(playback->step(Direction::backward, atTheGate));
    EXPECT_EQ(playback->position(), noon + 100ms);
    EXPECT_TRUE(playback->step(Direction::backward, atTheGate));
    EXPECT_EQ(playback->position(), noon);
    EXPECT_FALSE(playback->step(Direction::backward, atTheGate));
    EXPECT_EQ(playback->position(), noon);
}

TEST_F(PlaybackTest, StepsAcrossAGapInBothDirections)
{
    playback->jumpTo(noon + 4s);
    EXPECT_TRUE(playback->step(Direction::backward, hoist));
    EXPECT_EQ(playback->position(), noon + 1'990ms);
    EXPECT_TRUE(playback->step(Direction::forward, hoist));
    EXPECT_EQ(playback->position(), noon + 6s);
    EXPECT_TRUE(playback->step(Direction::backward, hoist));
    EXPECT_EQ(playback->position(), noon + 1'990ms);
}

TEST_F(PlaybackTest, JumpsWithinTheRecordingOnly)
{
    playback->jumpTo(noon + 1h);
    EXPECT_EQ(playback->position(), noon + 10s);
    playback->jumpTo(noon - 1h);
    EXPECT_EQ(playback->position(), noon);
}

TEST_F(PlaybackTest, ShowsTheTimeOfTheClockThatWasSetMeanwhile)
{
    RecordingFile file;
    auto writer = file.begin();
    writer->add(RecordedClock{noon, noon});
    writer->add(positions(noon, 5'000, [](auto i) { return i; }));
    writer->add(RecordedClock{noon + 2s, noon + 2s - 1h});
    writer->add(RecordedClock{noon + 3s, noon + 3s - 1h});
    writer->end();
    const auto opened = Playback::open(file.path).value();
    EXPECT_EQ(opened->dateTime(noon + 3s).toUTC().time(), QTime(11, 0, 3));
}

TEST_F(PlaybackTest, WhatIsStillBeingWrittenIsThereAfterAnotherLook)
{
    RecordingFile file;
    auto writer = file.begin();
    writer->add(positions(noon, 1'000, [](auto i) { return i; }));
    writer->flush();
    const auto opened = Playback::open(file.path).value();
    EXPECT_EQ(opened->span().to, noon + 999ms);
    opened->jumpTo(noon + 500ms);
    writer->add(positions(noon + 1s, 1'000, [](auto i) { return i; }));
    writer->end();
    opened->lookAgain();
    EXPECT_EQ(opened->span().to, noon + 1'999ms);
    EXPECT_EQ(opened->position(), noon + 500ms);
    EXPECT_TRUE(opened->head().hasEnded);
}

TEST_F(PlaybackTest, WhatIsNoRecordingIsRefused)
{
    RecordingFile file;
    EXPECT_FALSE(Playback::open(file.path)) << "missing";
    file.fill("no database");
    EXPECT_FALSE(Playback::open(file.path));
    file.fill(recording.bytes().first(recording.bytes().size() / 2));
    EXPECT_FALSE(Playback::open(file.path)) << "cut off";
    recording.execute(QStringLiteral("PRAGMA user_version = 99"));
    EXPECT_FALSE(Playback::open(recording.path)) << "of a newer version";
}

} // namespace
} // namespace codewheel
