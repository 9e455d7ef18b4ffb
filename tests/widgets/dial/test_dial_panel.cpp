// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/training_bus_session.h"
#include "widgets/dial/code_disc.h"
#include "widgets/dial/dial_panel.h"

#include <QCoreApplication>
#include <QPushButton>
#include <QTest>

#include <cmath>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;
using namespace std::chrono_literals;

class DialPanelTest : public testing::Test
{
protected:
    DialPanelTest()
    {
        panel.resize(280, 360);
        panel.show();
    }

    const DialState &shown() { return panel.findChild<CodeDisc *>()->state(); }
    QPushButton &readButton() // the shaft's: the rod has one, too
    {
        QCoreApplication::processEvents(); // laid out, to be clicked
        return *panel.findChild<CodeDisc *>()->parentWidget()->findChild<QPushButton *>(
            QStringLiteral("readMissing"));
    }
    void advance(int milliseconds)
    {
        for (; milliseconds > 0; milliseconds -= 33)
            ring.bus.advance(33);
    }
    void tellBaumer(std::int64_t coding)
    {
        EncoderSession &encoder = ring.encoder(baumer);
        encoder.tell(Parameter::coding, coding);
        encoder.tell(Parameter::steps, 8192);
        encoder.tell(Parameter::revolutions, 1);
        encoder.tell(Parameter::measuringRange, 4096);
    }

    test::TrainingBusSession ring;
    DialPanel panel;
};

TEST_F(DialPanelTest, WithoutAnEncoderItSaysWhatBelongsThere)
{
    EXPECT_FALSE(panel.findChild<CodeDisc *>()->isVisible());
}

TEST_F(DialPanelTest, APositionWithoutItsScaleIsANumberAndADiscThatStands)
{
    ring.encoder(fraba).tell(Parameter::startUpMode, 1);
    panel.setEncoder(&ring.encoder(fraba));
    advance(66);
    EXPECT_EQ(shown().position, 12345);
    EXPECT_EQ(shown().turnFraction, std::nullopt);
    EXPECT_TRUE(shown().note.contains(QStringLiteral("Steps")));
    EXPECT_EQ(ring.channel(fraba).out(), 0u) << "looking sends nothing";
}

TEST_F(DialPanelTest, APositionOnlyEncoderTurnsTheDiscAtOnce)
{
    ring.controls->setSpeed(test::singleTurn.node, 0);
    ring.controls->turnTo(test::singleTurn.node, 1024);
    ring.controls->setSpeed(test::multiTurn.node, 0);
    ring.controls->turnTo(test::multiTurn.node, 3 * 4096 + 2048);
    panel.setEncoder(&ring.encoder(test::singleTurn));
    advance(66);
    EXPECT_EQ(shown().position, 1024);
    EXPECT_EQ(shown().turnFraction, 0.25);
    EXPECT_EQ(shown().turn, std::nullopt) << "it counts no turns";
    EXPECT_EQ(shown().note, QString());
    EXPECT_FALSE(readButton().isVisible());
    panel.setEncoder(&ring.encoder(test::multiTurn));
    advance(66);
    EXPECT_EQ(shown().turnFraction, 0.5);
    EXPECT_EQ(shown().turn, 3);
}

TEST_F(DialPanelTest, TheSpeedOfAPositionOnlyEncoderIsShown)
{
    panel.setEncoder(&ring.encoder(test::multiTurn));
    advance(2000);
    ASSERT_TRUE(shown().rpm);
    EXPECT_NEAR(*shown().rpm, -6, 0.2);
}

TEST_F(DialPanelTest, ACodingThatIsNotPlainIsNamed)
{
    panel.setEncoder(&ring.encoder(baumer));
    tellBaumer(5);
    advance(66);
    EXPECT_EQ(shown().note, QStringLiteral("The position comes in Gray code."));
    tellBaumer(2);
    advance(66);
    EXPECT_EQ(shown().note, QStringLiteral("The position is signed."));
    tellBaumer(3);
    advance(66);
    EXPECT_EQ(shown().note, QString());
}

TEST_F(DialPanelTest, ReadingOnRequestMakesItTurn)
{
    ring.encoder(fraba).tell(Parameter::startUpMode, 1);
    panel.setEncoder(&ring.encoder(fraba));
    advance(66);
    ASSERT_TRUE(readButton().isVisible());
    QCoreApplication::processEvents(); // for the layout
    QTest::mouseClick(&readButton(), Qt::LeftButton);
    advance(1000);
    EXPECT_FALSE(readButton().isVisible());
    ASSERT_TRUE(shown().turnFraction) << shown().note.toStdString();
    EXPECT_NEAR(*shown().turnFraction, 12345.0 / 8192 - 1, 1e-9);
    EXPECT_EQ(shown().turn, 1);
    EXPECT_NEAR(shown().rpm.value_or(99), 0, 1e-9);
    EXPECT_TRUE(shown().note.isEmpty());
}

TEST_F(DialPanelTest, WithoutTheCodingThereIsNoPositionButTheRawWord)
{
    panel.setEncoder(&ring.encoder(baumer));
    advance(66);
    EXPECT_EQ(shown().position, std::nullopt);
    EXPECT_TRUE(shown().note.contains(QStringLiteral("coding")));
    EXPECT_FALSE(readButton().isVisible()) << "a Baumer cannot be read";
}

TEST_F(DialPanelTest, SpeedIsClockwisePositiveWhateverTheCounting)
{
    tellBaumer(3);
    panel.setEncoder(&ring.encoder(baumer));
    advance(1000);
    EXPECT_NEAR(shown().rpm.value_or(0), 10, 0.1);
    ASSERT_TRUE(
        ring.encoder(baumer).start(WriteParameters{.values = {{Parameter::coding, 4}}, .previous = {}}));
    advance(2000);
    ASSERT_TRUE(shown().rpm);
    EXPECT_NEAR(*shown().rpm, 10, 0.1);
}

// FRABA manual 5.4.2
TEST_F(DialPanelTest, InVelocityModeItShowsRevolutionsPerMinuteAndNoPosition)
{
    EncoderSession &encoder = ring.encoder(fraba);
    encoder.tell(Parameter::startUpMode, 1);
    panel.setEncoder(&encoder);
    ring.controls->setSpeed(fraba.node, -150);
    ASSERT_TRUE(encoder.start(SwitchMode{Mode::velocity}));
    advance(200);
    EXPECT_EQ(shown().velocity, -150);
    EXPECT_EQ(shown().position, std::nullopt);
    EXPECT_EQ(shown().rpm, std::nullopt) << "which way is not known";
    EXPECT_EQ(shown().note, QStringLiteral("No position while the encoder sends its velocity."));
    encoder.tell(Parameter::direction, 4); // CCW: positions rise counter-clockwise
    advance(66);
    EXPECT_EQ(shown().rpm, 150);
    EXPECT_TRUE(panel.findChild<CodeDisc *>()->valueText().startsWith(QStringLiteral("Velocity -150 rpm")));
}

TEST_F(DialPanelTest, ParameterizationHasNoPosition)
{
    tellBaumer(3);
    panel.setEncoder(&ring.encoder(baumer));
    ring.channel(baumer).stage(0x0200'2000);
    ASSERT_TRUE(ring.channel(baumer).write());
    advance(66);
    EXPECT_EQ(shown().position, std::nullopt);
    EXPECT_EQ(shown().role, Role::attention);
}

TEST_F(DialPanelTest, ASpeedThatIsSetIsReadToTheTenth)
{
    ring.controls->setSpeed(test::multiTurn.node, 60);
    panel.setEncoder(&ring.encoder(test::multiTurn));
    advance(1000);
    for (int frame = 0; frame < 100; ++frame) {
        advance(33);
        ASSERT_TRUE(shown().rpm);
        ASSERT_EQ(std::lround(*shown().rpm * 10), 600);
    }
    ring.controls->setSpeed(test::singleTurn.node, 6000);
    panel.setEncoder(&ring.encoder(test::singleTurn));
    advance(1000);
    EXPECT_NEAR(shown().rpm.value_or(0), 6000, 0.05) << "three turns in each frame";
}

TEST_F(DialPanelTest, OneThatIsCutOffShowsWhereItWas)
{
    ring.controls->setSpeed(test::multiTurn.node, 0);
    panel.setEncoder(&ring.encoder(test::multiTurn));
    advance(100);
    const auto before = shown().position;
    ASSERT_TRUE(before);
    ring.controls->setFault(TrainingFault::wireBreak, test::multiTurn.node, 1);
    advance(500);
    EXPECT_EQ(shown().position, before);
    EXPECT_TRUE(shown().isLastKnown);
    EXPECT_FALSE(shown().age.isEmpty());
    EXPECT_EQ(shown().note, QStringLiteral("Not up to date: The device is not on the bus."));
}

TEST_F(DialPanelTest, WhatIsOldHasNoSpeed)
{
    ring.controls->setSpeed(test::multiTurn.node, 60);
    panel.setEncoder(&ring.encoder(test::multiTurn));
    advance(1000);
    ASSERT_TRUE(shown().rpm);
    ring.bus.alarmStop();
    advance(33);
    EXPECT_EQ(shown().rpm, std::nullopt);
    EXPECT_EQ(ring.encoder(test::multiTurn).latest().stepsPerSecond, std::nullopt);
}

} // namespace
} // namespace codewheel
