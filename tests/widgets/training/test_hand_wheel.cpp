// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/training/hand_wheel.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDial>
#include <QPoint>
#include <QTest>
#include <QWheelEvent>

#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

class HandWheelTest : public testing::Test
{
protected:
    HandWheelTest()
    {
        wheel.setStepsPerTurn(8192);
        wheel.resize(220, 90);
        wheel.show();
        QObject::connect(&wheel, &HandWheel::turned, &wheel,
                         [this](qint64 steps) { turned.push_back(steps); });
    }
    QDial &dial() { return *wheel.findChild<QDial *>(); }
    void click(const char *name)
    {
        for (QAbstractButton *button : wheel.findChildren<QAbstractButton *>())
            if (button->accessibleName() == QLatin1String(name))
                return QTest::mouseClick(button, Qt::LeftButton);
        ADD_FAILURE() << "no " << name;
    }

    HandWheel wheel;
    std::vector<qint64> turned;
};

TEST_F(HandWheelTest, ButtonsTurnByExactSteps)
{
    click("1 step counter-clockwise");
    click("1 step clockwise");
    click("A quarter turn counter-clockwise");
    click("A quarter turn clockwise");
    click("1 turn counter-clockwise");
    click("1 turn clockwise");
    EXPECT_EQ(turned, (std::vector<qint64>{-1, 1, -2048, 2048, -8192, 8192}));
}

TEST_F(HandWheelTest, KeysTurnALittle)
{
    dial().setFocus();
    QTest::keyClick(&dial(), Qt::Key_Up);
    QTest::keyClick(&dial(), Qt::Key_PageDown);
    EXPECT_EQ(turned, (std::vector<qint64>{8, -1024}));
}

TEST_F(HandWheelTest, TheWheelOfAMouseTurnsNothingEvenAfterADrag)
{
    dial().setFocus();
    const QPoint middle = dial().rect().center();
    QWheelEvent notch(middle, dial().mapToGlobal(middle), {}, {0, -120}, {}, {}, {}, false);
    QApplication::sendEvent(&dial(), &notch);
    EXPECT_TRUE(turned.empty());
    EXPECT_FALSE(notch.isAccepted()) << "the panel scrolls";
}

TEST_F(HandWheelTest, ShowingTheShaftTurnsNothing)
{
    wheel.showRaw(8192 + 2048);
    EXPECT_EQ(dial().value(), 768); // a quarter past the top, which is 512
    EXPECT_TRUE(turned.empty());
}

TEST_F(HandWheelTest, DraggingOverTheTopGoesTheShortWay)
{
    wheel.showRaw(8191);
    const QPoint centre = dial().rect().center();
    QTest::mousePress(&dial(), Qt::LeftButton, {}, centre + QPoint(-2, -25));
    QTest::mouseMove(&dial(), centre + QPoint(12, -25));
    QTest::mouseRelease(&dial(), Qt::LeftButton, {}, centre + QPoint(12, -25));
    const qint64 sum = std::accumulate(turned.begin(), turned.end(), qint64{0});
    EXPECT_GT(sum, 0);
    EXPECT_LT(sum, 8192 / 4);
}

TEST_F(HandWheelTest, StaysInTheHandWhileItIsHeld)
{
    const QPoint right = dial().rect().center() + QPoint(25, 0);
    QTest::mousePress(&dial(), Qt::LeftButton, {}, right);
    const int held = dial().value();
    wheel.showRaw(0);
    EXPECT_EQ(dial().value(), held);
    QTest::mouseRelease(&dial(), Qt::LeftButton, {}, right);
    wheel.showRaw(0);
    EXPECT_EQ(dial().value(), 512);
}

} // namespace
} // namespace codewheel
