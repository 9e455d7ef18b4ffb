// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/track.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "tests/support/places.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(Track, HasAKeyThatLeadsBackToIt)
{
    const Place otherRing{{3}, NodeId("1.0")};
    const Place otherLine{{4}, NodeId("esc:05")};
    const std::vector<std::pair<Track, QString>> keys{
        {{"1.0"_ring, Channel::position, {}}, QStringLiteral("1.0/position")},
        {{"1.0"_ring, Channel::in, 25}, QStringLiteral("1.0/in.25")},
        {{"1.0"_ring, Channel::out, {}}, QStringLiteral("1.0/out")},
        {{"6.1"_ring, Channel::cams, 0}, QStringLiteral("6.1/cams.0")},
        {{placeOnLine({5}), Channel::speed, {}}, QStringLiteral("esc:05/speed")},
        {{otherRing, Channel::position, {}}, QStringLiteral("3/1.0/position")},
        {{otherLine, Channel::speed, {}}, QStringLiteral("4/esc:05/speed")}};
    for (const auto &[track, key] : keys) {
        EXPECT_EQ(track.key(), key);
        EXPECT_EQ(Track::parse(key), track) << key.toStdString();
    }
}

TEST(Track, IsNotReadFromAnyOtherText)
{
    for (const char *text : {"",
                             "/",
                             "1.0",
                             "position",
                             "/position",
                             "1.0/",
                             "1.0/Position",
                             "1.0/torque",
                             "1.0/position.1",
                             "1.0/speed.0",
                             "1.0/in.",
                             "1.0/in.32",
                             "1.0/in.-1",
                             "1.0/in.+1",
                             "1.0/in.01",
                             "1.0/in.1.2",
                             "1.0/cams.8",
                             "x/1.0/position",
                             "0/1.0/in",
                             "1.0/in "})
        EXPECT_FALSE(Track::parse(QString::fromLatin1(text))) << text;
}

TEST(Track, IsOrderedByPlaceThenChannelThenBit)
{
    const std::vector<Track> tracks{
        {"2.0"_ring, Channel::position, {}},  {"2.0"_ring, Channel::in, {}},
        {"2.0"_ring, Channel::in, 3},         {"2.0"_ring, Channel::in, 20},
        {"10.0"_ring, Channel::position, {}}, {placeOnLine({1}), Channel::position, {}}};
    EXPECT_TRUE(std::ranges::is_sorted(tracks));
}

TEST(Track, ShowsOneBitOfAWordOrAllOfIt)
{
    const std::int64_t word = 0x8200'00FF;
    EXPECT_EQ((Track{"1.0"_ring, Channel::in, {}}.of(word)), word);
    EXPECT_EQ((Track{"1.0"_ring, Channel::in, 25}.of(word)), 1);
    EXPECT_EQ((Track{"1.0"_ring, Channel::in, 24}.of(word)), 0);
    EXPECT_EQ((Track{"1.0"_ring, Channel::in, 31}.of(word)), 1);
}

TEST(Track, HasUnitsWithKeys)
{
    for (const TrackUnit unit : trackUnits)
        EXPECT_EQ(trackUnit(QString(unitKey(unit))), unit);
    EXPECT_FALSE(trackUnit(u"furlongs"));
}

TEST(TrackScale, TurnsSamplesIntoUnits)
{
    const TrackScale steps{};
    EXPECT_DOUBLE_EQ(steps.factor(Channel::position), 1);
    EXPECT_DOUBLE_EQ(1'500 * steps.factor(Channel::speed), 1.5);
    EXPECT_EQ(steps.symbol(Channel::speed), QLatin1String("steps/s"));

    const TrackScale turns{TrackUnit::turns, 1. / 4'096};
    EXPECT_DOUBLE_EQ(8'192 * turns.factor(Channel::position), 2);
    EXPECT_DOUBLE_EQ(4'096 * speedUnits * turns.factor(Channel::speed), 60); // one turn per second, in rpm
    EXPECT_EQ(turns.symbol(Channel::position), QLatin1String("turns"));
    EXPECT_EQ(turns.symbol(Channel::speed), QLatin1String("rpm"));

    const TrackScale degrees{TrackUnit::degrees, 360. / 4'096};
    EXPECT_DOUBLE_EQ(4'096 * speedUnits * degrees.factor(Channel::speed), 360);
    EXPECT_EQ(degrees.symbol(Channel::position), QLatin1String("deg"));
    EXPECT_EQ(degrees.symbol(Channel::speed), QLatin1String("deg/s"));
}

TEST(TrackScale, LeavesWordsAsTheyAre)
{
    const TrackScale scale{TrackUnit::millimetres, 0.005};
    for (const Channel channel : {Channel::in, Channel::out, Channel::cams}) {
        EXPECT_DOUBLE_EQ(scale.factor(channel), 1);
        EXPECT_TRUE(scale.symbol(channel).isEmpty());
    }
}

TEST(TrackScale, EachPartOfTheTimeHasItsOwnScale)
{
    using namespace std::chrono_literals;
    const TrackScale scale{TrackUnit::degrees, 4, {{10s, 1}, {20s, 2}}};
    EXPECT_EQ(scale.factor(Channel::position), 4);
    EXPECT_EQ(scale.factor(Channel::position, 9s), 1);
    EXPECT_EQ(scale.factor(Channel::position, 10s), 2);
    EXPECT_EQ(scale.factor(Channel::position, 20s), 4);
    EXPECT_EQ(scale.factor(Channel::in, 9s), 1) << "a word has none";
    EXPECT_TRUE(scale.changesIn({9s, 11s}));
    EXPECT_FALSE(scale.changesIn({10s, 20s}));
    const std::vector<ScaledSpan> parts = scaledSpans(scale, {5s, 30s});
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_EQ(parts[0].span, (TimeSpan{5s, 10s}));
    EXPECT_EQ(parts[1].span, (TimeSpan{10s, 20s}));
    EXPECT_EQ(parts[2].span, (TimeSpan{20s, 30s}));
    EXPECT_EQ(parts[0].scale.perStep, 1);
    EXPECT_EQ(parts[1].scale.perStep, 2);
    EXPECT_EQ(parts[2].scale.perStep, 4);
}

} // namespace
} // namespace codewheel
