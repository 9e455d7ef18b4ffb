// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/places.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/kinds/interbus/training/training_panel.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLocale>
#include <QPoint>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class TrainingPanelTest : public testing::Test
{
protected:
    struct Act
    {
        Place number;
        QString what;
    };

    TrainingPanelTest()
    {
        panel.resize(240, 900);
        panel.show();
        panel.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&panel));
        QObject::connect(&panel, &TrainingPanel::acted, &panel,
                         [this](Place number, const TrainingAct &what) {
                             acts.push_back({number, trainingActText(what)});
                         });
        panel.setDevice(fraba);
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
            if (each->text() == QLatin1String(text) || each->accessibleName() == QLatin1String(text))
                return *each;
        ADD_FAILURE() << "no " << text;
        std::abort();
    }
    void click(const char *text)
    {
        auto &each = button<QAbstractButton>(text);
        QTest::mouseClick(&each, Qt::LeftButton, {}, QPoint(8, each.height() / 2));
    }
    void frame(int cycles = 33)
    {
        ring.bus.advance(cycles);
        panel.refresh();
    }
    TrainingControls::Shaft shaft(Place number) const
    {
        for (const auto &each : ring.controls->shafts())
            if (each.number == number.node)
                return each;
        ADD_FAILURE() << "no shaft";
        return {};
    }
    QString text(const char *name) const { return find<QLabel>(name).text(); }
    QString lastAct() const { return acts.empty() ? QString() : acts.back().what; }

    test::TrainingBusSession ring;
    TrainingPanel panel{ring.controls};
    std::vector<Act> acts;
};

TEST_F(TrainingPanelTest, NothingIsCutOffInANarrowDock)
{
    panel.resize(200, 400);
    EXPECT_LE(panel.widget()->width(), panel.viewport()->width());
}

TEST_F(TrainingPanelTest, ShowsHowTheEncoderStands)
{
    EXPECT_EQ(text("Raw position"), QLocale().toString(12345));
    EXPECT_EQ(text("Turn"), QStringLiteral("1"));
    EXPECT_EQ(text("EEPROM writes"), QStringLiteral("0"));
    EXPECT_TRUE(button<QCheckBox>("Power on").isChecked());
    EXPECT_FALSE(button<QCheckBox>("Slow confirmation").isChecked());
    EXPECT_TRUE(acts.empty());
}

TEST_F(TrainingPanelTest, OtherDeviceOtherFields)
{
    EXPECT_FALSE(button<QCheckBox>("Battery low").isVisible());
    auto &devices = find<QComboBox>("Device to train with");
    devices.setFocus();
    QTest::keyClick(&devices, Qt::Key_Down);
    EXPECT_TRUE(button<QCheckBox>("Battery low").isVisible());
    EXPECT_EQ(find<QDoubleSpinBox>("Speed in revolutions per minute").value(), 10);
    EXPECT_TRUE(acts.empty());
    panel.setDevice("7.0"_ring); // no such device: nothing changes
    EXPECT_EQ(devices.currentText(), QStringLiteral("2.0"));
}

TEST_F(TrainingPanelTest, TurnsByButtonsAndTellsOnceWhenTheShaftIsLeftAlone)
{
    click("1 step clockwise");
    click("A quarter turn clockwise");
    frame();
    EXPECT_EQ(shaft(fraba).raw, 12345 + 1 + 2048);
    EXPECT_EQ(text("Raw position"), QLocale().toString(14394));
    EXPECT_TRUE(acts.empty());
    for (int i = 0; i < 20; ++i)
        frame();
    ASSERT_EQ(acts.size(), 1U);
    EXPECT_EQ(acts[0].number, fraba);
    EXPECT_EQ(acts[0].what,
              QStringLiteral("Shaft turned by hand to raw position %1.").arg(QLocale().toString(14394)));
}

TEST_F(TrainingPanelTest, TellsOfTurningBeforeAnotherDeviceIsChosen)
{
    click("1 step clockwise");
    frame();
    panel.setDevice(baumer);
    ASSERT_EQ(acts.size(), 1U);
    EXPECT_EQ(acts[0].number, fraba);
}

TEST_F(TrainingPanelTest, ToWhatIsRefusedNothingTurns)
{
    auto &target = find<QSpinBox>("Raw position to turn to");
    target.setFocus();
    target.selectAll();
    QTest::keyClicks(&target, QStringLiteral("2.5"));
    find<QToolButton>("Turn to the raw position").click();
    frame();
    EXPECT_TRUE(acts.empty());
    EXPECT_EQ(target.text(), QStringLiteral("2.5")) << "to be corrected";
}

TEST_F(TrainingPanelTest, TurnsToAnExactPosition)
{
    auto &target = find<QSpinBox>("Raw position to turn to");
    EXPECT_EQ(target.maximum(), 8192 * 4096 - 1);
    target.setFocus();
    target.selectAll();
    QTest::keyClicks(&target, QStringLiteral("16384"));
    frame();
    EXPECT_EQ(shaft(fraba).raw, 12345); // not before Enter
    QTest::keyClick(&target, Qt::Key_Return);
    frame();
    EXPECT_EQ(shaft(fraba).raw, 16384);
    EXPECT_EQ(text("Turn"), QStringLiteral("2"));
    ASSERT_EQ(acts.size(), 1U);
    EXPECT_TRUE(lastAct().contains(QLocale().toString(16384)));

    target.setValue(5);
    click("Turn to the raw position");
    frame();
    EXPECT_EQ(shaft(fraba).raw, 5);
}

TEST_F(TrainingPanelTest, SetsTheSpeedAndStops)
{
    auto &speed = find<QDoubleSpinBox>("Speed in revolutions per minute");
    speed.setFocus();
    speed.selectAll();
    QTest::keyClicks(&speed, QStringLiteral("-120"));
    QTest::keyClick(&speed, Qt::Key_Return);
    frame();
    EXPECT_EQ(shaft(fraba).revolutionsPerMinute, -120);
    EXPECT_LT(shaft(fraba).raw, 12345);
    EXPECT_EQ(acts.size(), 1U);
    click("Stop the shaft");
    frame();
    EXPECT_EQ(shaft(fraba).revolutionsPerMinute, 0);
    EXPECT_EQ(lastAct(), QStringLiteral("Shaft stopped."));
}

TEST_F(TrainingPanelTest, ShowsASpeedSetElsewhereWithoutActing)
{
    ring.controls->setSpeed(fraba.node, 33);
    frame();
    EXPECT_EQ(find<QDoubleSpinBox>("Speed in revolutions per minute").value(), 33);
    EXPECT_TRUE(acts.empty());
}

TEST_F(TrainingPanelTest, KeepsWhatWasTypedUntilTheBusComesRound)
{
    auto &speed = find<QDoubleSpinBox>("Speed in revolutions per minute");
    speed.stepUp();
    panel.refresh(); // no cycle yet
    EXPECT_EQ(speed.value(), 10);
    speed.stepUp();
    frame();
    EXPECT_EQ(shaft(fraba).revolutionsPerMinute, 20);
}

TEST_F(TrainingPanelTest, SwitchesThePower)
{
    click("Power on");
    frame();
    EXPECT_FALSE(shaft(fraba).powered);
    EXPECT_EQ(lastAct(), QStringLiteral("Power off."));
    button<QCheckBox>("Power on").setFocus();
    QTest::keyClick(&button<QCheckBox>("Power on"), Qt::Key_Space);
    frame();
    EXPECT_TRUE(shaft(fraba).powered);
}

TEST_F(TrainingPanelTest, ShowsAPowerCycle)
{
    click("Power off and on");
    frame(10);
    EXPECT_FALSE(button<QCheckBox>("Power on").isChecked());
    frame(100);
    EXPECT_TRUE(button<QCheckBox>("Power on").isChecked());
    EXPECT_EQ(acts.size(), 1U);
}

TEST_F(TrainingPanelTest, CausesTroubles)
{
    click("Slow confirmation");
    frame();
    EXPECT_TRUE(shaft(fraba).slow);
    click("Lose parameters");
    frame(200);
    EXPECT_EQ(ring.encoder(fraba).latest().state, EncoderState::error);
    EXPECT_EQ(lastAct(), QStringLiteral("Parameters lost."));

    panel.setDevice(baumer);
    click("Battery low");
    frame();
    EXPECT_TRUE(shaft(baumer).batteryLow);
    EXPECT_EQ(acts.back().number, baumer);
}

TEST_F(TrainingPanelTest, FaultsOnlyABaumerReportsAreOfferedThere)
{
    EXPECT_FALSE(button<QCheckBox>("EEPROM worn out").isVisible());
    EXPECT_FALSE(button<QCheckBox>("Code disc faulty").isVisible());
    panel.setDevice(baumer);
    click("EEPROM worn out");
    frame();
    EXPECT_TRUE(shaft(baumer).eepromWornOut);
    click("Code disc faulty");
    frame(20);
    EXPECT_EQ(ring.encoder(baumer).latest().errorNumber, 15U);
    click("Code disc faulty");
    frame();
    EXPECT_FALSE(shaft(baumer).codeDiscFaulty);
    EXPECT_EQ(lastAct(), QStringLiteral("Code disc in order; run ends the error."));
}

} // namespace
} // namespace codewheel
