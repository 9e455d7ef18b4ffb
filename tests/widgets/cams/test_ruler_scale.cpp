// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_circle.h"
#include "widgets/cams/ruler_scale.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Positions = std::vector<std::int64_t>;

RulerScale scale(std::int64_t largest, int width = 500)
{
    RulerScale made;
    made.setLargest(largest);
    made.setColumns(8, width);
    return made;
}

TEST(RulerScaleTest, TicksAreRoundNumbersThatKeepTheirDistance)
{
    const RulerScale small = scale(999);
    EXPECT_EQ(small.tickStep(60), 200);
    EXPECT_EQ(small.ticks(200), (Positions{0, 200, 400, 600, 800}));
    EXPECT_EQ(scale(33'554'431).tickStep(90), 10'000'000);
    EXPECT_EQ(scale(9).tickStep(60), 2);
}

TEST(RulerScaleTest, ZoomingKeepsWhatIsUnderTheMouse)
{
    RulerScale ruler = scale(33'554'431);
    const double before = ruler.positionAt(300);
    ruler.zoom(8, 300);
    EXPECT_NEAR(ruler.positionAt(300), before, 1e-3);
    EXPECT_FALSE(ruler.showsAll());
    ruler.zoom(1.0 / 16, 300);
    EXPECT_TRUE(ruler.showsAll());
    EXPECT_EQ(ruler.first(), 0);
}

TEST(RulerScaleTest, TheClosestZoomTellsSinglePositionsApart)
{
    RulerScale ruler = scale(33'554'431);
    for (int i = 0; i < 100; ++i)
        ruler.zoom(2, 508); // at the right end
    EXPECT_EQ(ruler.shown(), 10);
    EXPECT_EQ(ruler.dragStep(), 1);
    EXPECT_EQ(ruler.ticks(5), (Positions{33'554'425, 33'554'430}));
    ruler.reveal(3);
    EXPECT_EQ(ruler.first(), 3);
}

TEST(RulerScaleTest, ARangeOfOtherSizeIsShownAsAWhole)
{
    RulerScale ruler = scale(999);
    ruler.zoom(4, 100);
    ruler.setLargest(8191);
    EXPECT_TRUE(ruler.showsAll());
}

// start and stop, the part to be moved and by how much, start and stop afterwards; of 1000 positions
struct Move
{
    const char *what;
    Cam (*move)(const Cam &, std::int64_t, std::int64_t);
    Cam before;
    std::int64_t by;
    Cam after;
};

constexpr std::array moves{
    Move{"bar", cam_circle::moved, {21, 531, true}, 10, {31, 541, true}},
    Move{"bar over the right end", cam_circle::moved, {900, 949, false}, 70, {970, 19, false}},
    Move{"bar over the left end", cam_circle::moved, {10, 19, true}, -15, {995, 4, true}},
    Move{"bar of all positions", cam_circle::moved, {0, 999, true}, 5, {5, 4, true}},
    Move{"start", cam_circle::startMoved, {21, 531, true}, 9, {30, 531, true}},
    Move{"start below zero", cam_circle::startMoved, {21, 531, true}, -22, {999, 531, true}},
    Move{"start stays before the stop", cam_circle::startMoved, {21, 531, true}, 900, {531, 531, true}},
    Move{"start takes at most all", cam_circle::startMoved, {21, 531, true}, -5000, {532, 531, true}},
    Move{"stop", cam_circle::stopMoved, {21, 531, true}, -9, {21, 522, true}},
    Move{"stop over the right end", cam_circle::stopMoved, {21, 990, true}, 12, {21, 2, true}},
    Move{"stop stays behind the start", cam_circle::stopMoved, {21, 531, true}, -900, {21, 21, true}},
    Move{"stop of a cam through zero", cam_circle::stopMoved, {990, 9, true}, -15, {990, 994, true}},
};

TEST(CamCircle, MovingGoesOnAtTheOtherEnd)
{
    for (const Move &row : moves)
        EXPECT_EQ(row.move(row.before, row.by, 1000), row.after) << row.what;
}

TEST(CamCircle, ACamThroughZeroIsTwoStretches)
{
    using cam_circle::Stretch;
    EXPECT_EQ(cam_circle::stretches({990, 9, true}, 999),
              (std::vector<Stretch>{{990, 999, true, false}, {0, 9, false, true}}));
    EXPECT_EQ(cam_circle::stretches({7, 7, true}, 999), (std::vector<Stretch>{{7, 7, true, true}}));
}

} // namespace
} // namespace codewheel
