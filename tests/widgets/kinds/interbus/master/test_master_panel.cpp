// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus_outline.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "tests/support/model_tester.h"
#include "tests/support/places.h"
#include "tests/support/scripted_link.h"
#include "tests/widgets/training_bus_session.h"
#include "vocabulary/refusal_text.h"
#include "widgets/kinds/interbus/master/led_row.h"
#include "widgets/kinds/interbus/master/master_panel.h"
#include "widgets/kinds/interbus/master/segment_model.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/role_label.h"
#include "widgets/structure/structure_model.h"

#include <QAbstractItemModel>
#include <QCoreApplication>
#include <QLabel>
#include <QModelIndex>
#include <QPoint>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::fraba;
const Place fourth = "4.0"_ring;

class MasterPanelTest : public testing::Test
{
protected:
    MasterPanelTest()
    {
        panel.resize(320, 900);
        panel.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&panel));
    }
    QString value(const char *name) const
    {
        for (const QLabel *label : panel.findChildren<QLabel *>())
            if (label->accessibleName() == QLatin1String(name))
                return label->text();
        ADD_FAILURE() << "no " << name;
        return {};
    }
    QPushButton &button(const QString &text) const
    {
        for (QPushButton *each : panel.findChildren<QPushButton *>())
            if (each->text() == text)
                return *each;
        ADD_FAILURE() << "no button " << text.toStdString();
        std::abort();
    }
    void cause(TrainingFault fault, Place place, int value = 1)
    {
        ring.controls->setFault(fault, place.node, value);
        ring.bus.advance(40);
    }
    InlineMessage &message() const { return *panel.findChild<InlineMessage *>(); }
    QTableView &table() const { return *panel.findChild<QTableView *>(); }

    test::TrainingBusSession ring;
    MasterPanel panel{ring.bus};
};

TEST_F(MasterPanelTest, ShowsNothingOfTheMasterOnceDisconnected)
{
    ring.bus.close();
    EXPECT_EQ(panel.findChild<RoleLabel *>()->word(), QStringLiteral("Not connected"));
    EXPECT_EQ(value("Stored configuration"), QStringLiteral("\u2013"));
    EXPECT_FALSE(table().isVisible());
    EXPECT_FALSE(button(QStringLiteral("Stop")).isEnabled());
}

TEST_F(MasterPanelTest, ShowsAHealthyMaster)
{
    EXPECT_EQ(panel.findChild<RoleLabel *>()->word(), QStringLiteral("Master RUN"));
    EXPECT_EQ(value("Fault"), QStringLiteral("none"));
    EXPECT_EQ(value("Stored configuration"), QStringLiteral("training.json"));
    EXPECT_EQ(value("Diagnostic status register"), QStringLiteral("00E0h"));
    EXPECT_FALSE(value("RUN is set").isEmpty());
    EXPECT_FALSE(value("BUS is not set").isEmpty());
    EXPECT_EQ(table().model()->rowCount(), 6);
}

TEST_F(MasterPanelTest, NamesAFaultAsBannerAndMessagesDo)
{
    QString told;
    QObject::connect(&ring.bus, &RingSession::messaged, &panel, [&](const Message &message) {
        if (message.id == RingMessageId::busFault)
            told = messageText(message);
    });
    StructureModel model;
    const test::ModelTester tester(model);
    model.addBus(ring.bus);
    cause(TrainingFault::wireBreak, fourth);
    const QString name = QStringLiteral("0D10 at outgoing remote bus of 3.0 (see IBS SYS FW G4 UM)");
    EXPECT_EQ(value("Fault"), name);
    EXPECT_EQ(value("Error code"), QStringLiteral("0D10h"));
    EXPECT_EQ(value("Diagnostic parameter"), QStringLiteral("0380h: outgoing remote bus of 3.0"));
    EXPECT_EQ(told, QStringLiteral("Bus fault: %1.").arg(name));
    const auto state = [&](const QModelIndex &row) {
        return row.siblingAtColumn(StructureModel::stateColumn).data().toString();
    };
    EXPECT_EQ(ring.bus.outline().faults().front().code, name);
    EXPECT_EQ(state(model.index(0, 0)), QStringLiteral("BUS FAIL"));
    EXPECT_EQ(state(model.indexOf("3.0"_ring)), QStringLiteral("fault"));
    EXPECT_EQ(state(model.indexOf(fourth)), QStringLiteral("cut off"));
    EXPECT_EQ(state(model.indexOf(fraba)), QStringLiteral("stopped"));
}

TEST_F(MasterPanelTest, SwitchesTheChosenSegmentByKey)
{
    table().setCurrentIndex(table().model()->index(5, 0));
    QPushButton &off = button(QStringLiteral("Switch segment 6 off"));
    off.setFocus();
    QTest::keyClick(&off, Qt::Key_Space);
    ring.bus.advance(5);
    EXPECT_TRUE(ring.bus.latest().devices[6].inRing) << "it is asked for";
    QTest::mouseClick(&button(QStringLiteral("Switch o&ff")), Qt::LeftButton);
    ring.bus.advance(5);
    EXPECT_FALSE(ring.bus.latest().devices[6].inRing);
    EXPECT_EQ(table().model()->index(5, SegmentModel::stateColumn).data().toString(), QStringLiteral("off"));
    QTest::mouseClick(&button(QStringLiteral("Switch segment 6 on")), Qt::LeftButton);
    ring.bus.advance(5);
    EXPECT_TRUE(ring.bus.latest().devices[6].inRing);
}

TEST_F(MasterPanelTest, ShowsAllColumnsOfTheSegmentsInANarrowPanel)
{
    panel.resize(360, 600);
    QCoreApplication::processEvents();
    EXPECT_LE(table().horizontalHeader()->length(), table().viewport()->width());
    for (int column = 0; column < table().model()->columnCount(); ++column)
        EXPECT_GE(table().columnWidth(column), table().horizontalHeader()->sectionSizeHint(column)) << column;
}

TEST_F(MasterPanelTest, NamesWhatGoesBeforeASegmentIsSwitchedOff)
{
    ring.channel(test::onLoop).stage(0x0200'00FF);
    ASSERT_TRUE(ring.channel(test::onLoop).write());
    ring.bus.advance(5);
    panel.toggleSegment(6);
    EXPECT_EQ(message().sentence(),
              QStringLiteral("Switch segment 6 off? Out of the data cycles go: 6.0 bus terminal, 6.1 FRABA "
                             "OCD-IB K3 Loop 2. The outputs of 1 devices go to 0. Not 0 now: OUT 6.1 is "
                             "020000FF."));
    QTest::mouseClick(&button(QStringLiteral("&Leave it on")), Qt::LeftButton);
    EXPECT_FALSE(message().isVisible());
    ring.bus.advance(5);
    EXPECT_TRUE(ring.bus.latest().devices[6].inRing);
    panel.toggleSegment(6);
    ring.bus.setOperate(false);
    ring.bus.advance(5);
    EXPECT_FALSE(message().isVisible()) << "nothing can be switched now";
}

TEST_F(MasterPanelTest, InWatchItSaysThatOperateIsNeeded)
{
    cause(TrainingFault::peripheralFault, fraba);
    cause(TrainingFault::peripheralFault, fraba, 0);
    ring.bus.setOperate(false);
    ring.bus.advance(5);
    bool asked = false;
    QObject::connect(&panel, &MasterPanel::readInRequested, &panel, [&] { asked = true; });
    table().setCurrentIndex(table().model()->index(5, 0));
    for (const char *text : {"Read in the ring", "Confirm diagnostics", "Switch segment 6 off"}) {
        QTest::mouseClick(&button(QLatin1String(text)), Qt::LeftButton);
        ring.bus.advance(5);
        EXPECT_TRUE(message().isVisible()) << text;
        EXPECT_EQ(message().sentence(),
                  QStringLiteral("Nothing was sent: the program only watches. Switch to Operate first."));
    }
    EXPECT_FALSE(asked);
    EXPECT_EQ(value("Fault"), QStringLiteral("0BB1 – peripheral fault at 1.0"));
    EXPECT_TRUE(ring.bus.latest().devices[6].inRing);
    ring.bus.setOperate(true);
    ring.bus.advance(5);
    EXPECT_FALSE(message().isVisible());
}

TEST_F(MasterPanelTest, ConfirmsPeripheralFaults)
{
    cause(TrainingFault::peripheralFault, fraba);
    EXPECT_EQ(value("Fault"), QStringLiteral("0BB1 – peripheral fault at 1.0"));
    cause(TrainingFault::peripheralFault, fraba, 0);
    EXPECT_EQ(value("Fault"), QStringLiteral("0BB1 – peripheral fault at 1.0"));
    QTest::mouseClick(&button(QStringLiteral("Confirm diagnostics")), Qt::LeftButton);
    ring.bus.advance(5);
    EXPECT_EQ(value("Fault"), QStringLiteral("none"));
}

TEST_F(MasterPanelTest, ShowsTheProgressOfReadingIn)
{
    auto *progress = panel.findChild<QProgressBar *>();
    bool asked = false;
    QObject::connect(&panel, &MasterPanel::readInRequested, &panel, [&] { asked = true; });
    QTest::mouseClick(&button(QStringLiteral("Read in the ring")), Qt::LeftButton);
    EXPECT_TRUE(asked);
    ring.bus.readIn();
    ring.bus.advance(3);
    EXPECT_TRUE(progress->isVisible());
    EXPECT_EQ(progress->value(), 3);
    EXPECT_EQ(progress->maximum(), 7);
    EXPECT_FALSE(button(QStringLiteral("Read in the ring")).isEnabled());
    ring.bus.advance(20);
    EXPECT_FALSE(progress->isVisible());
}

TEST_F(MasterPanelTest, CountsCrcErrorsWithAHistory)
{
    cause(TrainingFault::crcErrors, "2.0"_ring, 100);
    ring.bus.advance(1'000);
    const QAbstractItemModel &model = *table().model();
    EXPECT_GT(model.index(1, SegmentModel::crcColumn).data().toString().toInt(), 50);
    EXPECT_EQ(model.index(0, SegmentModel::crcColumn).data().toString(), QStringLiteral("0"));
    const QModelIndex history = model.index(1, SegmentModel::historyColumn);
    EXPECT_GT(history.data(SegmentModel::countsRole).toList().last().toInt(), 50);
    EXPECT_FALSE(history.data(Qt::AccessibleTextRole).toString().isEmpty());
}

TEST(ASegmentModel, KeepsTheRulesOfModels)
{
    test::TrainingBusSession ring;
    SegmentModel model;
    const test::ModelTester tester(model);
    model.show(ring.bus);
    ring.controls->setFault(TrainingFault::wireBreak, fourth.node, 1);
    ring.controls->setFault(TrainingFault::crcErrors, NodeId("1.0"), 50);
    ring.bus.advance(40);
    model.show(ring.bus);
    ring.bus.readIn();
    ring.bus.advance(40);
    model.show(ring.bus);
    EXPECT_EQ(model.rowCount(), 3);
}

TEST(TheLedsInTheDevicePanel, HaveNamesAndFollowTheMaster)
{
    test::TrainingBusSession ring;
    LedRow leds(ring.bus);
    leds.setPlace(fourth);
    EXPECT_EQ(leds.accessibleName(), QStringLiteral("LEDs: UL on, RC on, BA on, RBDA off"));
    ring.bus.setRunning(false);
    ring.bus.advance(2);
    EXPECT_EQ(leds.accessibleName(), QStringLiteral("LEDs: UL on, RC on, BA blinking, RBDA off"));
    ring.bus.setRunning(true);
    ring.bus.switchSegment(4, false);
    ring.bus.advance(2);
    EXPECT_EQ(leds.accessibleName(), QStringLiteral("LEDs: UL on, RC off, BA off, RBDA on"));
    EXPECT_EQ(leds.findChildren<RoleLabel *>().last()->word(), QStringLiteral("RBDA on"));
}

TEST(TheLedsInTheDevicePanel, AreNotKnownWhileTheLinkIsLost)
{
    const Catalog catalog = Catalog::builtIn();
    RingStructure structure = ScriptedLink::ringOf(1);
    structure.front().deviceKey = QStringLiteral("fraba-ocd-ib");
    auto link = std::make_unique<ScriptedLink>(structure);
    ScriptedLink &peer = *link;
    RingSession bus(std::move(link), catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2)));
    ASSERT_TRUE(bus.open(RingSession::Start::operating));
    bus.advance(10);
    LedRow leds(bus);
    leds.setPlace("1.0"_ring);
    EXPECT_EQ(leds.accessibleName(), QStringLiteral("LEDs: UL on, RC on, BA on, RBDA off"));
    peer.lose();
    bus.advance(100);
    ASSERT_EQ(bus.state(), BusState::lost);
    EXPECT_FALSE(leds.isHidden());
    EXPECT_EQ(leds.accessibleName(), QStringLiteral("LEDs: not known. The link is lost."));
    EXPECT_FALSE(leds.findChildren<RoleLabel *>().first()->word().contains(QStringLiteral("on")));
    StructureModel model;
    model.addBus(bus);
    EXPECT_FALSE(model.indexOf("1.0"_ring).data(Qt::ToolTipRole).toString().contains(QStringLiteral("LEDs")));
    peer.comeBack();
    bus.advance(2'000);
    EXPECT_EQ(leds.accessibleName(), QStringLiteral("LEDs: UL on, RC on, BA on, RBDA off"));
}

TEST(TheLedsInTheDevicePanel, AreNotShownForAnEncoderOnLoop2)
{
    test::TrainingBusSession ring;
    LedRow leds(ring.bus);
    leds.setPlace(fourth);
    EXPECT_FALSE(leds.isHidden());
    leds.setPlace("6.1"_ring);
    EXPECT_TRUE(leds.isHidden()) << "it has a single one, of another meaning";
    StructureModel model;
    model.addBus(ring.bus);
    const auto toolTip = [&](Place number) { return model.indexOf(number).data(Qt::ToolTipRole).toString(); };
    EXPECT_TRUE(toolTip(fourth).contains(QStringLiteral("LEDs: UL on")));
    EXPECT_FALSE(toolTip("6.1"_ring).contains(QStringLiteral("LEDs")));
}

TEST(TheLedsInTheDevicePanel, AreShownWhereTheDescriptionHasThem)
{
    test::TrainingBusSession ring;
    LedRow leds(ring.bus);
    StructureModel model;
    model.addBus(ring.bus);
    for (const Place without : {test::baumer, "5.0"_ring}) {
        leds.setPlace(without);
        EXPECT_TRUE(leds.isHidden()) << without.toString().toStdString();
        EXPECT_FALSE(
            model.indexOf(without).data(Qt::ToolTipRole).toString().contains(QStringLiteral("LEDs")));
    }
    leds.setPlace(test::singleTurn);
    EXPECT_FALSE(leds.isHidden());
}

TEST_F(MasterPanelTest, NothingIsCutOffInANarrowDock)
{
    panel.resize(200, 400);
    QCoreApplication::processEvents(); // rearranges the bits
    EXPECT_EQ(panel.horizontalScrollBar()->maximum(), 0);
    const auto labels = panel.findChildren<QLabel *>();
    EXPECT_GE(labels.size(), 10);
    for (const QLabel *label : labels)
        EXPECT_LE(label->mapTo(&panel, QPoint(label->width(), 0)).x(), panel.viewport()->width())
            << label->accessibleName().toStdString();
}

} // namespace
} // namespace codewheel
