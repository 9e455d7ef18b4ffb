// SPDX-License-Identifier: GPL-3.0-or-later
#include "encoder/line_address.h"
#include "project/project_take_over.h"
#include "tests/support/model_tester.h"
#include "tests/support/plans.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/look/inline_message.h"
#include "widgets/project/project_document.h"
#include "widgets/structure/structure_model.h"
#include "widgets/structure/structure_tree.h"
#include "widgets/structure/structure_view.h"

#include <QAbstractItemModel>
#include <QModelIndex>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <QTest>
#include <QTreeView>
#include <QWidget>

#include <gtest/gtest.h>
#include <set>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class StructureTest : public testing::Test
{
protected:
    StructureTest() { ring.bus.advance(10); }

    QString text(Place number, StructureModel::Column column)
    {
        return model.indexOf(number).siblingAtColumn(column).data().toString();
    }

    test::TrainingBusSession ring;
    StructureModel model;
    test::ModelTester tester{model};
};

TEST_F(StructureTest, ShowsTheMasterAndBelowItTheDevicesOfTheRing)
{
    model.addBus(ring.bus);
    ASSERT_EQ(model.rowCount(), 1);
    const QModelIndex master = model.index(0, 0);
    EXPECT_EQ(master.data().toString(), QStringLiteral("Master"));
    EXPECT_EQ(master.siblingAtColumn(StructureModel::stateColumn).data().toString(), QStringLiteral("RUN"));
    EXPECT_EQ(model.rowCount(master), 6);
    EXPECT_EQ(text(fraba, StructureModel::deviceColumn), QStringLiteral("1.0  FRABA OCD-IB K3"));
    EXPECT_EQ(text(fraba, StructureModel::profileColumn), QStringLiteral("K3"));
    EXPECT_EQ(text(fraba, StructureModel::codeColumn), QStringLiteral("37h = 55"));
    EXPECT_EQ(text(baumer, StructureModel::wordsColumn), QStringLiteral("2 / 2"));
    EXPECT_EQ(text(fraba, StructureModel::stateColumn), QStringLiteral("ok"));
    EXPECT_EQ(text(test::singleTurn, StructureModel::profileColumn), QStringLiteral("K1"));
    EXPECT_EQ(text(test::singleTurn, StructureModel::wordsColumn), QStringLiteral("1 / 0"));
}

TEST_F(StructureTest, ABranchHangsOnItsBusTerminal)
{
    model.addBus(ring.bus);
    const QModelIndex terminal = model.indexOf(test::busTerminal);
    EXPECT_EQ(terminal.data().toString(), QStringLiteral("6.0  bus terminal"));
    EXPECT_EQ(text(test::busTerminal, StructureModel::codeColumn), QStringLiteral("0Ch = 12"));
    EXPECT_EQ(text(test::busTerminal, StructureModel::wordsColumn), QStringLiteral("0 / 0"));
    EXPECT_EQ(text(test::busTerminal, StructureModel::stateColumn), QStringLiteral("ok"));
    EXPECT_EQ(model.indexOf(test::onLoop).parent(), terminal);
    EXPECT_EQ(model.rowCount(terminal), 1);
    EXPECT_EQ(text(test::onLoop, StructureModel::deviceColumn),
              QStringLiteral("6.1  FRABA OCD-IB K3 Loop 2"));
}

TEST_F(StructureTest, TheTooltipTellsACodingThatIsNotPlain)
{
    model.addBus(ring.bus);
    const auto toolTip = [this] { return model.indexOf(baumer).data(Qt::ToolTipRole).toString(); };
    EXPECT_FALSE(toolTip().contains(QStringLiteral("Position:")));
    ring.encoder(baumer).tell(Parameter::coding, 5);
    ring.bus.advance(2);
    EXPECT_TRUE(toolTip().endsWith(QStringLiteral("Position: Gray code")));
    ring.encoder(baumer).tell(Parameter::coding, 1);
    ring.bus.advance(2);
    EXPECT_TRUE(toolTip().endsWith(QStringLiteral("Position: signed")));
}

TEST_F(StructureTest, AShaftThatTurnsTooFastHasNoValidPosition)
{
    model.addBus(ring.bus);
    ring.controls->setSpeed(fraba.node, 6000);
    ring.bus.advance(20);
    EXPECT_EQ(ring.encoder(fraba).latest().in, Word{0x8000'0000});
    EXPECT_EQ(text(fraba, StructureModel::stateColumn), QStringLiteral("no valid position"));
}

TEST_F(StructureTest, StatesFollowTheBus)
{
    model.addBus(ring.bus);
    int changes = 0;
    QObject::connect(&model, &QAbstractItemModel::dataChanged, &model, [&](const QModelIndex &first) {
        changes += first.column() == StructureModel::positionColumn ? 0 : 1;
    });
    ring.bus.advance(100);
    EXPECT_EQ(changes, 0) << "a moving position changes no state";

    ring.channel(fraba).stage(0x0200'00FF);
    EXPECT_EQ(text(fraba, StructureModel::stateColumn), QStringLiteral("OUT not sent"));
    ASSERT_TRUE(ring.channel(fraba).write());
    ring.bus.advance(10);
    EXPECT_EQ(text(fraba, StructureModel::stateColumn), QStringLiteral("parameterization"));
    EXPECT_EQ(text(baumer, StructureModel::stateColumn), QStringLiteral("ok"));
    ring.bus.setRunning(false);
    ring.bus.advance(1);
    EXPECT_EQ(text(baumer, StructureModel::stateColumn), QStringLiteral("stopped"));
    EXPECT_EQ(model.index(0, StructureModel::stateColumn).data().toString(), QStringLiteral("ACTIVE"));
}

TEST_F(StructureTest, WithoutARingThereIsNothing)
{
    model.addBus(ring.bus);
    model.removeBus(firstRing);
    EXPECT_EQ(model.rowCount(), 0);
}

TEST_F(StructureTest, OfflineItShowsWhatTheProjectPlans)
{
    ProjectDocument project;
    project.setProject(projectOf(ring.bus.structure()), {});
    model.setProject(project, ring.catalog);
    EXPECT_EQ(model.index(0, StructureModel::stateColumn).data().toString(), QStringLiteral("offline"));
    EXPECT_EQ(text(baumer, StructureModel::deviceColumn), QStringLiteral("2.0  Baumer GXP6W K3"));
    EXPECT_EQ(text(baumer, StructureModel::stateColumn), QStringLiteral("planned"));
    Project after = project.project();
    after.devices.pop_back();
    project.edit(after, {});
    EXPECT_FALSE(model.indexOf(test::onLoop).isValid());
    project.setProject({}, {});
    EXPECT_EQ(model.rowCount(), 0);
    model.addBus(ring.bus);
    EXPECT_EQ(text(baumer, StructureModel::stateColumn), QStringLiteral("ok"));
}

TEST_F(StructureTest, ALineThatIsOnlyPlannedStandsBesideTheRing)
{
    Project plan = projectOf(ring.bus.structure());
    changeLine(plan, [](LinePlan &line) { line.settings.port = QStringLiteral("ttyUSB0"); });
    ProjectDevice encoder;
    encoder.standAt(placeOnLine({5}));
    encoder.participant.deviceKey = QStringLiteral("kuebler-esc-rs485");
    encoder.station = QStringLiteral("slide");
    setEncodersOnLine(plan, {encoder});
    ProjectDocument project;
    project.setProject(plan, {});
    model.addBus(ring.bus);
    model.setProject(project, ring.catalog);
    ASSERT_EQ(model.rowCount(), 2);
    EXPECT_EQ(model.indexOf(firstLine).data().toString(), QStringLiteral("Serial line (ttyUSB0)"));
    EXPECT_TRUE(text(encoder.place(), StructureModel::deviceColumn)
                    .startsWith(QStringLiteral("esc:05  slide: Kübler")));
    EXPECT_EQ(text(encoder.place(), StructureModel::stateColumn), QStringLiteral("planned"));
    EXPECT_EQ(text(encoder.place(), StructureModel::codeColumn), QStringLiteral("05h (5)"));
    EXPECT_EQ(text(fraba, StructureModel::stateColumn), QStringLiteral("ok"));
}

TEST_F(StructureTest, BusesThatLookTheSameAreToldApartByTheirNames)
{
    constexpr BusId secondRing{3};
    Project plan = projectOf(ring.bus.structure());
    plan.buses.push_back(
        {secondRing, QStringLiteral("interbus"), QStringLiteral("Crane 2"), plan.buses[0].settings});
    ProjectDevice there = plan.devices[0];
    there.bus = secondRing;
    plan.devices.push_back(there);
    ProjectDocument project;
    project.setProject(plan, {});
    model.setProject(project, ring.catalog);
    EXPECT_EQ(model.indexOf(firstRing).data().toString(), QStringLiteral("Master"));
    const QSignalSpy told(&model, &QAbstractItemModel::dataChanged);
    setBusNames({{firstRing, QStringLiteral("Ring")}, {secondRing, QStringLiteral("Crane 2")}});
    const auto noNames = qScopeGuard([] { setBusNames({}); });
    model.showTitles();
    EXPECT_EQ(told.count(), 2) << "views show it at once";
    model.showTitles();
    EXPECT_EQ(told.count(), 2);
    EXPECT_EQ(model.indexOf(firstRing).data().toString(), QStringLiteral("Ring: Master"));
    EXPECT_EQ(model.indexOf(secondRing).data().toString(), QStringLiteral("Crane 2: Master"));
    EXPECT_EQ(model.placeAt(model.indexOf(there.place())), there.place());
    EXPECT_EQ(model.indexOf(there.place()).parent(), model.indexOf(secondRing));
}

TEST_F(StructureTest, EveryPlannedBusIsShownButTheRingOfANewProject)
{
    constexpr BusId secondRing{3};
    ProjectDocument project;
    model.setProject(project, ring.catalog);
    EXPECT_EQ(model.rowCount(), 0);
    Project two;
    two.buses.push_back(
        {secondRing, QStringLiteral("interbus"), QStringLiteral("Crane"), two.buses[0].settings});
    project.edit(two, {});
    ASSERT_EQ(model.rowCount(), 2);
    std::erase_if(two.buses, [](const PlannedBus &bus) { return bus.id == firstRing; });
    project.edit(two, {});
    ASSERT_EQ(model.rowCount(), 1);
    EXPECT_TRUE(model.indexOf(secondRing).isValid());
}

TEST_F(StructureTest, StationsOfDevicesThatFitStandBesideTheNumber)
{
    ProjectDocument project;
    project.setProject(projectOf(ring.bus.structure()), {});
    model.addBus(ring.bus);
    model.setProject(project, ring.catalog);
    const auto name = [](ProjectDevice &device) { device.station = QStringLiteral("hoist"); };
    project.editDevice(baumer, {}, name);
    EXPECT_EQ(text(baumer, StructureModel::deviceColumn), QStringLiteral("2.0  hoist: Baumer GXP6W K3"));
    Project after = project.project();
    after.devices[1].participant.deviceCode = 0x0136;
    project.edit(after, {});
    EXPECT_EQ(text(baumer, StructureModel::deviceColumn), QStringLiteral("2.0  Baumer GXP6W K3"))
        << "another device is planned there";
}

// A model that is made anew loses what is chosen, and the question which make it is.
TEST_F(StructureTest, NamingADeviceKeepsItChosenAndItsMakeAskedFor)
{
    ProjectDocument project;
    project.setProject(projectOf(ring.bus.structure()), {});
    StructureView view;
    view.setProject(project, ring.catalog);
    view.addBus(ring.bus);
    view.choose(baumer);
    view.show();
    const auto *question = view.findChild<InlineMessage *>(QStringLiteral("makeQuestion"));
    const auto plan = [&](const QString &key) {
        project.editDevice(baumer, {}, [&](ProjectDevice &device) { device.participant.deviceKey = key; });
        EXPECT_EQ(view.current(), baumer);
    };
    for (const QString &key : {QString(), QStringLiteral("baumer-gxp6w")}) {
        ASSERT_TRUE(ring.bus.name(baumer, key));
        plan(key);
        EXPECT_EQ(question->isVisible(), key.isEmpty());
    }
    view.removeBus(firstRing);
    view.choose(baumer);
    plan({});
}

TEST_F(StructureTest, ArrowsChooseAndEnterOpens)
{
    StructureView view;
    QSignalSpy chosen(&view, &StructureView::chosen);
    QSignalSpy opened(&view, &StructureView::opened);
    view.addBus(ring.bus);
    EXPECT_EQ(view.current(), fraba);
    view.show();
    view.setFocus();
    QWidget *tree = view.focusProxy();
    QTest::keyClick(tree, Qt::Key_Down);
    EXPECT_EQ(view.current(), baumer);
    EXPECT_EQ(chosen.count(), 2);
    QTest::keyClick(tree, Qt::Key_Return);
    ASSERT_EQ(opened.count(), 1);
    EXPECT_EQ(opened.front().front().value<Place>(), baumer);
    QTest::keyClick(tree, Qt::Key_Home);
    EXPECT_EQ(view.current(), std::nullopt) << "the master";
}

TEST_F(StructureTest, TheStateIsSeenInANarrowPanelWhateverTheNames)
{
    StructureView view;
    view.resize(200, 300);
    view.show();
    view.addBus(ring.bus);
    const auto &tree = *view.findChild<QTreeView *>();
    const QModelIndex state = tree.model()->index(0, StructureModel::stateColumn, tree.model()->index(0, 0));
    EXPECT_LE(tree.visualRect(state).right(), tree.viewport()->width());
    view.resize(280, 300);
    const int shortState = tree.columnWidth(StructureModel::stateColumn);
    ring.channel(fraba).stage(0x0200'00FF);
    ASSERT_TRUE(ring.channel(fraba).write());
    ring.bus.advance(10);
    EXPECT_EQ(state.data().toString(), QStringLiteral("parameterization"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return tree.columnWidth(StructureModel::stateColumn) > shortState; }));
    EXPECT_LE(tree.visualRect(state).right(), tree.viewport()->width());
    const int narrow = tree.columnWidth(StructureModel::deviceColumn);
    ring.channel(fraba).stage(0x8000'0000);
    ASSERT_TRUE(ring.channel(fraba).write());
    ring.bus.advance(30);
    EXPECT_EQ(state.data().toString(), QStringLiteral("ok"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return tree.columnWidth(StructureModel::deviceColumn) > narrow; }))
        << "the name has its room again";
}

TEST_F(StructureTest, TheNumbersAreSeenInANarrowPanelHoweverLongTheStates)
{
    StructureView view;
    view.resize(200, 300);
    view.show();
    view.addBus(ring.bus);
    const auto &tree = *view.findChild<QTreeView *>();
    ring.controls->setFault(TrainingFault::wireBreak, NodeId("4.0"), 1);
    ring.bus.advance(40);
    const auto &shown = static_cast<const StructureModel &>(*tree.model());
    QTest::qWait(50); // columns are measured once rows have changed
    EXPECT_LE(tree.columnWidth(StructureModel::deviceColumn) + tree.columnWidth(StructureModel::stateColumn),
              tree.viewport()->width())
        << "it is elided, not cut off";
    const int number = tree.fontMetrics().horizontalAdvance(QStringLiteral("6.1"));
    EXPECT_GT(tree.visualRect(shown.indexOf(test::onLoop)).width(), tree.iconSize().width() + number);
}

TEST(TheTreeOfTheStructure, PaintsNoMoreThanTheColumnThatChanged)
{
    struct Painted : QStyledItemDelegate
    {
        mutable std::set<std::pair<int, int>> cells;
        void paint(QPainter *, const QStyleOptionViewItem &, const QModelIndex &index) const override
        {
            cells.emplace(index.row(), index.column());
        }
    } painted;
    QStandardItemModel rows(3, 2);
    StructureTree tree;
    tree.setModel(&rows);
    tree.setItemDelegate(&painted);
    tree.setUniformRowHeights(true);
    tree.show();
    tree.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&tree));
    ASSERT_TRUE(QTest::qWaitFor([&] { return painted.cells.size() == 6; }));
    painted.cells.clear();
    rows.setData(rows.index(0, 1), 1);
    rows.setData(rows.index(2, 1), 1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return painted.cells.contains({2, 1}); }));
    for (const auto &[row, column] : painted.cells)
        EXPECT_EQ(column, 1) << "row " << row;
    tree.setModel(nullptr);
}

} // namespace
} // namespace codewheel
