// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/resolution.h"
#include "widgets/dial/rod_view.h"
#include "widgets/look/fonts.h"

#include <QAccessible>
#include <QFontMetrics>
#include <QImage>
#include <QLocale>
#include <QPoint>
#include <QPointF>
#include <QRgb>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

// LA-66 manual 3.2: a 500 mm rod at 0.01 mm.
RodState manualRod(qint64 position)
{
    RodState state;
    state.position = position;
    state.length = 50'000;
    state.scale = RodScale{.steps = 50'000, .micrometres = 500'000};
    state.countsUpToTheEnd = true;
    return state;
}

class Rod : public testing::Test
{
protected:
    Rod()
    {
        rod.resize(rod.sizeHint());
        rod.setLocale(QLocale::c());
        rod.show();
    }

    QString said() const
    {
        return QAccessible::queryAccessibleInterface(&rod)->text(QAccessible::Description);
    }
    // Whether the magnet is visible at this place; looks beside its line, above the rod.
    bool isMagnetAt(double place) const
    {
        const QPoint at = (rod.picture().magnetAt(place) + QPointF(3, -8)).toPoint();
        return rod.grab().toImage().pixel(at) == roleColor(Role::running, rod.palette()).rgb();
    }

    mutable RodView rod;
};

TEST_F(Rod, TheMagnetStandsWhereItIs)
{
    for (const double place : {0.0, 0.25, 0.5, 1.0}) {
        RodState state = manualRod(qRound64(place * 50'000));
        state.role = Role::running;
        rod.setState(state);
        for (const double other : {0.0, 0.25, 0.5, 1.0})
            EXPECT_EQ(isMagnetAt(other), other == place) << "magnet at " << place << ", looked at " << other;
    }
}

TEST_F(Rod, CountingDownItStandsAsFarFromTheEnd)
{
    RodState state = manualRod(12'500);
    state.countsUpToTheEnd = false;
    state.role = Role::running;
    rod.setState(state);
    EXPECT_TRUE(isMagnetAt(0.75));
    EXPECT_FALSE(isMagnetAt(0.25));
}

TEST_F(Rod, APositionBesideTheRodOrOfAnUnknownDirectionHasNoPlace)
{
    EXPECT_EQ(magnetPlace(manualRod(50'001)), std::nullopt);
    EXPECT_EQ(magnetPlace(manualRod(0xFF'FFFF)), std::nullopt);
    EXPECT_EQ(magnetPlace(manualRod(50'000)), 1.0);
    RodState state = manualRod(1);
    state.countsUpToTheEnd = {};
    EXPECT_EQ(magnetPlace(state), std::nullopt);
    state = manualRod(1);
    state.length = {};
    EXPECT_EQ(magnetPlace(state), std::nullopt);
}

TEST_F(Rod, SaysInWordsWhatItShows)
{
    rod.setPlace(QStringLiteral("5.0"));
    EXPECT_EQ(QAccessible::queryAccessibleInterface(&rod)->text(QAccessible::Name),
              QStringLiteral("Rod of 5.0"));
    RodState state = manualRod(12'345);
    state.stepsPerSecond = -1'250;
    rod.setState(state);
    EXPECT_EQ(said(), QStringLiteral("Position 12345 steps, 123.45 mm, measuring length 50000 steps, 12.5 "
                                     "mm/s to the head, 0.010 mm per step"));
    state.countsUpToTheEnd = false;
    rod.setState(state);
    EXPECT_TRUE(said().contains(QStringLiteral("12.5 mm/s to the end"))) << said().toStdString();
}

TEST_F(Rod, WithoutTheLengthOfTheRodThereAreStepsAndNoMillimetres)
{
    RodState state = manualRod(12'345);
    state.scale = {};
    state.stepsPerSecond = 100;
    state.note = QStringLiteral("Tell it.");
    rod.setState(state);
    EXPECT_EQ(said(),
              QStringLiteral("Position 12345 steps, mm not known, measuring length 50000 steps, 100.0 "
                             "steps/s to the end, Tell it."));
}

TEST_F(Rod, TheLastPositionBeforeTheMagnetWasLostLooksAndSoundsLikeOne)
{
    RodState state = manualRod(12'500);
    state.role = Role::running;
    rod.setState(state);
    ASSERT_TRUE(isMagnetAt(0.25));
    state.isLastKnown = true;
    rod.setState(state);
    EXPECT_FALSE(isMagnetAt(0.25));
    EXPECT_TRUE(said().startsWith(QStringLiteral("Last position 12500 steps"))) << said().toStdString();
}

TEST_F(Rod, WhereItIsNarrowThePositionIsWholeAndItsUnitGivesWay)
{
    const QFontMetrics metrics(numberFont(TextSize::large));
    rod.resize(metrics.horizontalAdvance(QStringLiteral("16777215")) + 8, rod.height());
    rod.setState(manualRod(0xFF'FFFF));
    const QImage image = rod.grab().toImage();
    const QRgb ground = image.pixel(0, 0);
    const int top = rod.picture().space().bottom() + 1;
    for (int y = top; y < top + metrics.height(); ++y) {
        EXPECT_EQ(image.pixel(0, y), ground) << y;
        EXPECT_EQ(image.pixel(image.width() - 1, y), ground) << y;
    }
    EXPECT_TRUE(said().startsWith(QStringLiteral("Position 16777215 steps"))) << said().toStdString();
}

TEST_F(Rod, WithoutAPositionItSaysHowToGetOne)
{
    EXPECT_EQ(said(),
              QStringLiteral("No position yet. Start the bus and choose an encoder in the bus structure."));
}

TEST(Resolution, IsToldAsFineAsItIs)
{
    EXPECT_EQ(resolution(0.01), QStringLiteral("0.010 mm per step"));
    EXPECT_EQ(resolution(500.0 / 30'000), QStringLiteral("0.016667 mm per step"));
    EXPECT_EQ(resolution(0.0025), QStringLiteral("0.0025 mm per step"));
    EXPECT_NEAR(RodScale({.steps = 5000, .micrometres = 500'000}).millimetres(1), 0.1, 1e-12);
}

} // namespace
} // namespace codewheel
