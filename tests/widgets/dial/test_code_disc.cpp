// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/events_seen.h"
#include "widgets/dial/code_disc.h"

#include <QAccessible>
#include <QCoreApplication>
#include <QEvent>
#include <QImage>
#include <QLocale>
#include <QPoint>
#include <QRect>
#include <QRgb>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

// The dial as painted, without the texts below it.
QImage dialOf(CodeDisc &disc)
{
    return disc.grab(QRect(0, 0, disc.width(), disc.width())).toImage();
}

QPoint towards(const CodeDisc &disc, double turnFraction, double share)
{
    const double angle = turnFraction * 2 * M_PI;
    const double radius = disc.width() / 2.0 * share;
    return {qRound(disc.width() / 2.0 + radius * std::sin(angle)),
            qRound(disc.width() / 2.0 - radius * std::cos(angle))};
}

class Dial : public testing::Test
{
protected:
    Dial()
    {
        disc.resize(disc.sizeHint());
        disc.show();
    }

    QString said() const
    {
        return QAccessible::queryAccessibleInterface(&disc)->text(QAccessible::Description);
    }

    mutable CodeDisc disc;
};

TEST_F(Dial, ThePointerStandsWhereTheShaftIs)
{
    const QRgb pointer = roleColor(Role::running, disc.palette()).rgb();
    for (const double turn : {0.0, 0.125, 0.25, 0.5, 0.75}) {
        disc.setState({.turnFraction = turn, .position = 1, .role = Role::running});
        const QImage dial = dialOf(disc);
        for (const double place : {0.0, 0.125, 0.25, 0.5, 0.75})
            EXPECT_EQ(dial.pixel(towards(disc, place, 0.88)) == pointer, place == turn)
                << "shaft at " << turn << ", looked at " << place;
    }
}

TEST_F(Dial, TheDiscTurnsWithTheShaft)
{
    disc.setState({.turnFraction = 0.0, .position = 0});
    const QImage atZero = dialOf(disc);
    disc.setState({.turnFraction = 0.5, .position = 0});
    const QImage atHalf = dialOf(disc);
    // The innermost track is dark on only one half of the disc.
    const auto rightIsDark = [&](const QImage &dial) {
        return qGray(dial.pixel(towards(disc, 0.25, 0.35))) < qGray(dial.pixel(towards(disc, 0.75, 0.35)));
    };
    EXPECT_NE(rightIsDark(atZero), rightIsDark(atHalf));
}

TEST_F(Dial, SpeedIsAnArcToTheSideItTurnsTo)
{
    const auto isDrawn = [this](double place) {
        return dialOf(disc).pixel(towards(disc, place, 0.975)) == disc.palette().windowText().color().rgb();
    };
    disc.setState({.turnFraction = 0.0, .rpm = 10.0});
    EXPECT_TRUE(isDrawn(0.06));
    EXPECT_FALSE(isDrawn(-0.06));
    disc.setState({.turnFraction = 0.0, .rpm = -10.0});
    EXPECT_FALSE(isDrawn(0.06));
    EXPECT_TRUE(isDrawn(-0.06));
}

TEST_F(Dial, SaysInWordsWhatItShows)
{
    disc.setPlace(QStringLiteral("1.0"));
    EXPECT_EQ(QAccessible::queryAccessibleInterface(&disc)->text(QAccessible::Name),
              QStringLiteral("Dial of 1.0"));
    disc.setLocale(QLocale::c());
    disc.setState({.turnFraction = 0.25, .position = 26623, .turn = 3, .rpm = -10.04});
    EXPECT_EQ(said(), QStringLiteral("Position 26623, turn 3, 90 degrees, 10.0 rpm ccw"));
    disc.setState({.position = 12345, .note = QStringLiteral("Steps per revolution are not known.")});
    EXPECT_EQ(said(), QStringLiteral("Position 12345, Steps per revolution are not known."));
}

TEST_F(Dial, WithoutAPositionItSaysHowToGetOne)
{
    EXPECT_EQ(said(),
              QStringLiteral("No position yet. Start the bus and choose an encoder in the bus structure."));
    const QImage unknown = disc.grab().toImage();
    disc.setState({.turnFraction = 0.0, .position = 0});
    EXPECT_NE(disc.grab().toImage(), unknown) << "unknown looks like 0";
}

TEST_F(Dial, StaysInPlaceWhenANoteComes)
{
    disc.setState({.turnFraction = 0.1, .position = 1});
    const QImage before = dialOf(disc);
    disc.setState({.turnFraction = 0.1, .position = 1, .note = QStringLiteral("Battery low.")});
    EXPECT_EQ(dialOf(disc), before);
}

TEST_F(Dial, TheSameStateAgainPaintsNothing)
{
    const DialState state{.turnFraction = 0.1, .position = 1, .turn = 2, .rpm = 3.0};
    disc.setState(state);
    QCoreApplication::processEvents();
    DialState alike = state;
    alike.rpm = 3.001;
    const test::EventsSeen paints(QEvent::Paint, disc);
    disc.setState(state);
    disc.setState(alike);
    QCoreApplication::processEvents();
    EXPECT_EQ(paints.count(), 0);
}

TEST_F(Dial, WhatWasPaintedBeforeDoesNotShowThrough)
{
    const DialState states[] = {{.turnFraction = 0.1, .position = 1, .turn = 2, .rpm = 3.0},
                                {.turnFraction = 0.1, .position = 1, .turn = 3, .rpm = 3.0},
                                {.turnFraction = 0.1, .position = 1, .turn = 3, .rpm = 300.0},
                                {.turnFraction = 0.1, .position = 1, .turn = 3}};
    for (const DialState &state : states) {
        disc.setState(state);
        CodeDisc fresh;
        fresh.resize(disc.size());
        fresh.setState(state);
        EXPECT_EQ(disc.grab().toImage(), fresh.grab().toImage());
    }
}

} // namespace
} // namespace codewheel
