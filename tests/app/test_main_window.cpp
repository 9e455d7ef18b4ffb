// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/window_test.h"
#include "tests/support/places.h"
#include "widgets/dial/code_disc.h"
#include "widgets/dial/dial_panel.h"
#include "widgets/monitor/word_card.h"
#include "widgets/structure/structure_model.h"
#include "widgets/structure/structure_view.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAccessibleInterface>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMap>
#include <QMenuBar>
#include <QScrollBar>
#include <QSize>
#include <QStatusBar>
#include <QTabBar>
#include <QTableView>
#include <QTest>
#include <QToolBar>
#include <QTreeView>
#include <QWidget>

#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class MainWindowTest : public test::WindowTest
{
protected:
    QDockWidget *dock(const char *name) { return window().findChild<QDockWidget *>(QLatin1String(name)); }
};

TEST_F(MainWindowTest, AtFirstStartTheWordsOf10AreShown)
{
    ASSERT_EQ(monitors().cards().size(), 1u);
    EXPECT_EQ(monitors().cards().front()->place(), fraba);
    EXPECT_EQ(in(fraba), 12345u);
}

TEST_F(MainWindowTest, TheMonitorFollowsTheTreeAndHasTheNameOfTheStation)
{
    window().findChild<StructureView *>()->choose(baumer);
    ASSERT_EQ(monitors().cards().size(), 1u);
    const WordCard &card = *monitors().cards().front();
    EXPECT_EQ(card.place(), baumer);
    shown->project().editDevice(baumer, {},
                                [](ProjectDevice &device) { device.station = QStringLiteral("Hoist"); });
    EXPECT_EQ(card.title(), QStringLiteral("2.0  Hoist  Baumer GXP6W K3"));
    actions().pinMonitor->trigger();
    window().findChild<StructureView *>()->choose(fraba);
    EXPECT_EQ(monitors().cards().size(), 2u);
}

TEST_F(MainWindowTest, TheDialIsPinnedAndUnpinnedByItsKey)
{
    const auto *disc = window().findChild<DialPanel *>()->findChild<CodeDisc *>();
    const auto press = [this] { QTest::keyClick(&window(), Qt::Key_3, Qt::ControlModifier); };
    press();
    EXPECT_TRUE(actions().pinDial->isChecked());
    window().findChild<StructureView *>()->choose(baumer);
    EXPECT_EQ(disc->accessibleName(), QStringLiteral("Dial of 1.0"));
    press();
    EXPECT_FALSE(actions().pinDial->isChecked());
    EXPECT_EQ(disc->accessibleName(), QStringLiteral("Dial of 2.0"));
    window().findChild<StructureView *>()->choose("6.0"_ring);
    EXPECT_FALSE(actions().pinDial->isEnabled()) << "a bus terminal has none";
}

TEST_F(MainWindowTest, NothingIsSentByOpeningChoosingAndLooking)
{
    window().findChild<StructureView *>()->choose(baumer);
    window().showWizard();
    window().showMonitors();
    advance(500);
    EXPECT_EQ(out(fraba), 0u);
    EXPECT_EQ(out(baumer), 0u);
}

TEST_F(MainWindowTest, OfAnEncoderWithoutOutItSaysWhyNothingCanBeSetUp)
{
    const QString usual = actions().wizard->toolTip();
    window().findChild<StructureView *>()->choose("3.0"_ring);
    EXPECT_TRUE(actions().wizard->toolTip().startsWith(
        QStringLiteral("The FRABA OCD-IB K1 cannot be parameterized over the bus.")));
    EXPECT_FALSE(actions().zeroOut->isEnabled());
    EXPECT_TRUE(actions().zeroOut->toolTip().startsWith(QStringLiteral("FRABA OCD-IB K1 has no OUT word")));
    window().findChild<StructureView *>()->choose(fraba);
    EXPECT_EQ(actions().wizard->toolTip(), usual);
    EXPECT_TRUE(actions().zeroOut->isEnabled());
}

TEST_F(MainWindowTest, ABusTerminalCanBeChosenAndShowsNothing)
{
    window().findChild<StructureView *>()->choose("6.0"_ring);
    advance(100);
    EXPECT_FALSE(actions().zeroOut->isEnabled()) << "it has no words";
    EXPECT_TRUE(actions().zeroOut->toolTip().startsWith(QStringLiteral("No connected device with an OUT")));
    actions().wizard->trigger();
    actions().zeroOut->trigger();
    actions().openMonitor->trigger();
    advance(100);
    EXPECT_TRUE(monitors().cards().empty());
    // nor does anybody ask for its make
    const auto *makes = window().findChild<QComboBox *>(QStringLiteral("makes"));
    ASSERT_NE(makes, nullptr);
    EXPECT_EQ(makes->count(), 0);
    EXPECT_FALSE(makes->isEnabled());
}

TEST_F(MainWindowTest, LayoutAndMonitorsAreKept)
{
    dock("messagesDock")->close();
    monitors().pin(baumer);
    window().resize(1100, 700);
    const QSize size = window().size();
    window().close();
    advance(5);
    open();
    EXPECT_FALSE(dock("messagesDock")->isVisible());
    EXPECT_EQ(window().size(), size);
    ASSERT_NE(monitors().card(baumer), nullptr);
    EXPECT_TRUE(monitors().card(baumer)->isPinned());
}

TEST_F(MainWindowTest, DefaultLayoutBringsThePanelsBack)
{
    dock("structureDock")->close();
    dock("dialDock")->close();
    actions().defaultLayout->trigger();
    EXPECT_TRUE(dock("structureDock")->isVisible());
    EXPECT_TRUE(dock("dialDock")->isVisible());
}

TEST_F(MainWindowTest, TheKeyOfAPanelBringsItToTheFrontAndHidesItWhenItIsThere)
{
    dock("traceDock")->raise();
    advance(5);
    ASSERT_TRUE(dock("messagesDock")->visibleRegion().isEmpty());
    const auto press = [this] { QTest::keyClick(&window(), Qt::Key_5, Qt::AltModifier); };
    press();
    advance(5);
    EXPECT_FALSE(dock("messagesDock")->visibleRegion().isEmpty());
    EXPECT_TRUE(dock("messagesDock")->isAncestorOf(QApplication::focusWidget()));
    press();
    EXPECT_TRUE(dock("messagesDock")->isHidden());
    press();
    advance(5);
    EXPECT_FALSE(dock("messagesDock")->visibleRegion().isEmpty());
}

TEST_F(MainWindowTest, InALowWindowTheWholeRingTheLineAndTheParametersAreSeen)
{
    window().resize(1024, 640);
    actions().defaultLayout->trigger();
    advance(50);
    EXPECT_EQ(window().size(), QSize(1024, 640));
    for (const char *name : {"structureDock", "parametersDock", "traceDock"})
        EXPECT_FALSE(dock(name)->visibleRegion().isEmpty()) << name;
    const auto *tree = dock("structureDock")->findChild<QTreeView *>();
    const auto *model = static_cast<const StructureModel *>(tree->model());
    for (const Place number : bus().places())
        EXPECT_TRUE(tree->viewport()->rect().contains(tree->visualRect(model->indexOf(number)).center()))
            << number.toString().toStdString();
    EXPECT_TRUE(tree->viewport()->rect().contains(tree->visualRect(model->indexOf(firstLine)).center()));
    const auto *table = dock("parametersDock")->findChild<QTableView *>();
    EXPECT_GE(table->viewport()->height(), 5 * table->rowHeight(0)) << "all that can be written is seen";
    dock("trainingDock")->raise();
    advance(5);
    EXPECT_EQ(window().size(), QSize(1024, 640));
}

TEST_F(MainWindowTest, FitsInto1024By640)
{
    window().resize(1024, 640);
    advance(5);
    EXPECT_LE(window().minimumSizeHint().width(), 1024);
    EXPECT_LE(window().minimumSizeHint().height(), 640);
    EXPECT_EQ(window().size(), QSize(1024, 640));
}

TEST_F(MainWindowTest, WatchAndOperateAreTold)
{
    EXPECT_TRUE(actions().operate->isChecked());
    actions().watch->trigger();
    advance(50);
    EXPECT_TRUE(actions().watch->isChecked());
    EXPECT_FALSE(bus().isOperating());
    bus().channel(fraba)->stage(1);
    EXPECT_FALSE(bus().channel(fraba)->write());
    EXPECT_EQ(bus().channel(fraba)->staged(), Word{1}) << "nothing is lost";
    actions().operate->trigger();
    advance(50);
    EXPECT_TRUE(bus().isOperating());
}

TEST_F(MainWindowTest, PanelsThatStayAtADeviceWhileABusIsChosenSayAtWhich)
{
    auto &tree = *window().findChild<StructureView *>();
    tree.choose(baumer);
    EXPECT_EQ(dock("parametersDock")->windowTitle(), QStringLiteral("Parameters"));
    tree.choose(firstBus);
    advance(50);
    for (const char *name : {"parametersDock", "dialDock", "deviceDock"})
        EXPECT_TRUE(dock(name)->windowTitle().endsWith(QStringLiteral("(2.0)")))
            << dock(name)->windowTitle().toStdString();
    tree.choose(fraba);
    EXPECT_EQ(dock("parametersDock")->windowTitle(), QStringLiteral("Parameters"));
}

TEST_F(MainWindowTest, TheStateStaysInSightWhileTheStatusLineTellsOfSomethingElse)
{
    const auto inStatusLine = [this](const QString &text) {
        for (const QLabel *label : window().statusBar()->findChildren<QLabel *>())
            if (label->isVisible() && label->text() == text)
                return true;
        return false;
    };
    resizeTo({1920, 1080}); // with room for it
    window().statusBar()->showMessage(QStringLiteral("a bit"));
    EXPECT_TRUE(inStatusLine(QStringLiteral("RUN")));
    EXPECT_TRUE(inStatusLine(QStringLiteral("a bit")));
    window().statusBar()->clearMessage();
    EXPECT_FALSE(inStatusLine(QStringLiteral("a bit")));
}

TEST_F(MainWindowTest, TheWritesOfAnEncoderWithoutAMakeAreShownWithItsProfile)
{
    ASSERT_TRUE(bus().name(baumer, {}));
    advance(50);
    window().findChild<StructureView *>()->choose(baumer);
    advance(50);
    const auto labels = window().statusBar()->findChildren<QLabel *>();
    EXPECT_TRUE(std::ranges::any_of(
        labels, [](const QLabel *label) { return label->text().startsWith(QStringLiteral("2.0 K3: ")); }));
}

TEST_F(MainWindowTest, StartAndStopFollowTheBus)
{
    EXPECT_FALSE(actions().start->isEnabled());
    actions().stop->trigger();
    advance(50);
    EXPECT_TRUE(actions().start->isEnabled());
    EXPECT_FALSE(actions().stop->isEnabled());
    actions().start->trigger();
    advance(50);
    EXPECT_TRUE(bus().isRunning());
    EXPECT_TRUE(actions().stop->isEnabled());
}

// Every control has an accessible name, a tooltip and a way to it by keys
TEST_F(MainWindowTest, EveryControlHasANameAndATooltip)
{
    window().showWizard();
    advance(5);
    window().showMonitors();
    int controls = 0;
    for (QWidget *widget : window().findChildren<QWidget *>()) {
        const bool isControl = qobject_cast<QAbstractButton *>(widget) || qobject_cast<QLineEdit *>(widget) ||
                               qobject_cast<QComboBox *>(widget) ||
                               qobject_cast<QAbstractSpinBox *>(widget) ||
                               qobject_cast<QAbstractSlider *>(widget);
        // parts of Qt's own widgets: spin box editors, scroll bars, dock and tab bar buttons
        const QWidget *owner = widget->parentWidget();
        const bool isPart = qobject_cast<QScrollBar *>(widget) || widget->objectName().startsWith(u"qt_") ||
                            qobject_cast<const QAbstractSpinBox *>(owner) ||
                            qobject_cast<const QLineEdit *>(owner) || qobject_cast<const QTabBar *>(owner) ||
                            qobject_cast<const QTableView *>(owner) ||
                            qobject_cast<const QToolBar *>(owner) || qobject_cast<const QMenuBar *>(owner);
        if (!isControl || isPart || widget->isHidden())
            continue;
        ++controls;
        const QAccessibleInterface *accessible = QAccessible::queryAccessibleInterface(widget);
        ASSERT_NE(accessible, nullptr);
        EXPECT_FALSE(accessible->text(QAccessible::Name).isEmpty())
            << widget->metaObject()->className() << " in "
            << widget->parentWidget()->metaObject()->className();
        EXPECT_FALSE(widget->toolTip().isEmpty())
            << widget->metaObject()->className() << " " << accessible->text(QAccessible::Name).toStdString()
            << " in " << widget->parentWidget()->metaObject()->className();
    }
    EXPECT_GE(controls, 200);
}

// A key of the window works everywhere, so no view may use it too; two views may use the same key.
TEST_F(MainWindowTest, KeysAreGivenOnce)
{
    QMap<QString, QString> keys;
    std::vector<const QAction *> ofViews;
    for (const QAction *action : window().findChildren<QAction *>()) {
        if (action->shortcut().isEmpty())
            continue;
        if (action->shortcutContext() == Qt::WidgetWithChildrenShortcut ||
            action->shortcutContext() == Qt::WidgetShortcut) {
            ofViews.push_back(action);
            continue;
        }
        const QString key = action->shortcut().toString();
        EXPECT_FALSE(keys.contains(key)) << key.toStdString() << ": " << action->text().toStdString()
                                         << " and " << keys.value(key).toStdString();
        keys.insert(key, action->text());
    }
    EXPECT_TRUE(keys.contains(QStringLiteral("Ctrl+F12")));
    EXPECT_FALSE(ofViews.empty());
    for (const QAction *action : ofViews)
        EXPECT_FALSE(keys.contains(action->shortcut().toString()))
            << action->shortcut().toString().toStdString() << ": " << action->text().toStdString() << " and "
            << keys.value(action->shortcut().toString()).toStdString();
}

} // namespace
} // namespace codewheel
