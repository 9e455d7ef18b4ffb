// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/look/frame_clock.h"
#include "tests/app/window_test.h"
#include "tests/support/events_seen.h"

#include <QLabel>
#include <QTimer>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::fraba;

constexpr int atMost = 60'000; // ms

class FrameClockTest : public test::WindowTest
{
protected:
    FrameClockTest()
    {
        clock.setWindow(window());
        clock.start();
    }
    ~FrameClockTest() override { clock.stop(); }

    // Frames taken, as a share of the usual number.
    double share()
    {
        int frames = 0;
        int ticks = 0;
        QTimer usual;
        usual.setTimerType(Qt::PreciseTimer);
        QObject::connect(&usual, &QTimer::timeout, &usual, [&] { ++ticks; });
        QObject::connect(&bus(), &RingSession::updated, &usual, [&] { ++frames; });
        usual.start(33ms);
        EXPECT_TRUE(QTest::qWaitFor([&] { return ticks >= 20; }, atMost));
        return static_cast<double>(frames) / ticks;
    }
    QString rawPosition()
    {
        for (const auto *label : window().findChildren<QLabel *>())
            if (label->accessibleName() == QLatin1String("Raw position") && label->isVisible())
                return label->text();
        return {};
    }

    FrameClock clock;
};

TEST_F(FrameClockTest, AWindowThatNobodySeesTakesFewFrames)
{
    bus().startThread(1ms);
    EXPECT_GT(share(), 0.5);
    window().hide();
    EXPECT_LT(share(), 0.5);
    window().show();
    EXPECT_GT(share(), 0.5);
}

TEST_F(FrameClockTest, AJobIsNotKeptWaiting)
{
    bus().startThread(1ms);
    window().hide();
    ASSERT_TRUE(bus().encoder(fraba)->start(ReadParameters{{Parameter::steps}}, Pace::byHand));
    EXPECT_TRUE(window().hasJob());
    EXPECT_GT(share(), 0.5);
    bus().encoder(fraba)->cancel(OnCancel::runWithWhatItHas);
    EXPECT_TRUE(QTest::qWaitFor([this] { return !window().hasJob(); }, atMost));
}

TEST_F(FrameClockTest, NewPositionsLayNothingOutAnew)
{
    clock.stop();
    shown->controls().setSpeed(fraba.node, 300);
    advance(500);
    const test::EventsSeen layouts(QEvent::LayoutRequest);
    advance(500);
    EXPECT_EQ(layouts.text(), QString());
}

TEST_F(FrameClockTest, WhatComesInSightIsOfNow)
{
    window().hide();
    QTest::qWait(50); // a frame is left out
    shown->controls().turnTo(fraba.node, 1'234);
    advance(0);
    window().show();
    QCoreApplication::processEvents();
    EXPECT_EQ(rawPosition(), QStringLiteral("1234"));
}

} // namespace
} // namespace codewheel
