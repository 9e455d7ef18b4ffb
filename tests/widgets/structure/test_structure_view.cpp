// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_line_address.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "tests/support/contrast.h"
#include "tests/support/model_tester.h"
#include "tests/support/plans.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/look/appearance.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/roles.h"
#include "widgets/project/project_document.h"
#include "widgets/structure/structure_columns.h"
#include "widgets/structure/structure_delegate.h"
#include "widgets/structure/structure_model.h"
#include "widgets/structure/structure_tree.h"
#include "widgets/structure/structure_view.h"
#include "widgets/structure/tree_filter.h"

#include <QAbstractItemModel>
#include <QApplication>
#include <QImage>
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
    EXPECT_EQ(text(fraba, StructureModel::stateColumn), QStringLiteral("no position")) << "mode not known";
    EXPECT_EQ(text(test::busTerminal, StructureModel::stateColumn), QStringLiteral("ok"));
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
    EXPECT_EQ(text(fraba, StructureModel::stateColumn), QStringLiteral("invalid"));
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
    EXPECT_EQ(text(fraba, StructureModel::stateColumn), QStringLiteral("unsent"));
    ASSERT_TRUE(ring.channel(fraba).write());
    ring.bus.advance(10);
    EXPECT_EQ(text(fraba, StructureModel::stateColumn), QStringLiteral("parameters"));
    EXPECT_EQ(text(baumer, StructureModel::stateColumn), QStringLiteral("no position")) << "coding not known";
    ring.encoder(baumer).tell(Parameter::coding, 0);
    ring.bus.advance(10);
    EXPECT_EQ(text(baumer, StructureModel::stateColumn), QStringLiteral("ok"));
    ring.bus.setRunning(false);
    ring.bus.advance(1);
    EXPECT_EQ(text(baumer, StructureModel::stateColumn), QStringLiteral("stopped"));
    EXPECT_EQ(model.index(0, StructureModel::stateColumn).data().toString(), QStringLiteral("ACTIVE"));
}

TEST_F(StructureTest, WithoutARingThereIsNothing)
{
    model.addBus(ring.bus);
    model.removeBus(firstBus);
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
    EXPECT_EQ(text(test::busTerminal, StructureModel::stateColumn), QStringLiteral("ok"));
}

TEST_F(StructureTest, ADeviceOfAnotherKindThanPlannedIsNotOk)
{
    Project plan = projectOf(ring.bus.structure());
    const auto terminal = std::ranges::find(plan.devices, test::busTerminal, &ProjectDevice::place);
    ASSERT_NE(terminal, plan.devices.end());
    terminal->participant.deviceCode = 0x0004;
    ProjectDocument project;
    project.setProject(plan, {});
    model.addBus(ring.bus);
    model.setProject(project, ring.catalog);
    ring.bus.advance(1);
    EXPECT_EQ(text(test::busTerminal, StructureModel::stateColumn), QStringLiteral("other kind"));
    project.setProject(projectOf(ring.bus.structure()), {});
    ring.bus.advance(1);
    EXPECT_EQ(text(test::busTerminal, StructureModel::stateColumn), QStringLiteral("ok"));
}

TEST_F(StructureTest, ALineThatIsOnlyPlannedStandsBesideTheRing)
{
    Project plan = projectOf(ring.bus.structure());
    changeLine(plan, [](EscLinePlan &line) { line.settings.port = QStringLiteral("ttyUSB0"); });
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
                    .startsWith(QStringLiteral("slide  esc:05  Kübler")));
    EXPECT_EQ(text(encoder.place(), StructureModel::stateColumn), QStringLiteral("planned"));
    EXPECT_EQ(text(encoder.place(), StructureModel::codeColumn), QStringLiteral("05h (5)"));
    EXPECT_EQ(text(test::busTerminal, StructureModel::stateColumn), QStringLiteral("ok"));
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
    EXPECT_EQ(model.indexOf(firstBus).data().toString(), QStringLiteral("Master"));
    const QSignalSpy told(&model, &QAbstractItemModel::dataChanged);
    setBusNames({{firstBus, QStringLiteral("Ring")}, {secondRing, QStringLiteral("Crane 2")}});
    const auto noNames = qScopeGuard([] { setBusNames({}); });
    model.showTitles();
    EXPECT_EQ(told.count(), 2) << "views show it at once";
    model.showTitles();
    EXPECT_EQ(told.count(), 2);
    EXPECT_EQ(model.indexOf(firstBus).data().toString(), QStringLiteral("Ring: Master"));
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
    std::erase_if(two.buses, [](const PlannedBus &bus) { return bus.id == firstBus; });
    project.edit(two, {});
    ASSERT_EQ(model.rowCount(), 1);
    EXPECT_TRUE(model.indexOf(secondRing).isValid());
}

TEST_F(StructureTest, StationsOfDevicesThatFitComeFirst)
{
    ProjectDocument project;
    project.setProject(projectOf(ring.bus.structure()), {});
    model.addBus(ring.bus);
    model.setProject(project, ring.catalog);
    const auto name = [](ProjectDevice &device) { device.station = QStringLiteral("hoist"); };
    project.editDevice(baumer, {}, name);
    EXPECT_EQ(text(baumer, StructureModel::deviceColumn), QStringLiteral("hoist  2.0  Baumer GXP6W K3"));
    Project after = project.project();
    after.devices[1].participant.deviceCode = 0x0136;
    project.edit(after, {});
    EXPECT_EQ(text(baumer, StructureModel::deviceColumn), QStringLiteral("2.0  Baumer GXP6W K3"))
        << "another device is planned there";
}

// A rebuilt model loses the selection, and the question about the make.
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
    view.removeBus(firstBus);
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

class StructureColumns : public StructureTest
{
protected:
    StructureColumns()
    {
        view.resize(340, 300);
        view.show();
        view.addBus(ring.bus);
    }

    std::vector<int> widths() const
    {
        std::vector<int> all;
        for (int column = 0; column < StructureModel::columns; ++column)
            all.push_back(tree().columnWidth(column)); // 0: hidden
        return all;
    }
    const QTreeView &tree() const { return *view.findChild<QTreeView *>(); }
    int ofCharacters(int count) const { return widthOfCharacters(tree().fontMetrics(), count); }
    int roomForName(Place place) const
    {
        const auto &shown = static_cast<const StructureModel &>(*tree().model());
        return tree().visualRect(shown.indexOf(place)).width() - tree().iconSize().width();
    }

    StructureView view;
};

TEST_F(StructureColumns, StayAsTheyAreWhateverStandsInThem)
{
    const std::vector<int> before = widths();
    ring.channel(fraba).stage(0x0200'00FF);
    ASSERT_TRUE(ring.channel(fraba).write());
    ring.bus.advance(10);
    QTest::qWait(20);
    EXPECT_EQ(widths(), before);
    ring.controls->setFault(TrainingFault::wireBreak, NodeId("4.0"), 1);
    ring.bus.advance(40);
    QTest::qWait(20);
    EXPECT_EQ(widths(), before) << "the fault is told elsewhere";
}

TEST_F(StructureColumns, TheNameKeepsItsRoomInAnyPanel)
{
    for (const int width : {200, 240, 280, 340, 500, 900}) {
        view.resize(width, 300);
        int all = 0;
        for (const int column : widths())
            all += column;
        EXPECT_LE(all, tree().viewport()->width()) << width;
        EXPECT_GE(tree().columnWidth(StructureModel::stateColumn), tree().iconSize().width()) << width;
        if (width >= 240) {
            EXPECT_GE(roomForName(test::onLoop), ofCharacters(width >= 320 ? 16 : 12)) << width;
        }
    }
    EXPECT_FALSE(tree().isColumnHidden(StructureModel::wordsColumn)) << "a wide panel shows all";
    view.resize(340, 300);
    EXPECT_TRUE(tree().isColumnHidden(StructureModel::profileColumn));
    EXPECT_FALSE(tree().isColumnHidden(StructureModel::positionColumn));
}

TEST_F(StructureColumns, AnUnsentWordIsNamedInFullInTheUsualPanel)
{
    view.resize(370, 300);
    const int longest = tree().fontMetrics().horizontalAdvance(QStringLiteral("ungesendet")); // in German
    EXPECT_GE(tree().columnWidth(StructureModel::stateColumn), stateIconWidth() + longest);
}

TEST_F(StructureColumns, AStateWithoutRoomForItsWordIsItsIconAndStillSaid)
{
    view.resize(310, 300);
    const QModelIndex state = tree().model()->index(0, StructureModel::stateColumn); // that of the master
    QStyleOptionViewItem cell;
    cell.rect = tree().visualRect(state);
    struct Delegate : StructureDelegate
    {
        using StructureDelegate::initStyleOption;
    };
    Delegate().initStyleOption(&cell, state);
    EXPECT_TRUE(cell.text.isEmpty()) << cell.rect.width();
    EXPECT_FALSE(cell.icon.isNull());
    EXPECT_EQ(state.data().toString(), QStringLiteral("RUN")) << "for screen readers";
    EXPECT_TRUE(state.data(Qt::ToolTipRole).toString().contains(QStringLiteral("RUN")));
    view.resize(400, 300);
    cell = {};
    cell.rect = tree().visualRect(state);
    Delegate().initStyleOption(&cell, state);
    EXPECT_EQ(cell.text, QStringLiteral("RUN"));
}

// What is painted, in both themes.
class StructureLook : public StructureColumns, public testing::WithParamInterface<Scheme>
{
protected:
    StructureLook()
    {
        applyAppearance(*qApp, {.scheme = GetParam()});
        view.show();
    }
    ~StructureLook() override { applyAppearance(*qApp, {.scheme = Scheme::light}); }

    QModelIndex cell(Place place, StructureModel::Column column) const
    {
        return static_cast<const StructureModel &>(*tree().model()).indexOf(place).siblingAtColumn(column);
    }
    QImage painted(QRect where) { return tree().viewport()->grab(where).toImage(); }
    static int count(const QImage &image, const QColor &color)
    {
        int found = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                found += image.pixelColor(x, y) == color ? 1 : 0;
        return found;
    }
    // How far a text stands out from the ground it is on.
    static int inkOf(const QImage &image)
    {
        int ink = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                ink = std::max(ink, std::abs(qGray(image.pixel(x, y)) - qGray(image.pixel(0, 0))));
        return ink;
    }
};

TEST_P(StructureLook, TheBrokenCableIsALineFromEdgeToEdgeWhetherItsRowIsChosenOrNot)
{
    ring.controls->setFault(TrainingFault::wireBreak, NodeId("4.0"), 1);
    ring.bus.advance(40);
    for (const Place chosen : {fraba, test::multiTurn}) {
        view.choose(chosen);
        QRect row = tree().visualRect(cell(test::multiTurn, StructureModel::deviceColumn));
        row.setLeft(0);
        row.setRight(tree().viewport()->width() - 1);
        const int line = count(painted(row), roleColor(Role::fault, view.palette()));
        EXPECT_GE(line, 2 * (row.width() - 30)) << chosen.shown().toStdString();
        QRect before = row.translated(0, -4);
        before.setHeight(4);
        EXPECT_LT(count(painted(before), roleColor(Role::fault, view.palette())), 10) << "in its own row";
    }
}

TEST_P(StructureLook, ABreakBeforeABusTerminalLeavesItsArrow)
{
    view.choose(fraba);
    const QRect name = tree().visualRect(cell(test::busTerminal, StructureModel::deviceColumn));
    const QRect arrow(name.left() - tree().indentation(), name.top() + 3, tree().indentation(),
                      name.height() - 3);
    const QImage before = painted(arrow);
    ring.controls->setFault(TrainingFault::wireBreak, test::busTerminal.node, 1);
    ring.bus.advance(40);
    ASSERT_TRUE(cell(test::busTerminal, StructureModel::deviceColumn)
                    .data(StructureModel::isBehindBreakRole)
                    .toBool());
    EXPECT_EQ(painted(arrow), before);
}

TEST_P(StructureLook, AnOldPositionLooksSoInTheChosenRowToo)
{
    view.choose(fraba);
    const QRect place = tree().visualRect(cell(fraba, StructureModel::positionColumn));
    const int live = inkOf(painted(place));
    ring.bus.setRunning(false);
    ring.bus.advance(40);
    const int old = inkOf(painted(place));
    EXPECT_LT(old, live * 3 / 4);
    EXPECT_GT(old, live / 3) << "it is read";
}

TEST_P(StructureLook, WhatIsChosenAndCutOffCanStillBeRead)
{
    ring.controls->setFault(TrainingFault::wireBreak, NodeId("4.0"), 1);
    ring.bus.advance(40);
    QStyleOptionViewItem option;
    option.palette = QApplication::palette();
    struct Delegate : StructureDelegate
    {
        using StructureDelegate::initStyleOption;
    };
    Delegate().initStyleOption(&option, cell(test::multiTurn, StructureModel::deviceColumn));
    EXPECT_GT(test::contrast(option.palette.color(QPalette::Active, QPalette::HighlightedText).rgb(),
                             option.palette.color(QPalette::Active, QPalette::Highlight).rgb()),
              3);
}

INSTANTIATE_TEST_SUITE_P(Themes, StructureLook, testing::Values(Scheme::light, Scheme::dark),
                         [](const auto &tested) { return tested.param == Scheme::light ? "Light" : "Dark"; });

TEST_F(StructureTest, WhatIsBehindABreakIsGreyAndSaidToBe)
{
    model.addBus(ring.bus);
    ring.controls->setFault(TrainingFault::wireBreak, NodeId("4.0"), 1);
    ring.bus.advance(40);
    const QModelIndex cut = model.indexOf(test::multiTurn);
    EXPECT_TRUE(cut.data(StructureModel::isBehindBreakRole).toBool());
    EXPECT_EQ(cut.data(Qt::AccessibleTextRole).toString(),
              QStringLiteral("4.0  FRABA OCD-IB K2, the bus is interrupted before it"));
    EXPECT_TRUE(cut.data(Qt::ForegroundRole).isValid());
    EXPECT_TRUE(model.indexOf(test::onLoop).data(Qt::ForegroundRole).isValid());
    EXPECT_FALSE(model.indexOf(test::onLoop).data(StructureModel::isBehindBreakRole).toBool());
    EXPECT_FALSE(model.indexOf(fraba).data(Qt::ForegroundRole).isValid());
    EXPECT_TRUE(model.indexOf(test::singleTurn)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(QStringLiteral("State: fault")));
    EXPECT_TRUE(
        cut.data(Qt::ToolTipRole).toString().contains(QStringLiteral("Check plug, shield and 24 V.")));
}

TEST_F(StructureTest, ASpeedStandsInPlaceOfThePosition)
{
    model.addBus(ring.bus);
    ring.controls->setSpeed(fraba.node, 120);
    ring.encoder(fraba).tell(Parameter::startUpMode, 1);
    ring.bus.advance(10);
    ring.channel(fraba).stage(0x2040'0001); // velocity on
    ASSERT_TRUE(ring.channel(fraba).write());
    ring.bus.advance(500);
    ASSERT_TRUE(ring.encoder(fraba).latest().velocity);
    EXPECT_EQ(text(fraba, StructureModel::positionColumn), QStringLiteral("120 rpm"));
}

TEST_F(StructureTest, AFilterIsThereWhereThereAreManyDevices)
{
    StructureView view;
    view.show();
    view.addBus(ring.bus);
    auto &filter = *view.findChild<TreeFilter *>();
    EXPECT_FALSE(filter.isVisible());
    Project plan = projectOf(ring.bus.structure());
    changeLine(plan, [](EscLinePlan &) {});
    std::vector<ProjectDevice> encoders;
    for (int address = 1; address <= 6; ++address) {
        ProjectDevice encoder;
        encoder.standAt(placeOnLine({static_cast<std::uint8_t>(address)}));
        encoder.participant.deviceKey = QStringLiteral("kuebler-esc-rs485");
        encoder.station = QStringLiteral("slide %1").arg(address);
        encoders.push_back(encoder);
    }
    setEncodersOnLine(plan, encoders);
    ProjectDocument project;
    project.setProject(plan, {});
    view.setProject(project, ring.catalog);
    ASSERT_TRUE(filter.isVisible());
    const auto &tree = *view.findChild<QTreeView *>();
    const auto &shown = static_cast<const StructureModel &>(*tree.model());
    const auto isSeen = [&](Place place) { return tree.visualRect(shown.indexOf(place)).isValid(); };
    QTest::keyClicks(&filter, QStringLiteral("SLIDE 3"));
    EXPECT_TRUE(isSeen(placeOnLine({3})));
    EXPECT_FALSE(isSeen(placeOnLine({2})));
    EXPECT_FALSE(isSeen(fraba));
    filter.setText(QStringLiteral("loop"));
    EXPECT_TRUE(isSeen(test::onLoop)) << "with the terminal it hangs on";
    view.reveal(fraba);
    EXPECT_TRUE(filter.text().isEmpty());
    EXPECT_TRUE(isSeen(fraba));
    EXPECT_EQ(view.current(), fraba);
    QTest::keyClicks(&filter, QStringLiteral("slide"));
    QTest::keyClick(&filter, Qt::Key_Escape);
    EXPECT_TRUE(isSeen(fraba));
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
