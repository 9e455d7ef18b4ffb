// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/places.h"
#include "widgets/trend/trend_tracks.h"

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using testing::ElementsAre;

const Track position{"1.0"_ring, Channel::position, {}};
const Track speed{"1.0"_ring, Channel::speed, {}};
const Track other{"2.0"_ring, Channel::position, {}};
const Track bit{"1.0"_ring, Channel::out, 25};

class TrendTracksTest : public testing::Test
{
protected:
    TrendTracksTest()
    {
        QObject::connect(&tracks, &TrendTracks::changed, &tracks, [this] { ++told; });
    }
    std::vector<Track> shown() const
    {
        std::vector<Track> shown;
        for (const TrendTracks::Shown &each : tracks.shown())
            shown.push_back(each.track);
        return shown;
    }

    TrendTracks tracks;
    int told = 0;
};

TEST_F(TrendTracksTest, ACurveIsShownOnce)
{
    EXPECT_TRUE(tracks.add(position));
    EXPECT_TRUE(tracks.add(bit));
    EXPECT_TRUE(tracks.add(position));
    EXPECT_THAT(shown(), ElementsAre(position, bit));
    EXPECT_EQ(told, 2);
}

TEST_F(TrendTracksTest, ThereIsALimit)
{
    for (unsigned number = 0; number < TrendTracks::most; ++number)
        EXPECT_TRUE(tracks.add({"1.0"_ring, Channel::in, number}));
    EXPECT_FALSE(tracks.add(position));
    EXPECT_EQ(tracks.shown().size(), TrendTracks::most);
}

TEST_F(TrendTracksTest, CurvesChangeTheirPlaces)
{
    for (const Track &track : {position, speed, other})
        tracks.add(track);
    tracks.move(2, 0);
    EXPECT_THAT(shown(), ElementsAre(other, position, speed));
    tracks.remove(1);
    EXPECT_THAT(shown(), ElementsAre(other, speed));
}

TEST_F(TrendTracksTest, OnlyNumbersOfOneKindAndUnitShareAnAxis)
{
    for (const Track &track : {position, other, speed, bit})
        tracks.add(track);
    EXPECT_TRUE(canShareAxis(tracks.shown()[0], tracks.shown()[1]));
    tracks.setUnit(1, TrackUnit::degrees);
    EXPECT_FALSE(canShareAxis(tracks.shown()[0], tracks.shown()[1]));
    EXPECT_FALSE(canShareAxis(tracks.shown()[0], tracks.shown()[2]));
    EXPECT_FALSE(canShareAxis(tracks.shown()[3], tracks.shown()[3]));
}

TEST_F(TrendTracksTest, CurvesGoWithTheirEncoder)
{
    for (const Track &track : {position, bit, other})
        tracks.add(track);
    tracks.setTravel(position.place, 12.5);
    tracks.encoderMoved(position.place, "3.0"_ring);
    EXPECT_THAT(shown(), ElementsAre(Track{"3.0"_ring, Channel::position, {}},
                                     Track{"3.0"_ring, Channel::out, 25}, other));
    EXPECT_EQ(tracks.travel("3.0"_ring), 12.5);
}

TEST_F(TrendTracksTest, WhatIsKeptComesBack)
{
    for (const Track &track : {position, other, bit})
        tracks.add(track);
    tracks.setUnit(1, TrackUnit::millimetres);
    tracks.shareAxis(1, true);
    tracks.setTravel(other.place, 12.5);
    TrendTracks again;
    again.restore(tracks.state());
    EXPECT_EQ(again.shown(), tracks.shown());
    EXPECT_EQ(again.travel(other.place), 12.5);
    EXPECT_FALSE(again.travel(position.place));
}

TEST_F(TrendTracksTest, WhatCannotBeReadIsLeftOut)
{
    tracks.restore({QString(), QStringLiteral("nonsense"), QStringLiteral("1.0/position furlongs"),
                    QStringLiteral("1.0/position steps"), QStringLiteral("1.0/position turns"),
                    QStringLiteral("mm-per-turn 1.0 -3"), QStringLiteral("mm-per-turn 1.0"),
                    QStringLiteral("1.0/in.32 steps")});
    EXPECT_THAT(shown(), ElementsAre(position));
    EXPECT_FALSE(tracks.travel(position.place));
}

} // namespace
} // namespace codewheel
