// SPDX-License-Identifier: GPL-3.0-or-later
// What a curve looks like, in pixels.
#include "widgets/trend/curve_painter.h"

#include <QImage>
#include <QPainter>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr int width = 400;
constexpr int height = 100;

class CurvePainterTest : public testing::Test
{
protected:
    void fill(Instant from, int count, auto value)
    {
        for (int index = 0; index < count; ++index)
            history.append({from + 1ms * index, value(index)});
    }
    void draw(const TimeSpan &span, double low, double high)
    {
        paint([&](CurvePainter &painter) { painter.draw(curve, low, high); }, span);
    }
    void drawBit(const TimeSpan &span, unsigned bit)
    {
        curve.track = {{}, Channel::in, bit};
        paint([&](CurvePainter &painter) { painter.drawBit(curve); }, span);
    }
    void paint(auto what, const TimeSpan &span)
    {
        image.fill(Qt::white);
        QPainter on(&image);
        CurvePainter painter(on, QRectF(0, 0, width, height), span, width);
        what(painter);
    }
    bool isDrawn(int x, int y) const { return image.pixelColor(x, y) != Qt::white; }
    bool hasInRow(int y) const
    {
        for (int x = 0; x < width; ++x)
            if (isDrawn(x, y))
                return true;
        return false;
    }
    bool hasInColumn(int x) const
    {
        for (int y = 0; y < height; ++y)
            if (isDrawn(x, y))
                return true;
        return false;
    }

    MemoryHistory history;
    TrendCurve curve{.track = {}, .scale = {}, .history = &history, .name = {}, .color = Qt::black};
    QImage image{width, height, QImage::Format_RGB32};
};

TEST_F(CurvePainterTest, ASpikeOfOneCycleIsSeenAtEveryZoom)
{
    fill(0s, 300'000, [](int index) { return index == 123'457 ? 1'000 : 10; });
    for (const Instant length : std::array<Instant, 6>{300s, 100s, 10s, 1s, 100ms, 10ms}) {
        const Instant from = std::max(Instant(123'457ms - length / 3), Instant(0));
        draw({from, from + length}, 0, 1'010);
        EXPECT_TRUE(hasInRow(1) || hasInRow(2)) << length.count();
    }
}

TEST_F(CurvePainterTest, WhatStandsIsALineThroughAllOfIt)
{
    fill(0s, 10'000, [](int) { return 50; });
    draw({2s, 8s}, 0, 100);
    for (int x = 0; x < width; ++x)
        ASSERT_TRUE(isDrawn(x, 50) || isDrawn(x, 49)) << x;
}

TEST_F(CurvePainterTest, AGapIsNotDrawnThrough)
{
    fill(0s, 1'000, [](int) { return 50; });
    history.interrupt(1s);
    fill(3s, 1'001, [](int) { return 50; });
    draw({0s, 4s}, 0, 100);
    EXPECT_TRUE(hasInColumn(50));
    EXPECT_FALSE(hasInColumn(150));
    EXPECT_FALSE(hasInColumn(250));
    EXPECT_TRUE(hasInColumn(350));
}

TEST_F(CurvePainterTest, BeforeTheFirstAndBehindTheLastThereIsNothing)
{
    fill(1s, 1'001, [](int) { return 50; });
    draw({0s, 4s}, 0, 100);
    EXPECT_FALSE(hasInColumn(90));
    EXPECT_TRUE(hasInColumn(150));
    EXPECT_FALSE(hasInColumn(210));
}

TEST_F(CurvePainterTest, ASampleThatStandsAloneIsSeen)
{
    history.append({1s, 50});
    draw({0s, 2s}, 0, 100);
    EXPECT_TRUE(hasInColumn(200) || hasInColumn(201));
}

TEST_F(CurvePainterTest, WhatIsBeyondTheAxisIsDrawnBeyondIt)
{
    fill(0s, 4'000, [](int index) { return index < 2'000 ? 50 : 4'000'000'000; });
    draw({0s, 4s}, 0, 100);
    EXPECT_TRUE(hasInColumn(100));
    EXPECT_FALSE(hasInColumn(300));
}

TEST_F(CurvePainterTest, ScaledValuesAreDrawnInTheirUnit)
{
    curve.track.channel = Channel::position;
    curve.scale = {TrackUnit::degrees, 360.0 / 8'192};
    fill(0s, 4'000, [](int) { return 4'096; });
    draw({0s, 4s}, 0, 360);
    EXPECT_TRUE(isDrawn(200, 50) || isDrawn(200, 49));
}

TEST_F(CurvePainterTest, WhatIsBeforeAChangeOfTheScaleIsDrawnInItsOwn)
{
    curve.track.channel = Channel::position;
    curve.scale = {TrackUnit::degrees, 360.0 / 8'192, {{2s, 360.0 / 4'096}}};
    for (const int samples : {40, 4'000}) { // fewer and more than columns
        history = {};
        const Instant step = Instant(4s) / samples;
        for (int index = 0; index < samples; ++index)
            history.append({step * index, (index < samples / 2 ? 2'048 : 4'096) + index % 2});
        draw({0s, 4s}, 0, 360);
        for (const int x : {50, 150, 250, 350})
            EXPECT_TRUE(isDrawn(x, 50) || isDrawn(x, 49)) << samples << ", " << x;
        EXPECT_FALSE(hasInRow(25)) << samples;
        EXPECT_FALSE(hasInRow(75)) << samples;
    }
}

// The change is in a gap, and both sides of it in one column of pixels or in two.
TEST_F(CurvePainterTest, AtAChangeOfTheScaleThereIsNoSpike)
{
    curve.track.channel = Channel::speed;
    curve.scale = {TrackUnit::turns, 1.0 / 4'096, {{2'000ms, 1.0 / 8'192}}};
    const auto stood = [](int stepsPerTurn) { return [=](int) { return 1'000LL * stepsPerTurn; }; };
    for (const Instant shift : std::array<Instant, 6>{0ms, 1ms, 3ms, 5ms, 7ms, 9ms})
        for (const Instant length : std::array<Instant, 3>{100ms, 4s, 40s}) {
            history = {};
            fill(0s, 1'995, stood(8'192));
            history.interrupt(1'995ms);
            fill(2'004ms, 2'000, stood(4'096));
            const Instant from = Instant(2s) - length / 2 + shift;
            draw({from, from + length}, 0, 120); // 60 rpm is in the middle
            EXPECT_TRUE(hasInRow(50) || hasInRow(49));
            for (const int y : {5, 20, 30, 40, 60, 70, 80, 95})
                ASSERT_FALSE(hasInRow(y)) << length.count() << ", " << shift.count() << ": " << y;
        }
}

TEST_F(CurvePainterTest, WhatStandsGoesOnInTheNextScale)
{
    curve.track.channel = Channel::position;
    curve.scale = {TrackUnit::degrees, 360.0 / 8'192, {{2s, 360.0 / 4'096}}};
    fill(0s, 4'001, [](int) { return 2'048; });
    const auto isAt = [&](int x, int y) { return isDrawn(x, y) || isDrawn(x, y - 1); };
    draw({1'950ms, 2'050ms}, 0, 360);
    for (const int x : {0, 100, 198})
        EXPECT_TRUE(isAt(x, 50)) << x << ": 180 degrees before";
    for (const int x : {202, 300, 399})
        EXPECT_TRUE(isAt(x, 75)) << x << ": 90 degrees behind";
    EXPECT_FALSE(hasInRow(62)) << "no line from one to the other";
    draw({1'000ms, 1'500ms}, 0, 360);
    EXPECT_TRUE(isAt(0, 50) && isAt(200, 50) && isAt(398, 50));
    draw({2'500ms, 3'000ms}, 0, 360);
    EXPECT_TRUE(isAt(0, 75) && isAt(200, 75) && isAt(398, 75));
}

TEST_F(CurvePainterTest, ABitHasTwoLevelsAndAnUprightLineWhereItChanges)
{
    fill(0s, 4'000, [](int index) { return std::int64_t{index < 2'000 ? 0x0000'0001 : 0x8000'0001}; });
    drawBit({0s, 4s}, 31);
    EXPECT_FALSE(isDrawn(100, 50));
    EXPECT_TRUE(isDrawn(300, 50)) << "1 is filled";
    EXPECT_TRUE(isDrawn(300, 0));
    EXPECT_FALSE(isDrawn(100, 0));
    drawBit({0s, 4s}, 0);
    EXPECT_TRUE(isDrawn(100, 50));
}

TEST_F(CurvePainterTest, ABitOfOneCycleIsSeenAtEveryZoom)
{
    fill(0s, 300'000, [](int index) { return std::int64_t{index == 123'457 ? 4 : 0}; });
    for (const Instant length : std::array<Instant, 3>{300s, 10s, 100ms}) {
        const Instant from = std::max(Instant(123'457ms - length / 3), Instant(0));
        drawBit({from, from + length}, 2);
        EXPECT_TRUE(hasInRow(50)) << length.count();
    }
}

} // namespace
} // namespace codewheel
