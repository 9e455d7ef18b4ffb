// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/rod_bus.h"
#include "widgets/dial/code_disc.h"
#include "widgets/dial/dial_panel.h"
#include "widgets/dial/rod_view.h"

#include <QCoreApplication>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::rodPlace;

class RodDialTest : public testing::Test
{
protected:
    RodDialTest()
    {
        panel.resize(280, 420);
        panel.show();
        ring.controls->setMagnetSpeed(rodPlace.node, 0);
        advance(66);
        panel.setEncoder(&encoder());
    }

    EncoderSession &encoder() { return ring.encoder(rodPlace); }
    const RodState &shown() { return panel.findChild<RodView *>()->state(); }
    QPushButton &button(const char *name)
    {
        return *panel.findChild<QPushButton *>(QString::fromLatin1(name));
    }
    void advance(int milliseconds)
    {
        for (; milliseconds > 0; milliseconds -= 33)
            ring.bus.advance(33);
    }
    void knowAll()
    {
        encoder().start(ReadParameters{{Parameter::direction, Parameter::measuringLength}}).value();
        advance(1000);
        encoder().tell(Parameter::rodLength, 500'000);
    }

    test::TrainingBusSession ring{RingSession::Start::operating, test::makeRodBus};
    DialPanel panel;
};

TEST_F(RodDialTest, ARodIsShownAsARod)
{
    EXPECT_TRUE(panel.findChild<RodView *>()->isVisible());
    EXPECT_FALSE(panel.findChild<CodeDisc *>()->isVisible());
    panel.setEncoder(&ring.encoder(test::fraba));
    EXPECT_FALSE(panel.findChild<RodView *>()->isVisible());
    EXPECT_TRUE(panel.findChild<CodeDisc *>()->isVisible());
}

TEST_F(RodDialTest, WithoutItsScaleItIsANumberAndAMagnetThatIsNowhere)
{
    EXPECT_TRUE(shown().position);
    EXPECT_EQ(magnetPlace(shown()), std::nullopt);
    EXPECT_TRUE(shown().note.contains(QStringLiteral("Measuring length"))) << shown().note.toStdString();
    EXPECT_EQ(ring.channel(rodPlace).out(), 0u) << "looking sends nothing";
    auto &read = *panel.findChild<RodView *>()->parentWidget()->findChild<QPushButton *>(
        QStringLiteral("readMissing"));
    ASSERT_TRUE(read.isVisible());
    QCoreApplication::processEvents(); // laid out, to be clicked
    QTest::mouseClick(&read, Qt::LeftButton);
    advance(1000);
    EXPECT_FALSE(read.isVisible());
    EXPECT_TRUE(magnetPlace(shown()));
}

TEST_F(RodDialTest, TheLengthToldMakesStepsMillimetres)
{
    encoder().start(ReadParameters{{Parameter::direction, Parameter::measuringLength}}).value();
    advance(1000);
    encoder().tell(Parameter::rodLength, std::nullopt);
    EXPECT_EQ(shown().scale, std::nullopt);
    EXPECT_TRUE(shown().note.contains(QStringLiteral("rod length"))) << shown().note.toStdString();
    auto *field = panel.findChild<QLineEdit *>(parameterKey(Parameter::rodLength));
    ASSERT_TRUE(field->isVisible());
    QTest::keyClicks(field, QStringLiteral("500"));
    QTest::mouseClick(&button("tellRodLength"), Qt::LeftButton);
    EXPECT_FALSE(field->isVisible());
    ASSERT_TRUE(shown().length);
    EXPECT_EQ(shown().scale, (RodScale{.steps = *shown().length, .micrometres = 500'000}));
    EXPECT_TRUE(shown().note.isEmpty()) << shown().note.toStdString();
    EXPECT_EQ(ring.channel(rodPlace).out(), 0u) << "telling sends nothing";
}

TEST_F(RodDialTest, TheMagnetIsSeenWhereTheTrainerMovesIt)
{
    knowAll();
    const double length = ring.controls->rods().at(0).lengthMillimetres;
    ring.controls->moveMagnetTo(rodPlace.node, length / 4);
    advance(66);
    EXPECT_NEAR(magnetPlace(shown()).value_or(-1), 0.25, 0.001);
    ring.controls->setMagnetSpeed(rodPlace.node, 10);
    advance(1000);
    const double mmPerStep = length / static_cast<double>(*shown().length);
    EXPECT_NEAR(shown().stepsPerSecond.value_or(0) * mmPerStep * (*shown().countsUpToTheEnd ? 1 : -1), 10,
                0.5);
}

TEST_F(RodDialTest, AMagnetOutsideItsRangeIsNamedAndItsLastPlaceIsPale)
{
    knowAll();
    ring.controls->moveMagnetTo(rodPlace.node, 100);
    advance(66);
    const auto before = shown().position;
    ring.controls->setFault(TrainingFault::magnetLost, rodPlace.node, 1);
    advance(66);
    EXPECT_TRUE(shown().isLastKnown);
    EXPECT_EQ(shown().position, before);
    EXPECT_EQ(shown().role, Role::fault);
    EXPECT_TRUE(shown().note.contains(QStringLiteral("magnet is outside the measuring range")))
        << shown().note.toStdString();
    ring.controls->setFault(TrainingFault::magnetLost, rodPlace.node, 0);
    advance(66);
    ASSERT_TRUE(button("readErrorStatus").isVisible());
    QTest::mouseClick(&button("readErrorStatus"), Qt::LeftButton);
    advance(1000);
    EXPECT_FALSE(shown().isLastKnown);
    EXPECT_FALSE(button("readErrorStatus").isVisible());
    EXPECT_TRUE(shown().note.isEmpty()) << shown().note.toStdString();
}

} // namespace
} // namespace codewheel
