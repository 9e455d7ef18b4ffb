// SPDX-License-Identifier: GPL-3.0-or-later
// What a trainer does to the simulated CAN bus, by the panel Training.
#include "kinds/canopen/simulator/can_training_acts.h"
#include "kinds/canopen/simulator/node_quirks.h"
#include "tests/app/kinds/canopen/canopen_window_test.h"
#include "widgets/kinds/canopen/training/can_training_panel.h"
#include "widgets/messages/message_model.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::nodeFive;

constexpr std::size_t withoutNumber = 3;

class CanopenTraining : public test::CanopenWindowTest
{
protected:
    CanopenTraining()
    {
        canActions().training->trigger();
        window().findChild<QDockWidget *>(QStringLiteral("trainingDock"))->raise();
        advance(1'500);
        tree().choose(nodeFive);
        advance(50);
    }

    CanTrainingPanel &panel() { return *window().findChild<CanTrainingPanel *>(); }
    QComboBox &devices() { return control<QComboBox>("Device to train with"); }
    void chooseDevice(const QString &name)
    {
        ASSERT_GE(devices().findText(name), 0) << name.toStdString();
        devices().setCurrentText(name);
        advance(50);
    }
    template <typename Control>
    Control &control(const char *accessibleName)
    {
        for (auto *found : panel().findChildren<Control *>())
            if (found->accessibleName() == QLatin1String(accessibleName) && found->isVisibleTo(&panel()))
                return *found;
        ADD_FAILURE() << accessibleName;
        std::abort();
    }
    template <typename Button>
    void click(const char *text)
    {
        for (auto *found : panel().findChildren<Button *>())
            if (found->text() == QLatin1String(text) && found->isVisibleTo(&panel())) {
                EXPECT_FALSE(found->toolTip().isEmpty()) << text;
                found->click();
                advance(50);
                return;
            }
        ADD_FAILURE() << text;
    }
    void tick(const char *text) { click<QCheckBox>(text); }
    template <typename Field, typename Value>
    void enter(const char *accessibleName, Value value)
    {
        auto &field = control<Field>(accessibleName);
        field.setFocus();
        field.setValue(value);
        advance(50);
    }
    bool isTold(const char *text)
    {
        MessageModel &model = shown->messages();
        model.catchUp();
        for (int row = 0; row < model.rowCount(); ++row)
            for (int column = 0; column < model.columnCount(); ++column)
                if (model.index(row, column).data().toString().contains(QLatin1String(text)))
                    return true;
        return false;
    }
    std::int64_t rawOf(std::size_t which)
    {
        return canBus().training()->withEncoder(
            which, [](const canopen::SimulatedNode &node) { return node.shaft().raw(); });
    }
    const CanopenSnapshot &now() { return session().latest(); }
};

TEST_F(CanopenTraining, AShaftIsTurnedStoppedAndSet)
{
    const auto before = rawOf(0);
    enter<QDoubleSpinBox>("Speed in revolutions per minute", 6.0);
    advance(950);
    EXPECT_NEAR(static_cast<double>(rawOf(0) - before), 819.2, 82); // a tenth of its turn
    control<QToolButton>("Stop the shaft").click();
    advance(50);
    const auto stopped = rawOf(0);
    advance(500);
    EXPECT_EQ(rawOf(0), stopped);
    EXPECT_TRUE(isTold("Shaft turns at 6.0 rpm."));
    EXPECT_TRUE(isTold("Shaft stopped."));
    auto &target = control<QSpinBox>("Raw position to turn to");
    target.setValue(1'234);
    QTest::keyClick(&target, Qt::Key_Return);
    advance(200);
    EXPECT_EQ(rawOf(0), 1'234);
    EXPECT_TRUE(isTold("Shaft turned to raw position 1234."));
    EXPECT_EQ(session().encoder(nodeFive)->latest().position, 1'234);
}

TEST_F(CanopenTraining, AnEncoderWithoutPowerIsSilentAndBootsOnceItIsBack)
{
    chooseDevice(QStringLiteral("can:6"));
    tick("Power on");
    advance(5'000);
    EXPECT_EQ(now().heard(6)->heartbeat, canopen::Heartbeat::lost);
    EXPECT_EQ(devices().currentText(), QStringLiteral("can:6")) << "it keeps its number";
    const int bootUps = now().heard(6)->bootUps;
    tick("Power on");
    advance(1'000);
    EXPECT_EQ(now().heard(6)->bootUps, bootUps + 1);
    EXPECT_TRUE(isTold("Power on: no."));
}

TEST_F(CanopenTraining, AnAlarmIsToldByItsNode)
{
    tick("Position error");
    advance(500);
    ASSERT_TRUE(now().heard(5)->error);
    EXPECT_EQ(now().heard(5)->error->code, 0x5000);
    EXPECT_TRUE(isTold("Position error: yes."));
}

TEST_F(CanopenTraining, EachQuirkOfTheSimulatorCanBeGiven)
{
    chooseDevice(QStringLiteral("can:6"));
    for (const canopen::NamedQuirk &quirk : canopen::namedQuirks()) {
        const QString name = nodeQuirkName(quirk.key);
        ASSERT_FALSE(name.isEmpty()) << quirk.key;
        tick(qPrintable(name));
        EXPECT_TRUE(canBus().training()->withEncoder(1, [&](const canopen::SimulatedNode &node) {
            return quirk.isIn(node.quirks());
        })) << quirk.key;
        tick(qPrintable(name));
    }
}

TEST_F(CanopenTraining, WithAQuirkAnEncoderBeginsAnew)
{
    actions().watch->trigger();
    advance(200);
    const int bootUps = now().heard(5)->bootUps;
    tick("Starts by itself");
    advance(1'000);
    EXPECT_EQ(now().heard(5)->bootUps, bootUps + 1);
    EXPECT_EQ(now().heard(5)->state, canopen::NmtState::operational);
}

TEST_F(CanopenTraining, WhatHasNoNumberIsMovedTooAndFollowedToItsNumber)
{
    chooseDevice(QStringLiteral("Without a number"));
    auto &target = control<QSpinBox>("Raw position to turn to");
    target.setValue(77);
    QTest::keyClick(&target, Qt::Key_Return);
    advance(100);
    EXPECT_EQ(rawOf(withoutNumber), 77);
    for (std::size_t other = 0; other < withoutNumber; ++other)
        canBus().training()->withEncoder(other, [](canopen::SimulatedNode &node) { node.setOn(false); });
    for (const std::array<std::uint8_t, 2> request :
         {std::array<std::uint8_t, 2>{0x04, 1}, {0x11, 9}, {0x04, 0}}) {
        CanFrame frame{.id = 0x7E5, .length = 8};
        std::ranges::copy(request, frame.bytes.begin());
        session().send(frame);
        advance(100);
    }
    EXPECT_EQ(devices().currentText(), QStringLiteral("can:9"));
}

TEST_F(CanopenTraining, TheBusLosesDestroysAndDoublesFrames)
{
    chooseDevice(QStringLiteral("CAN bus"));
    enter<QSpinBox>("Destroyed frames, of 1000", 300);
    enter<QSpinBox>("Lost frames, of 1000", 20);
    const CanBusFaults faults = canBus().training()->bus()->faults();
    EXPECT_EQ(faults.damaged, 300);
    EXPECT_EQ(faults.lost, 20);
    EXPECT_EQ(control<QSpinBox>("Doubled frames, of 1000").maximum(), 999);
    const auto before = now().figures.errorFrames;
    advance(1'000);
    EXPECT_GT(now().figures.errorFrames, before);
    EXPECT_TRUE(isTold("Destroyed frames: 300 of 1000."));
}

TEST_F(CanopenTraining, OtherDevicesTakeTheirPartOfTheBus)
{
    chooseDevice(QStringLiteral("CAN bus"));
    const double before = now().figures.load;
    enter<QSpinBox>("Load by other devices, in percent", 40);
    advance(2'000);
    EXPECT_NEAR(now().figures.load, before + 0.4, 0.1);
    EXPECT_TRUE(isTold("Load by other devices: 40 %."));
    EXPECT_EQ(control<QSpinBox>("Load by other devices, in percent").maximum(), 95);
}

TEST_F(CanopenTraining, AnotherMasterComesAndIsNamed)
{
    chooseDevice(QStringLiteral("CAN bus"));
    ASSERT_FALSE(now().otherMaster.isHeard());
    tick("Another master");
    EXPECT_TRUE(isTold("Another master is on the bus."));
    EXPECT_TRUE(comes([this] { return now().isHeldBack(); })) << "nothing is sent before the user agrees";
    tick("Another master");
    EXPECT_TRUE(isTold("The other master is gone."));
    EXPECT_FALSE(canBus().training()->background().hasMaster);
}

TEST_F(CanopenTraining, AloneNobodyAcknowledgesItsAdapter)
{
    chooseDevice(QStringLiteral("CAN bus"));
    tick("Adapter alone");
    advance(3'000);
    EXPECT_EQ(now().status.state, CanState::passive);
    tick("Adapter alone");
    advance(5'000);
    EXPECT_NE(now().status.state, CanState::passive);
}

TEST_F(CanopenTraining, AnAdapterGoesBusOffAndComesBack)
{
    chooseDevice(QStringLiteral("CAN bus"));
    click<QPushButton>("Bus off");
    advance(50);
    EXPECT_TRUE(isTold("The adapter went bus off."));
    EXPECT_FALSE(now().connected);
    advance(10'000);
    EXPECT_TRUE(now().connected);
}

TEST_F(CanopenTraining, ItBeginsAfresh)
{
    tick("Position error");
    chooseDevice(QStringLiteral("CAN bus"));
    enter<QSpinBox>("Lost frames, of 1000", 20);
    enter<QSpinBox>("Load by other devices, in percent", 5);
    for (auto *button : panel().findChildren<QPushButton *>(QStringLiteral("startAfresh")))
        button->click();
    advance(1'500);
    chooseDevice(QStringLiteral("CAN bus"));
    EXPECT_EQ(canBus().training()->bus()->faults(), CanBusFaults{});
    EXPECT_EQ(control<QSpinBox>("Lost frames, of 1000").value(), 0);
    EXPECT_EQ(control<QSpinBox>("Load by other devices, in percent").value(), 0);
    EXPECT_EQ(
        canBus().training()->withEncoder(0, [](const canopen::SimulatedNode &node) { return node.alarms(); }),
        0);
}

} // namespace
} // namespace codewheel
