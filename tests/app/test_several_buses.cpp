// SPDX-License-Identifier: GPL-3.0-or-later
// Several rings and lines: each is connected, driven and stopped on its own, in the window.
#include "app/journal_files.h"
#include "app/window/buses/bus_views.h"
#include "app/window/buses/plant.h"
#include "app/window/kinds/canopen/canopen_at_work.h"
#include "app/window/kinds/esc/esc_line_at_work.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "journal/ledger.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "project/project_file.h"
#include "tests/app/planned_encoder.h"
#include "tests/app/press_connect.h"
#include "tests/app/window_test.h"
#include "tests/support/plans.h"
#include "tests/support/pty_pair.h"
#include "widgets/connect/connect_page.h"
#include "widgets/kinds/esc/line/esc_line_settings_form.h"
#include "widgets/kinds/esc/line/esc_line_terminal.h"
#include "widgets/kinds/interbus/master/master_panel.h"
#include "widgets/look/label_text.h"
#include "widgets/look/role_label.h"
#include "widgets/structure/structure_model.h"
#include "widgets/structure/structure_view.h"
#include "widgets/structure_editor/insert_panel.h"
#include "widgets/structure_editor/structure_editor.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QStatusBar>
#include <QTableView>
#include <QTreeView>

#include <set>

namespace codewheel {
namespace {

constexpr BusId secondRing{3};
constexpr BusId secondLine{4};
constexpr Place farFraba{secondRing, NodeId("1.0")};

class SeveralBuses : public test::WindowTest
{
protected:
    void plan(BusId bus, const char16_t *kind)
    {
        Project after = shown->project().project();
        planBus(after, bus, *busKind(kind));
        shown->project().edit(std::move(after), {});
    }
    void startAnew()
    {
        Project empty;
        empty.buses = usualBuses();
        shown->project().setProject(std::move(empty), {});
    }
    void choose(BusId bus) { window().findChild<StructureView *>()->choose(bus); }
    void choose(Place place) { window().findChild<StructureView *>()->choose(place); }
    QString cell(BusId bus, StructureModel::Column column)
    {
        const auto &model = static_cast<const StructureModel &>(
            *window().findChild<StructureView *>()->findChild<QTreeView *>()->model());
        return model.indexOf(bus).siblingAtColumn(column).data().toString();
    }
    StructureView &tree() { return *window().findChild<StructureView *>(); }
    // The actions of the window apply to the bus of the highlighted row.
    void expectStopMeans(BusId bus)
    {
        ASSERT_TRUE(tree().row());
        EXPECT_EQ(tree().row()->bus, bus);
        const auto running = [this] {
            std::set<BusId> buses;
            for (const EncoderBus *each : shown->buses().open())
                if (each->isRunning())
                    buses.insert(each->id());
            return buses;
        };
        auto left = running();
        left.erase(bus);
        actions().stop->trigger();
        advance(100);
        EXPECT_TRUE(QTest::qWaitFor([&] {
            advance(33);
            return running() == left;
        }));
    }
    EncoderBus &busAt(BusId bus) { return *shown->plant().find(bus)->bus(); }

    // Leaves its form open.
    void planLine(BusId line, const QString &path)
    {
        if (findBus(shown->project().project(), line) == nullptr)
            plan(line, u"esc");
        Project after = shown->project().project();
        EscLinePlan settings;
        settings.settings.port = path;
        setLinePlan(after, line, settings);
        shown->project().edit(std::move(after), {});
        choose(line);
        lineActions().settings->trigger();
    }
    void connectInForm(BusId line, const QString &path)
    {
        EscLineSettings settings;
        settings.port = path;
        for (auto *page : window().findChildren<ConnectPage *>())
            if (page->isVisible()) {
                test::chooseSerialPort(*page);
                page->findChild<EscLineSettingsForm *>()->setSettings(settings);
                test::pressConnect(*page);
            }
        const auto *its = qobject_cast<EscLineAtWork *>(shown->plant().find(line));
        EXPECT_TRUE(QTest::qWaitFor([&] { return !its->isOpening(); }));
        advance(50);
    }

    void openSecondRing()
    {
        plan(secondRing, u"interbus");
        Project after = shown->project().project();
        ProjectDevice device = after.devices.front();
        device.bus = secondRing;
        setDevicesOn(after, secondRing, {device});
        shown->project().edit(std::move(after), {});
        choose(secondRing);
        ringActions().connectBus->trigger();
        advance(50);
    }
};

TEST_F(SeveralBuses, TheStatusLineSaysWhoseModeStandsBesideTheStateOfTheRing)
{
    const auto mode = [this] {
        return window().statusBar()->findChildren<RoleLabel *>().at(1)->word().toStdString();
    };
    EXPECT_EQ(mode(), "Operate");
    choose(firstLine);
    EXPECT_EQ(mode(), "Line: Operate");
    actions().watch->trigger();
    advance(50);
    EXPECT_EQ(mode(), "Line: Watch");
    choose(firstBus);
    EXPECT_EQ(mode(), "Operate");
}

TEST_F(SeveralBuses, ASecondRingIsConnectedBesideTheFirst)
{
    openSecondRing();
    ASSERT_TRUE(busAt(secondRing).isOpen());
    EXPECT_TRUE(bus().isOpen());
    EXPECT_EQ(cell(firstBus, StructureModel::deviceColumn), QStringLiteral("Ring"));
    EXPECT_EQ(cell(secondRing, StructureModel::deviceColumn), QStringLiteral("Ring 2"));
    EXPECT_EQ(cell(secondRing, StructureModel::stateColumn), QStringLiteral("RUN"));
    EXPECT_EQ(farFraba.shown(), QStringLiteral("Ring 2/1.0"));
    ASSERT_FALSE(monitors().cards().empty());
    for (const WordCard *card : monitors().cards())
        EXPECT_EQ(card->accessibleName(), QStringLiteral("Monitor %1").arg(card->place().shown()));
    EXPECT_EQ(test::fraba.shown(), QStringLiteral("Ring/1.0"));
    EXPECT_EQ(placeOnLine({5}).shown(), QStringLiteral("esc:05")) << "there is one line";

    choose(farFraba);
    EXPECT_FALSE(ringActions().connectBus->isEnabled());
    actions().watch->trigger();
    advance(50);
    EXPECT_FALSE(busAt(secondRing).isOperating());
    EXPECT_TRUE(bus().isOperating());
    actions().stop->trigger();
    advance(50);
    EXPECT_FALSE(busAt(secondRing).isRunning());
    EXPECT_TRUE(bus().isRunning());
}

TEST_F(SeveralBuses, AnEncoderThatIsOnlyPlannedTakesTheByteOrderAndIsNotRemovedFromItsLine)
{
    plan(secondLine, u"esc");
    const Place place{secondLine, EscLineAddress{7}.node()};
    Project after = shown->project().project();
    ProjectDevice encoder = test::plannedEncoder(place);
    setDevicesOn(after, secondLine, {encoder});
    shown->project().edit(std::move(after), {});
    const auto isSwapped = [&] {
        return shown->project().device(place).its<EscEncoderSettings>().swapsWarningBytes;
    };
    choose(place);
    EXPECT_FALSE(lineActions().remove->isEnabled()) << "the structure editor does that";
    ASSERT_TRUE(lineActions().swapWarningBytes->isEnabled());
    lineActions().swapWarningBytes->trigger();
    EXPECT_TRUE(isSwapped());
    EXPECT_TRUE(lineActions().swapWarningBytes->isChecked());
    actions().undo->trigger();
    EXPECT_FALSE(isSwapped());
    EXPECT_FALSE(lineActions().swapWarningBytes->isChecked());
    choose(placeOnLine({5})); // on the training line
    EXPECT_TRUE(lineActions().remove->isEnabled());
    choose(test::fraba);
    EXPECT_FALSE(lineActions().swapWarningBytes->isEnabled());
}

TEST_F(SeveralBuses, StopInTheMasterPanelStopsItsRingWhateverIsChosen)
{
    choose(placeOnLine({5}));
    const EncoderBus &line = busAt(firstLine);
    auto *panel = window().findChild<MasterPanel *>();
    const auto click = [&](const QString &text) {
        for (QPushButton *button : panel->findChildren<QPushButton *>())
            if (plainLabel(button->text()) == text)
                button->click();
        advance(50);
    };
    click(QStringLiteral("Stop"));
    EXPECT_FALSE(bus().isRunning());
    EXPECT_TRUE(line.isRunning());
    click(QStringLiteral("Start"));
    EXPECT_TRUE(bus().isRunning());
}

TEST_F(SeveralBuses, TheTrainingLineGivesWayToAProjectThatHasAPortForIt)
{
    Project project;
    EscLinePlan plan;
    plan.settings.port = QStringLiteral("/dev/ttyUSB7");
    setLinePlan(project, firstLine, plan);
    setDevicesOn(project, firstLine, {test::plannedEncoder(placeOnLine({5}), QStringLiteral("Slide"))});
    shown->project().setProject(project, {});
    EXPECT_EQ(shown->plant().find(firstLine)->bus(), nullptr) << "its simulated encoders are not those";
    choose(placeOnLine({5}));
    EXPECT_EQ(window().findChild<StructureView *>()->current(), placeOnLine({5})) << "as it is planned";
    shown->project().setProject({}, {});
    ASSERT_NE(shown->plant().find(firstLine)->bus(), nullptr);
    EXPECT_TRUE(busAt(firstLine).isSimulated());
}

TEST_F(SeveralBuses, AnEncoderPlannedOnALineTakesTheByteOrderWhileTheTrainingLineOfItsNumberIsOpen)
{
    const Place place = placeOnLine({7}); // not on the training line
    Project after = shown->project().project();
    setEncodersOnLine(after, {test::plannedEncoder(placeOnLine({5})), test::plannedEncoder(place)});
    shown->project().edit(std::move(after), {});
    const auto isSwapped = [&](Place its) {
        return shown->project().device(its).its<EscEncoderSettings>().swapsWarningBytes;
    };
    choose(firstLine);
    actions().structureEditor->trigger();
    auto &plan = *window().findChild<StructureEditor *>()->findChild<QTreeView *>(QStringLiteral("plan"));
    plan.setCurrentIndex(plan.model()->index(1, 0));
    ASSERT_TRUE(lineActions().swapWarningBytes->isEnabled());
    lineActions().swapWarningBytes->trigger();
    EXPECT_TRUE(isSwapped(place));
    EXPECT_TRUE(lineActions().swapWarningBytes->isChecked());
    choose(placeOnLine({5}));
    lineActions().swapWarningBytes->trigger();
    EXPECT_FALSE(isSwapped(placeOnLine({5}))) << "the one of the training line is not the project's";
}

// The row of a bus is selected on its own; the panels keep showing their device.
TEST_F(SeveralBuses, MonitorsAreOfTheDeviceThatIsShown)
{
    openSecondRing();
    choose(test::fraba);
    choose(secondRing);
    ringActions().disconnectBus->trigger();
    advance(50);
    choose(secondRing);
    EXPECT_TRUE(actions().openMonitor->isEnabled()) << "the shown encoder is connected";
    choose(farFraba);
    EXPECT_FALSE(actions().openMonitor->isEnabled());
    choose(firstBus);
    EXPECT_FALSE(actions().openMonitor->isEnabled()) << "the shown encoder is not connected";
}

TEST_F(SeveralBuses, EachMonitorShowsItsOwnBus)
{
    openSecondRing();
    choose(farFraba);
    actions().openMonitor->trigger();
    const WordCard *far = monitors().card(farFraba);
    ASSERT_NE(far, nullptr);
    WordChannel &channel = *busAt(secondRing).channel(farFraba);
    channel.stage(0x0200'00FF);
    ASSERT_TRUE(channel.write());
    advance(20);
    EXPECT_EQ(channel.out(), Word{0x0200'00FF});
    EXPECT_EQ(far->line(WordDirection::out)->shown(), Word{0x0200'00FF});
    EXPECT_EQ(out(test::fraba), Word{0}) << "the encoder of the same number in the other ring";
}

TEST_F(SeveralBuses, AFaultOfAnotherRingIsToldAtTheFoot)
{
    openSecondRing();
    choose(test::fraba);
    const auto told = [this](const QString &fault) {
        const auto states = window().statusBar()->findChildren<RoleLabel *>();
        return std::ranges::count_if(
            states, [&](const RoleLabel *state) { return state->isVisible() && state->word() == fault; });
    };
    auto &second = dynamic_cast<RingAtWork &>(*shown->plant().find(secondRing));
    second.controls().setFault(TrainingFault::wireBreak, NodeId("3.0"), 1);
    advance(100);
    const QString fault = QStringLiteral("Ring 2: %1").arg(cell(secondRing, StructureModel::stateColumn));
    EXPECT_NE(fault, QStringLiteral("Ring 2: RUN"));
    EXPECT_EQ(told(QStringLiteral("Ring: RUN")), 1);
    EXPECT_EQ(told(fault), 1) << fault.toStdString();
    choose(farFraba);
    advance(40);
    EXPECT_EQ(told(fault), 1) << "as the state of the chosen ring";
    EXPECT_EQ(told(QStringLiteral("Ring: RUN")), 0);
}

TEST_F(SeveralBuses, PagesAndPanelsTellWhoseTheyAre)
{
    const auto &title = *window().findChild<QWidget *>(QStringLiteral("pageTitle"));
    const auto &master = *window().findChild<QDockWidget *>(QStringLiteral("masterDock"));
    const auto &terminal = *window().findChild<QDockWidget *>(QStringLiteral("terminalDock"));
    actions().compare->trigger();
    EXPECT_EQ(title.accessibleName(), QStringLiteral("Compare with the bus \u2013 Ring"));
    EXPECT_EQ(master.windowTitle(), QStringLiteral("Master"));

    openSecondRing();
    choose(secondRing);
    EXPECT_EQ(master.windowTitle(), QStringLiteral("Master (Ring 2)"));
    EXPECT_EQ(terminal.windowTitle(), QStringLiteral("Line terminal")) << "there is one line";
    EXPECT_EQ(title.accessibleName(), QStringLiteral("Compare with the bus \u2013 Ring 2"));
    choose(firstBus);
    EXPECT_EQ(master.windowTitle(), QStringLiteral("Master (Ring)"));
    EXPECT_EQ(title.accessibleName(), QStringLiteral("Compare with the bus \u2013 Ring"));
    actions().monitors->trigger();
    EXPECT_FALSE(title.isVisible()) << "they show encoders of all";
}

TEST_F(SeveralBuses, AlarmStopSaysWhatItDoesOnEach)
{
    EXPECT_EQ(actions().alarmStop->toolTip().section(u'(', 0, 0).trimmed(),
              QStringLiteral("At once: Ring: all OUT words become 0, and jobs end; "
                             "Line: jobs end, and nothing that waits is sent; positions are still read"));
}

TEST_F(SeveralBuses, AlarmStopMeansAllOfThem)
{
    openSecondRing();
    WordChannel &channel = *busAt(secondRing).channel(farFraba);
    channel.stage(0x0200'00FF);
    ASSERT_TRUE(channel.write());
    advance(20);
    actions().alarmStop->trigger();
    advance(50);
    EXPECT_EQ(channel.out(), Word{0});
    EXPECT_FALSE(bus().isRunning());
    EXPECT_FALSE(busAt(secondRing).isRunning());
}

TEST_F(SeveralBuses, ARingThatIsNotPlannedAnyMoreStaysUntilItIsDisconnected)
{
    openSecondRing();
    Project after = shown->project().project();
    setDevicesOn(after, secondRing, {});
    std::erase_if(after.buses, [](const PlannedBus &bus) { return bus.id == secondRing; });
    shown->project().edit(std::move(after), {});
    ASSERT_NE(shown->plant().find(secondRing), nullptr);
    EXPECT_EQ(cell(secondRing, StructureModel::stateColumn), QStringLiteral("RUN"));
    EXPECT_EQ(cell(secondRing, StructureModel::deviceColumn), QStringLiteral("Ring 2")) << "as before";
    plan(BusId{7}, u"interbus");
    EXPECT_EQ(cell(BusId{7}, StructureModel::deviceColumn), QStringLiteral("Ring 2"));
    EXPECT_EQ(cell(secondRing, StructureModel::deviceColumn), QStringLiteral("Ring 2 2"));
    choose(secondRing);
    ringActions().disconnectBus->trigger();
    advance(50);
    shown->project().edit(shown->project().project(), {}); // any change will do
    EXPECT_TRUE(cell(secondRing, StructureModel::stateColumn).isEmpty());
}

TEST_F(SeveralBuses, TwoLinesAtTwoPorts)
{
    PtyPair one;
    PtyPair two;
    const auto connectLine = [&](BusId line, const QString &path) {
        planLine(line, path);
        connectInForm(line, path);
    };
    connectLine(firstLine, one.path());
    connectLine(secondLine, two.path());
    ASSERT_TRUE(shown->plant().find(secondLine)->isOpen());
    ASSERT_TRUE(shown->plant().find(firstLine)->isOpen());
    EXPECT_TRUE(cell(firstLine, StructureModel::deviceColumn).contains(one.path()));
    EXPECT_TRUE(cell(secondLine, StructureModel::deviceColumn).contains(two.path()));
    for (const BusId line : {firstLine, secondLine})
        EXPECT_EQ(cell(line, StructureModel::deviceColumn).section(QStringLiteral(" ("), 0, 0),
                  findBus(shown->project().project(), line)->name);
    choose(firstLine);
    lineActions().disconnectBus->trigger();
    advance(50);
    EXPECT_FALSE(shown->plant().find(firstLine)->isOpen());
    EXPECT_TRUE(shown->plant().find(secondLine)->isOpen()) << "it is another one";
}

TEST_F(SeveralBuses, TheChosenRowIsTheBusThatIsMeantWhateverIsConnected)
{
    const PtyPair port;
    openSecondRing();
    choose(farFraba);
    planLine(secondLine, port.path());
    connectInForm(secondLine, port.path());
    EXPECT_EQ(tree().currentBus(), secondLine) << "it stays chosen";
    expectStopMeans(secondLine);

    choose(farFraba);
    lineActions().disconnectBus->trigger();
    EXPECT_EQ(tree().current(), farFraba);
    choose(secondRing);
    ringActions().disconnectBus->trigger();
    advance(50);
    EXPECT_EQ(tree().currentBus(), secondRing);
    EXPECT_FALSE(actions().stop->isEnabled());
    ringActions().connectBus->trigger();
    advance(50);
    EXPECT_EQ(tree().currentBus(), secondRing);
    expectStopMeans(secondRing);
}

TEST_F(SeveralBuses, ALineConnectedInItsFormLeavesTheChosenEncoderOfAnother)
{
    constexpr BusId thirdLine{5};
    const Place planned{thirdLine, EscLineAddress{7}.node()};
    const PtyPair port;
    plan(secondRing, u"interbus");
    plan(secondLine, u"esc");
    plan(thirdLine, u"esc");
    Project after = shown->project().project();
    setDevicesOn(after, thirdLine, {test::plannedEncoder(planned)});
    shown->project().edit(std::move(after), {});
    planLine(secondLine, port.path());
    choose(planned);
    connectInForm(secondLine, port.path());
    ASSERT_TRUE(shown->plant().find(secondLine)->isOpen());
    EXPECT_EQ(tree().current(), planned);
    EXPECT_FALSE(actions().stop->isEnabled()) << "its line is not connected";
    choose(secondLine);
    expectStopMeans(secondLine);
}

TEST_F(SeveralBuses, TheRowOfABusThatIsRemovedGivesWayToAnotherThatIsMeant)
{
    plan(secondRing, u"interbus");
    choose(test::fraba);
    choose(secondRing);
    Project after = shown->project().project();
    removeBus(after, secondRing);
    shown->project().edit(std::move(after), {});
    EXPECT_EQ(tree().current(), test::fraba) << "which the panels show";
    expectStopMeans(firstBus);
}

TEST_F(SeveralBuses, ActionsOfAKindSayWhichBusTheyMean)
{
    const QAction &disconnect = *ringActions().disconnectBus;
    const auto text = [](const QAction &action) { return plainLabel(action.text()).toStdString(); };
    EXPECT_EQ(text(disconnect), "Disconnect") << "the ring is chosen";
    choose(firstLine);
    EXPECT_EQ(text(disconnect), "Disconnect (Ring)");
    EXPECT_TRUE(disconnect.toolTip().startsWith(QStringLiteral("Ring: Leaves")));
    EXPECT_TRUE(disconnect.isEnabled()) << "there is one ring";

    openSecondRing();
    choose(firstLine);
    EXPECT_EQ(text(disconnect), "Disconnect (Ring 2)");
    for (const QAction *action : {ringActions().connectBus, ringActions().disconnectBus, ringActions().readIn,
                                  ringActions().confirmDiagnostics})
        EXPECT_FALSE(action->isEnabled()) << "none of the rings is chosen";
    ringActions().disconnectBus->trigger();
    EXPECT_TRUE(busAt(secondRing).isOpen());
    choose(test::fraba);
    EXPECT_EQ(text(disconnect), "Disconnect (Ring)");
    EXPECT_TRUE(disconnect.isEnabled());

    plan(secondLine, u"esc");
    choose(firstLine);
    EXPECT_EQ(text(*lineActions().terminal), "Terminal (Line 2)") << "Line is that of the project";
    EXPECT_TRUE(lineActions().disconnectBus->isEnabled());
    choose(test::fraba);
    EXPECT_EQ(text(*lineActions().terminal), "Terminal (Line 2)");
    EXPECT_FALSE(lineActions().disconnectBus->isEnabled());
}

TEST_F(SeveralBuses, AnEncoderThatIsSetUpIsNamedWhateverRowIsChosen)
{
    openSecondRing();
    choose(farFraba);
    choose(firstLine);
    const auto *whose = window().findChild<QLabel *>(QStringLiteral("whose"));
    EXPECT_TRUE(whose->isVisible());
    EXPECT_TRUE(whose->text().startsWith(QStringLiteral("Ring 2/1.0  "))) << whose->text().toStdString();
}

TEST_F(SeveralBuses, PanelsSayThatAPlannedEncoderIsNotConnected)
{
    openSecondRing();
    choose(farFraba);
    ringActions().disconnectBus->trigger();
    advance(50);
    EXPECT_EQ(tree().current(), farFraba);
    for (const QString &dock :
         {QStringLiteral("dialDock"), QStringLiteral("traceDock"), QStringLiteral("sequenceDock")}) {
        const auto labels = window().findChild<QDockWidget *>(dock)->findChildren<QLabel *>();
        EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel *label) {
            return label->text().startsWith(QStringLiteral("Ring 2/1.0 is not connected"));
        })) << dock.toStdString();
    }
}

TEST_F(SeveralBuses, TheStateOfARingHasItsName)
{
    const auto state = [this] {
        return window().statusBar()->findChildren<RoleLabel *>().front()->word().toStdString();
    };
    EXPECT_EQ(state(), "RUN");
    openSecondRing();
    EXPECT_EQ(state(), "Ring 2: RUN");
}

TEST_F(SeveralBuses, ARingAddedOnThePageOfTheProjectIsSeenInTheTree)
{
    choose(test::baumer);
    actions().projectPage->trigger();
    auto *buses = window().findChild<QTableView *>(QStringLiteral("projectBuses"));
    ASSERT_TRUE(buses->isVisible());
    buses->setFocus();
    QTest::keyClick(buses, Qt::Key_Insert);
    QWidget *kinds = QApplication::activePopupWidget();
    ASSERT_NE(kinds, nullptr);
    QTest::keyClick(kinds, Qt::Key_Return);
    window().activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window()));
    const BusId added = shown->project().project().buses.back().id;
    EXPECT_EQ(cell(added, StructureModel::deviceColumn), QStringLiteral("Ring 2"));
    EXPECT_EQ(cell(added, StructureModel::stateColumn), QStringLiteral("offline"));
    ASSERT_NE(shown->plant().find(added), nullptr);
    EXPECT_EQ(tree().current(), test::baumer) << "it stays chosen";

    QTest::keyClick(buses, Qt::Key_F2);
    auto *name = buses->viewport()->findChild<QLineEdit *>();
    ASSERT_NE(name, nullptr);
    QTest::keyClicks(name, QStringLiteral("Crane"));
    QTest::keyClick(name, Qt::Key_Return);
    QCoreApplication::processEvents();
    EXPECT_EQ(cell(added, StructureModel::deviceColumn), QStringLiteral("Crane"));
    QTest::keyClick(buses, Qt::Key_Delete);
    EXPECT_TRUE(cell(added, StructureModel::deviceColumn).isEmpty());
    EXPECT_TRUE(bus().isOpen());
}

TEST_F(SeveralBuses, ABusIsNotAddedWithTheNumberOfOneThatIsStillConnected)
{
    openSecondRing();
    Project after = shown->project().project();
    removeBus(after, secondRing);
    shown->project().edit(std::move(after), {});
    actions().projectPage->trigger();
    auto *buses = window().findChild<QTableView *>(QStringLiteral("projectBuses"));
    buses->setFocus();
    for (const int kind : {1, 1}) {
        QTest::keyClick(buses, Qt::Key_Insert);
        QWidget *kinds = QApplication::activePopupWidget();
        ASSERT_NE(kinds, nullptr);
        for (int i = 0; i < kind; ++i)
            QTest::keyClick(kinds, Qt::Key_Down);
        QTest::keyClick(kinds, Qt::Key_Return);
    }
    EXPECT_TRUE(busAt(secondRing).isOpen());
    EXPECT_NE(shown->plant().find(secondLine), nullptr);
}

TEST_F(SeveralBuses, TheStructureEditorPlansTheChosenRing)
{
    plan(secondRing, u"interbus");
    window().showStructureEditor();
    auto &editor = *window().findChild<StructureEditor *>();
    const auto *rows = editor.findChild<QTreeView *>(QStringLiteral("plan"))->model();
    const std::size_t before = shown->project().project().devices.size();
    choose(secondRing);
    EXPECT_EQ(editor.findChild<QComboBox *>(QStringLiteral("plannedBus"))->currentText(),
              QStringLiteral("Ring 2"));
    EXPECT_EQ(rows->rowCount(), 0);
    editor.openInsertPanel();
    auto &panel = *editor.findChild<InsertPanel *>();
    QTest::keyClicks(panel.findChild<QLineEdit *>(), QStringLiteral("OCD"));
    QTest::keyClick(panel.findChild<QLineEdit *>(), Qt::Key_Return);
    ASSERT_EQ(devicesOn(shown->project().project(), secondRing).size(), 1U);
    EXPECT_EQ(shown->project().project().devices.size(), before + 1);
    EXPECT_EQ(rows->rowCount(), 1);
    choose(test::baumer);
    EXPECT_EQ(editor.findChild<QComboBox *>(QStringLiteral("plannedBus"))->currentText(),
              QStringLiteral("Ring"));
    EXPECT_EQ(rows->rowCount(), 6);
    choose(farFraba);
    EXPECT_EQ(rows->rowCount(), 1);
    EXPECT_EQ(window().findChild<StructureView *>()->current(), farFraba) << "it stays chosen";
}

TEST_F(SeveralBuses, ALineIsPlannedWhileNothingIsConnected)
{
    ringActions().disconnectBus->trigger();
    advance(50);
    choose(test::fraba);
    plan(secondLine, u"esc");
    choose(secondLine);
    window().showStructureEditor();
    auto &editor = *window().findChild<StructureEditor *>();
    auto &bus = *editor.findChild<QComboBox *>(QStringLiteral("plannedBus"));
    EXPECT_EQ(bus.currentText(), QStringLiteral("Line")) << "not that of the device that the panels show";
    const auto insert = [&] {
        editor.openInsertPanel();
        QTest::keyClick(editor.findChild<QLineEdit *>(QStringLiteral("catalogSearch")), Qt::Key_Return);
    };
    insert();
    insert();
    EXPECT_EQ(devicesOn(shown->project().project(), secondLine).size(), 2U);
    EXPECT_EQ(bus.currentText(), QStringLiteral("Line"));
    const auto current = [&] { return window().findChild<StructureView *>()->current(); };
    EXPECT_EQ(current(), (Place{secondLine, NodeId("esc:02")})) << "what was inserted is shown by the panels";
    choose(test::fraba);
    EXPECT_EQ(bus.currentText(), QStringLiteral("Ring"));
    bus.setCurrentIndex(1);
    Q_EMIT bus.activated(1);
    EXPECT_EQ(window().findChild<StructureView *>()->currentBus(), secondLine);
    choose(test::fraba);
    EXPECT_EQ(bus.currentText(), QStringLiteral("Ring")) << "chosen again";
}

TEST_F(SeveralBuses, TheChosenBusStaysTheOneThatIsPlannedBesideALineThatIsNot)
{
    ringActions().disconnectBus->trigger();
    startAnew();
    advance(100);
    const Place last = placeOnLine({3});
    choose(last);
    actions().structureEditor->trigger();
    auto &editor = *window().findChild<StructureEditor *>();
    auto &bus = *editor.findChild<QComboBox *>(QStringLiteral("plannedBus"));
    EXPECT_TRUE(bus.isVisible());
    EXPECT_EQ(bus.currentText(), QStringLiteral("Line, not planned yet"));
    EXPECT_EQ(bus.count(), 2);
    ASSERT_TRUE(editor.isAncestorOf(QApplication::focusWidget()));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Insert);
    ASSERT_TRUE(editor.findChild<InsertPanel *>()->isVisible()) << "also where nothing is planned";
    auto &where = *editor.findChild<QComboBox *>(QStringLiteral("insertPlace"));
    EXPECT_EQ(where.currentText(), last.node.toString()) << "the chosen device";
    bus.setCurrentIndex(0);
    Q_EMIT bus.activated(0);
    for (int inserted = 1; inserted <= 2; ++inserted) {
        QTest::keyClick(editor.findChild<QLineEdit *>(QStringLiteral("catalogSearch")), Qt::Key_Return);
        advance(100);
        EXPECT_EQ(std::ssize(devicesOn(shown->project().project(), firstBus)), inserted);
        EXPECT_EQ(bus.currentText(), QStringLiteral("Ring"));
    }
    EXPECT_TRUE(devicesOn(shown->project().project(), firstLine).empty());
    const auto &plan = *editor.findChild<QTreeView *>(QStringLiteral("plan"));
    EXPECT_GE(plan.columnWidth(0), static_cast<const QAbstractItemView &>(plan).sizeHintForColumn(0));
}

TEST_F(SeveralBuses, UndoShowsTheBusOnWhichItUndoes)
{
    startAnew();
    actions().structureEditor->trigger();
    auto &editor = *window().findChild<StructureEditor *>();
    auto &bus = *editor.findChild<QComboBox *>(QStringLiteral("plannedBus"));
    editor.openInsertPanel();
    const auto insert = [&] {
        QTest::keyClick(editor.findChild<QLineEdit *>(QStringLiteral("catalogSearch")), Qt::Key_Return);
    };
    choose(firstBus);
    insert();
    choose(firstLine);
    insert();
    ASSERT_EQ(bus.currentText(), QStringLiteral("Line"));
    choose(firstBus);
    actions().undo->trigger();
    EXPECT_TRUE(devicesOn(shown->project().project(), firstLine).empty());
    EXPECT_TRUE(bus.currentText().startsWith(QStringLiteral("Line"))) << bus.currentText().toStdString();
    actions().undo->trigger();
    EXPECT_EQ(bus.currentText(), QStringLiteral("Ring"));
    EXPECT_TRUE(devicesOn(shown->project().project(), firstBus).empty());
    choose(firstLine);
    actions().redo->trigger();
    EXPECT_EQ(bus.currentText(), QStringLiteral("Ring"));
}

// A count that falls is believed: so it goes along wherever the project goes.
TEST_F(SeveralBuses, TheAccountOfABusThatIsNotConnectedGoesAlongWithTheProject)
{
    const DatabasePlace place = DatabasePlace::file(ledgerFile(folder.path()));
    const auto in = [](const QString &file) {
        return EncoderIdentity{CountedBy::place, {}, {}, ledgerProject(file), farFraba};
    };
    startAnew();
    plan(secondRing, u"interbus");
    {
        Ledger before = *Ledger::open(place); // of an earlier day, before the project had a file
        ASSERT_TRUE(before.count(*before.begin({.at = QDateTime(QDate(2026, 3, 1), QTime(12, 0), Qt::UTC),
                                                .identity = in({}).key(),
                                                .place = farFraba,
                                                .planned = 6}),
                                 6));
    }
    ASSERT_FALSE(shown->plant().find(secondRing)->isOpen());
    const QString first = folder.filePath(QStringLiteral("crane.codewheel"));
    const QString second = folder.filePath(QStringLiteral("copy.codewheel"));
    for (const QString &file : {first, second}) {
        ASSERT_TRUE(saveProject(shown->project().project(), file));
        shown->project().setFile(file);
        EXPECT_EQ(Ledger::open(place)->writes(in(file)).writes, 6) << file.toStdString();
    }
    EXPECT_EQ(Ledger::open(place)->writes(in(first)).writes, 6) << "the first one keeps its own";
    EXPECT_EQ(Ledger::open(place)->writes(in({})).writes, 0);
}

// A number stands for one bus: the project's.
TEST_F(SeveralBuses, AProjectWhoseFirstBusIsALineTakesThePlaceOfTheRing)
{
    Project project;
    project.buses = {{firstBus, QStringLiteral("esc"), QStringLiteral("Slides"), busKind(u"esc")->usual()}};
    shown->project().setProject(project, {});
    advance(50);
    ASSERT_NE(shown->plant().find(firstBus), nullptr);
    EXPECT_EQ(shown->plant().find(firstBus)->kind(), QStringLiteral("esc"));
    shown->project().setProject({}, {});
    advance(50);
    EXPECT_EQ(shown->plant().find(firstBus)->kind(), QStringLiteral("interbus"));
    choose(firstBus);
    ringActions().connectBus->trigger(); // nothing is planned: on its page
    advance(50);
    test::pressConnect(*window().findChild<ConnectPage *>(QStringLiteral("ringConnection")));
    advance(50);
    EXPECT_TRUE(bus().isOpen());
}

TEST_F(SeveralBuses, AllKindsThatTheWindowConnectsAreOffered)
{
    actions().projectPage->trigger();
    QStringList offered;
    for (QMenu *menu : window().findChildren<QMenu *>())
        if (menu->accessibleName() == QStringLiteral("Kinds of buses")) {
            Q_EMIT menu->aboutToShow();
            for (const QAction *kind : menu->actions())
                offered << plainLabel(kind->text());
        }
    EXPECT_EQ(offered, QStringList({busKind(u"interbus")->title(), busKind(u"esc")->title(),
                                    busKind(u"canopen")->title()}));
    plan(secondLine, u"canopen");
    advance(50);
    ASSERT_NE(shown->plant().find(secondLine), nullptr);
    EXPECT_EQ(shown->plant().find(secondLine)->kind(), QStringLiteral("canopen"));
}

// None of its own acts on another bus than the chosen one.
TEST_F(SeveralBuses, TheKeysForConnectingAreThoseOfTheChosenBus)
{
    const auto press = [this](Qt::Key key, Qt::KeyboardModifiers with) {
        QTest::keyClick(&window(), key, with);
        advance(50);
    };
    canActions().training->trigger();
    advance(500);
    auto *can = shown->plant().first<CanopenAtWork>();
    ASSERT_TRUE(can->isOpen());
    tree().choose(firstCanBus);
    press(Qt::Key_C, Qt::AltModifier | Qt::ShiftModifier);
    EXPECT_EQ(page()->objectName(), QStringLiteral("canSettings"));
    press(Qt::Key_F5, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_FALSE(can->isOpen());
    EXPECT_TRUE(bus().isOpen());
    tree().choose(firstBus);
    press(Qt::Key_F5, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_FALSE(bus().isOpen());
    press(Qt::Key_F5, Qt::ControlModifier);
    EXPECT_TRUE(bus().isOpen());
}

} // namespace
} // namespace codewheel
