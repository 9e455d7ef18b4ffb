// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/seen_time.h"

#include <gtest/gtest.h>

namespace codewheel {

void PrintTo(const TimeSpan &span, std::ostream *out)
{
    *out << span.from.count() << " to " << span.to.count();
}

namespace {

using namespace std::chrono_literals;

class SeenTimeTest : public testing::Test
{
protected:
    SeenTimeTest()
    {
        time.setColumns(600);
        time.setAll({100s, 1'000s});
    }

    SeenTime time;
};

TEST_F(SeenTimeTest, TheNewestStandsAtTheRight)
{
    EXPECT_TRUE(time.follows());
    EXPECT_GT(time.span().to, 1'000s);
    EXPECT_LE(time.span().to, 1'000s + 100ms);
    EXPECT_EQ(time.length(), 60s);
}

TEST_F(SeenTimeTest, ItMovesByWholePixels)
{
    const TimeSpan before = time.span();
    time.setAll({100s, 1'000s + 99ms});
    EXPECT_EQ(time.span(), before);
    time.setAll({100s, 1'000s + 101ms});
    EXPECT_EQ(time.span(), (TimeSpan{before.from + 100ms, before.to + 100ms}));
}

TEST_F(SeenTimeTest, WhoScrollsIsNotPulledAway)
{
    time.scroll(-1);
    EXPECT_FALSE(time.follows());
    const TimeSpan seen = time.span();
    time.setAll({100s, 2'000s});
    EXPECT_EQ(time.span(), seen);
    time.follow();
    EXPECT_GT(time.span().to, 2'000s);
}

TEST_F(SeenTimeTest, ZoomingKeepsWhatIsPointedAt)
{
    time.show({200s, 300s});
    time.zoom(0.5, 0.25);
    EXPECT_EQ(time.span(), (TimeSpan{212'500ms, 262'500ms}));
    time.zoom(2, 0.25);
    EXPECT_EQ(time.span(), (TimeSpan{200s, 300s}));
}

TEST_F(SeenTimeTest, ZoomingWhileItFollowsKeepsTheNewest)
{
    time.zoom(0.5, 0);
    EXPECT_TRUE(time.follows());
    EXPECT_EQ(time.length(), 30s);
    EXPECT_GE(time.span().to, 1'000s);
}

TEST_F(SeenTimeTest, NothingIsShorterOrLongerThanMakesSense)
{
    time.show({200s, 200s + 1us});
    EXPECT_EQ(time.length(), SeenTime::shortest);
    time.show({-1'000'000s, 1'000'000s});
    EXPECT_EQ(time.length(), 1'080s);
    time.show({5'000s, 5'010s});
    EXPECT_LT(time.span().from, 1'000s) << "something can always be seen";
    time.show({-5'000s, -4'990s});
    EXPECT_GT(time.span().to, 100s);
}

TEST_F(SeenTimeTest, AllIsWithAMarginOnBothSides)
{
    time.showAll();
    EXPECT_LT(time.span().from, 100s);
    EXPECT_GT(time.span().to, 1'000s);
    EXPECT_LT(time.length(), 950s);
}

} // namespace
} // namespace codewheel
