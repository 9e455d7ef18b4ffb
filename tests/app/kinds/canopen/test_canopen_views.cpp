// SPDX-License-Identifier: GPL-3.0-or-later
// Panels, search and actions of a CAN bus in the window.
#include "app/window/help/key_list.h"
#include "app/window/window_actions.h"
#include "tests/app/kinds/canopen/canopen_window_test.h"
#include "widgets/dial/code_disc.h"
#include "widgets/dial/dial_panel.h"
#include "widgets/kinds/canopen/can_bus_panel.h"
#include "widgets/kinds/canopen/can_search_page.h"
#include "widgets/kinds/canopen/dictionary/dictionary_view.h"
#include "widgets/kinds/canopen/traffic/can_traffic_view.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/models/traffic_model.h"

#include <QDockWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QTableView>
#include <QTreeView>

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::CanopenWindowTest;
using test::nodeFive;
using test::nodeSeven;
using test::nodeSix;

class CanopenViewsTest : public test::CanopenWindowTest
{
protected:
    CanopenViewsTest()
    {
        canActions().training->trigger();
        advance(1'500);
    }

    template <typename View>
    View &view()
    {
        return *window().findChild<View *>();
    }
    QPushButton *button(const QWidget &in, const QString &text)
    {
        for (auto *found : in.findChildren<QPushButton *>())
            if (plainLabel(found->text()) == text && found->isVisibleTo(&in))
                return found;
        ADD_FAILURE() << text.toStdString();
        return nullptr;
    }
    void click(const QWidget &in, const QString &text)
    {
        if (QPushButton *found = button(in, text)) {
            EXPECT_TRUE(found->isEnabled()) << text.toStdString();
            QTest::mouseClick(found, Qt::LeftButton);
            advance(50);
        }
    }
    QMessageBox *question() { return window().findChild<QMessageBox *>(QStringLiteral("nmtQuestion")); }
    std::optional<canopen::NmtState> stateOf(int node)
    {
        const auto *heard = session().latest().heard(node);
        return heard != nullptr ? heard->state : std::nullopt;
    }
    QDockWidget &dock(const char *name)
    {
        return *window().findChild<QDockWidget *>(QString::fromLatin1(name));
    }
};

// Before a CAN bus is connected.
class CanopenViewsBeforeTest : public test::CanopenWindowTest
{
protected:
    CanBusPanel *panel() { return window().findChild<CanBusPanel *>(); }
};

TEST_F(CanopenViewsBeforeTest, AreMadeWhenOneIsShown)
{
    EXPECT_EQ(panel(), nullptr);
    QTest::keyClick(&window(), Qt::Key_N, Qt::AltModifier | Qt::ShiftModifier);
    advance(50);
    ASSERT_NE(panel(), nullptr);
    EXPECT_FALSE(panel()->visibleRegion().isEmpty());
    EXPECT_TRUE(panel()->isAncestorOf(window().focusWidget()));
    EXPECT_EQ(panel()->accessibleName(), QStringLiteral("CAN bus"));
}

TEST_F(CanopenViewsBeforeTest, TheirKeysAreListed)
{
    const auto groups = keysOf(window());
    EXPECT_TRUE(std::ranges::any_of(
        groups, [](const KeyGroup &group) { return group.title == QStringLiteral("CAN traffic"); }));
    EXPECT_NE(panel(), nullptr);
}

TEST_F(CanopenViewsBeforeTest, TheyFollowABusThatIsConnectedLater)
{
    QTest::keyClick(&window(), Qt::Key_T, Qt::AltModifier | Qt::ShiftModifier);
    canActions().training->trigger();
    advance(1'500);
    EXPECT_FALSE(panel()->visibleRegion().isEmpty());
    EXPECT_TRUE(panel()->findChild<QTableView *>()->model()->rowCount() > 0);
    window().findChild<QDockWidget *>(QStringLiteral("canTrafficDock"))->raise();
    advance(100);
    EXPECT_GT(window().findChild<CanTrafficView *>()->findChild<QTableView *>()->model()->rowCount(), 0);
}

TEST_F(CanopenViewsTest, TheKeysOpenItsPanels)
{
    // It is open already: the key hides it, and shows it again.
    for (const bool isShown : {false, true}) {
        QTest::keyClick(&window(), Qt::Key_N, Qt::AltModifier | Qt::ShiftModifier);
        advance(50);
        EXPECT_EQ(!view<CanBusPanel>().visibleRegion().isEmpty(), isShown);
    }
    QTest::keyClick(&window(), Qt::Key_T, Qt::AltModifier | Qt::ShiftModifier);
    advance(50);
    EXPECT_FALSE(view<CanTrafficView>().visibleRegion().isEmpty());
    EXPECT_GT(view<CanTrafficView>().findChild<QTableView *>()->model()->rowCount(), 0);
}

TEST_F(CanopenViewsTest, TheChosenEncoderIsTheChosenNode)
{
    canActions().nodes->trigger();
    tree().choose(nodeSix);
    advance(50);
    EXPECT_EQ(view<CanBusPanel>().chosenNode(), 6);
    tree().choose(nodeSeven);
    advance(50);
    EXPECT_EQ(view<CanBusPanel>().chosenNode(), 7);
}

TEST_F(CanopenViewsTest, TheObjectsAreThoseOfTheChosenEncoder)
{
    QTest::keyClick(&window(), Qt::Key_D, Qt::AltModifier | Qt::ShiftModifier);
    advance(50);
    const auto *objects = view<DictionaryView>().findChild<QTableView *>();
    EXPECT_FALSE(view<DictionaryView>().visibleRegion().isEmpty());
    tree().choose(nodeSix);
    advance(50);
    EXPECT_GT(objects->model()->rowCount(), 90);
}

TEST_F(CanopenViewsTest, ANodeIsStoppedOnceThatIsAgreedToAndIsSeenStopped)
{
    canActions().nodes->trigger();
    tree().choose(nodeSix);
    advance(50);
    ASSERT_NE(stateOf(6), canopen::NmtState::stopped);
    click(view<CanBusPanel>(), QStringLiteral("Stop"));
    ASSERT_NE(question(), nullptr);
    EXPECT_TRUE(question()->text().contains(QStringLiteral("6 (06h)")));
    click(*question(), QStringLiteral("Leave it"));
    advance(1'500);
    EXPECT_NE(stateOf(6), canopen::NmtState::stopped);
    click(view<CanBusPanel>(), QStringLiteral("Stop"));
    click(*question(), QStringLiteral("Stop"));
    EXPECT_TRUE(comes([this] { return stateOf(6) == canopen::NmtState::stopped; }));
    click(view<CanBusPanel>(), QStringLiteral("Start"));
    click(*question(), QStringLiteral("Start"));
    EXPECT_TRUE(comes([this] { return stateOf(6) == canopen::NmtState::operational; }));
}

TEST_F(CanopenViewsTest, WhyThereIsNoDataStartsANodeAfterTheSameQuestion)
{
    ASSERT_EQ(stateOf(6), canopen::NmtState::preOperational);
    tree().choose(nodeSix);
    actions().whyNoData->trigger();
    advance(100);
    const auto start = [this]() -> QPushButton * {
        for (auto *each : page()->findChildren<QPushButton *>())
            if (each->isVisible() && plainLabel(each->text()) == QStringLiteral("Start"))
                return each;
        return nullptr;
    };
    ASSERT_NE(start(), nullptr);
    QTest::qWait(400); // what has just come takes no click
    QTest::mouseClick(start(), Qt::LeftButton);
    advance(200);
    EXPECT_EQ(stateOf(6), canopen::NmtState::preOperational) << "it is asked first";
    ASSERT_NE(question(), nullptr);
    EXPECT_TRUE(question()->text().contains(QStringLiteral("6 (06h)")));
    click(*question(), QStringLiteral("Start"));
    EXPECT_TRUE(comes([this] { return stateOf(6) == canopen::NmtState::operational; }));
    EXPECT_EQ(start(), nullptr);
    session().send(canopen::NmtRequest{canopen::NmtCommand::stop, 6}.frame());
    EXPECT_TRUE(comes([&] { return start() != nullptr; }));
    actions().watch->trigger();
    advance(500);
    EXPECT_EQ(start(), nullptr) << "nothing is sent in Watch";
}

TEST_F(CanopenViewsTest, InWatchNoCommandIsSent)
{
    canActions().nodes->trigger();
    tree().choose(nodeSix);
    actions().watch->trigger();
    advance(200);
    EXPECT_FALSE(button(view<CanBusPanel>(), QStringLiteral("Stop"))->isEnabled());
}

TEST_F(CanopenViewsTest, WhatASearchFindsIsTakenOver)
{
    (void)session().remove(nodeFive);
    advance(50);
    ASSERT_FALSE(tree().has(nodeFive));
    canActions().search->trigger();
    EXPECT_EQ(page(), &view<CanSearchPage>());
    click(view<CanSearchPage>(), QStringLiteral("Search"));
    QTest::qWait(400); // a question takes no click at once
    click(view<CanSearchPage>(), QStringLiteral("Ask now"));
    advance(15'000);
    click(view<CanSearchPage>(), QStringLiteral("Take over"));
    EXPECT_TRUE(tree().has(nodeFive));
    EXPECT_EQ(session().encoder(nodeFive)->device().key, QStringLiteral("canopen-406-single-turn"));
}

TEST_F(CanopenViewsTest, AnEncoderIsRemovedFromTheBusAndFromTheProject)
{
    plan(QStringLiteral("can:can0"), {nodeFive, nodeSix});
    canBus().open(KindData(CanopenPlan{{.link = QStringLiteral("can:can0"), .rate = 125'000}}));
    ASSERT_TRUE(hasOpened());
    tree().choose(nodeSix);
    advance(50);
    ASSERT_TRUE(canActions().remove->isEnabled());
    canActions().remove->trigger();
    advance(50);
    EXPECT_EQ(session().places(), std::vector{nodeFive});
    EXPECT_EQ(findDevice(shown->project().project(), nodeSix), nullptr);
    EXPECT_NE(findDevice(shown->project().project(), nodeFive), nullptr);
}

// It is asked for it.
TEST_F(CanopenViewsTest, ThePositionOfANodeThatWasNotStartedIsOnTheDial)
{
    ASSERT_EQ(stateOf(6), canopen::NmtState::preOperational);
    tree().choose(nodeSix);
    advance(100);
    const auto &shown = window().findChild<DialPanel *>()->findChild<CodeDisc *>()->state();
    EXPECT_TRUE(shown.position);
    EXPECT_EQ(shown.position, session().encoder(nodeSix)->latest().position);
}

// Below a ring with many devices.
TEST_F(CanopenWindowTest, ABusThatIsNewIsScrolledTo)
{
    resizeTo({1024, 640});
    auto &rows = *window().findChild<QTreeView *>(QStringLiteral("structure"));
    const auto before = tree().row();
    canActions().training->trigger();
    advance(1'500);
    QTest::qWait(50);
    EXPECT_EQ(tree().row(), before);
    const QModelIndex bus = rows.model()->index(rows.model()->rowCount() - 1, 0);
    for (const QModelIndex &row : {bus, rows.model()->index(2, 0, bus)}) // and its last encoder
        EXPECT_TRUE(rows.viewport()->rect().contains(rows.visualRect(row)))
            << row.data().toString().toStdString();
}

TEST_F(CanopenWindowTest, ThePanelsOfACanBusComeWithIt)
{
    const auto isShown = [this](const char *name) {
        return !window().findChild<QDockWidget *>(QLatin1String(name))->isHidden();
    };
    EXPECT_FALSE(isShown("canBusDock"));
    EXPECT_FALSE(isShown("canTrafficDock"));
    canActions().training->trigger();
    EXPECT_TRUE(isShown("canBusDock"));
    EXPECT_FALSE(isShown("canTrafficDock"));
}

} // namespace
} // namespace codewheel
