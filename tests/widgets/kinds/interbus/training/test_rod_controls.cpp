// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/places.h"
#include "tests/widgets/rod_bus.h"
#include "widgets/kinds/interbus/training/training_panel.h"

#include <QCheckBox>
#include <QDial>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLocale>
#include <QPoint>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

constexpr Place k1 = "3.0"_ring;
using test::rodPlace;

// A ring with a single-turn encoder without parameters and a rod, which obeys at once.
class RodRing final : public TrainingControls
{
public:
    std::vector<Shaft> shafts() const override
    {
        return {{.number = k1.node, .stepsPerTurn = 4096, .turns = 1, .hasParameters = false}};
    }
    std::vector<Rod> rods() const override { return {rod}; }
    void turnTo(NodeId, std::int64_t) override {}
    void turnBy(NodeId, std::int64_t) override {}
    void setSpeed(NodeId, double) override {}
    void moveMagnetTo(NodeId, double millimetres) override { rod.millimetres = millimetres; }
    void setMagnetSpeed(NodeId, double speed) override { rod.millimetresPerSecond = speed; }
    void powerCycle(NodeId) override {}
    std::vector<TrainingPlace> places() const override { return {{k1.node, {}}, {rodPlace.node, {}}}; }
    void setFault(TrainingFault fault, NodeId number, int value) override
    {
        if (fault == TrainingFault::magnetLost)
            rod.magnetInRange = value == 0;
        else if (fault == TrainingFault::powerOff)
            rod.powered = number == rodPlace.node && value == 0;
    }
    void startFaultPlan(FaultPlan) override {}
    void stopFaultPlan() override {}
    PlanProgress planProgress() const override { return {}; }

    Rod rod{.number = rodPlace.node, .millimetres = 125, .lengthMillimetres = 500};
};

class RodControlsTest : public testing::Test
{
protected:
    RodControlsTest()
    {
        panel.resize(240, 900);
        panel.show();
        QObject::connect(&panel, &TrainingPanel::acted, &panel,
                         [this](Place number, const TrainingAct &what) {
                             EXPECT_EQ(number, rodPlace);
                             acts.append(trainingActText(what));
                         });
        panel.setDevice(rodPlace);
    }

    template <typename Widget>
    Widget &find(const char *name) const
    {
        for (Widget *widget : panel.findChildren<Widget *>())
            if (widget->accessibleName() == QLatin1String(name))
                return *widget;
        ADD_FAILURE() << "no " << name;
        std::abort();
    }
    template <typename Button>
    Button &button(const char *text) const
    {
        for (Button *each : panel.findChildren<Button *>())
            if (each->text() == QLatin1String(text))
                return *each;
        ADD_FAILURE() << "no " << text;
        std::abort();
    }
    void rest()
    {
        for (int frame = 0; frame < 15; ++frame)
            panel.refresh();
    }

    std::shared_ptr<RodRing> ring = std::make_shared<RodRing>();
    TrainingPanel panel{ring};
    QStringList acts;
};

TEST_F(RodControlsTest, OfEachDeviceOnlyWhatItHasIsThere)
{
    EXPECT_TRUE(find<QSlider>("Magnet on the rod").isVisible());
    EXPECT_TRUE(find<QLabel>("EEPROM writes").isVisible());
    EXPECT_FALSE(find<QDial>("Wheel").isVisible());
    EXPECT_FALSE(button<QCheckBox>("Slow confirmation").isVisible());
    EXPECT_FALSE(button<QPushButton>("Lose parameters").isVisible());
    panel.setDevice(k1);
    EXPECT_TRUE(find<QDial>("Wheel").isVisible());
    EXPECT_TRUE(button<QCheckBox>("Power on").isVisible());
    EXPECT_FALSE(find<QSlider>("Magnet on the rod").isVisible());
    EXPECT_FALSE(find<QLabel>("EEPROM writes").isVisible());
    EXPECT_FALSE(button<QCheckBox>("Slow confirmation").isVisible());
    EXPECT_FALSE(button<QPushButton>("Lose parameters").isVisible());
}

TEST_F(RodControlsTest, TheTrackMovesTheMagnetAndTellsOnceWhenItIsLeftAlone)
{
    auto &track = find<QSlider>("Magnet on the rod");
    track.setFocus();
    QTest::keyClick(&track, Qt::Key_Right);
    QTest::keyClick(&track, Qt::Key_PageUp);
    EXPECT_NEAR(ring->rod.millimetres, 125.0 + 0.1 + 10, 1e-9);
    EXPECT_TRUE(acts.empty());
    rest();
    EXPECT_EQ(find<QLabel>("Place of the magnet in mm").text(), QLocale().toString(135.1, 'f', 2));
    rest();
    ASSERT_EQ(acts.size(), 1);
    EXPECT_EQ(acts.front(),
              QStringLiteral("Magnet moved by hand to %1 mm.").arg(QLocale().toString(135.1, 'f', 2)));
}

TEST_F(RodControlsTest, TypedPlaceAndSpeedHoldAtEnter)
{
    auto &place = find<QDoubleSpinBox>("Place to move the magnet to, in mm");
    place.setFocus();
    place.selectAll();
    QTest::keyClicks(&place, QLocale().toString(250.25, 'f', 2));
    EXPECT_EQ(ring->rod.millimetres, 125);
    QTest::keyClick(&place, Qt::Key_Return);
    EXPECT_EQ(ring->rod.millimetres, 250.25);
    auto &speed = find<QDoubleSpinBox>("Speed in mm per second");
    speed.setFocus();
    speed.selectAll();
    QTest::keyClicks(&speed, QStringLiteral("-20"));
    QTest::keyClick(&speed, Qt::Key_Return);
    EXPECT_EQ(ring->rod.millimetresPerSecond, -20);
    QTest::mouseClick(&find<QToolButton>("Stop the magnet"), Qt::LeftButton);
    EXPECT_EQ(ring->rod.millimetresPerSecond, 0);
}

TEST_F(RodControlsTest, TakesTheMagnetOutOfItsRange)
{
    auto &inRange = button<QCheckBox>("Magnet in range");
    EXPECT_TRUE(inRange.isChecked());
    QTest::mouseClick(&inRange, Qt::LeftButton, {}, QPoint(8, inRange.height() / 2));
    EXPECT_FALSE(ring->rod.magnetInRange);
    EXPECT_EQ(acts, QStringList(QStringLiteral("Magnet outside the measuring range.")));
    ring->rod.magnetInRange = true; // by the command line
    panel.refresh();
    EXPECT_FALSE(inRange.isChecked()) << "what was ticked is not undone before the bus has come round";
    ring->rod.magnetInRange = false;
    panel.refresh();
    ring->rod.magnetInRange = true;
    panel.refresh();
    EXPECT_TRUE(inRange.isChecked());
}

TEST_F(RodControlsTest, NothingIsCutOffInANarrowDock)
{
    panel.resize(200, 400);
    EXPECT_LE(panel.widget()->width(), panel.viewport()->width());
}

} // namespace
} // namespace codewheel
