// SPDX-License-Identifier: GPL-3.0-or-later
// The page on which a CAN bus is connected, and what it asks.
#include "app/window/kinds/canopen/can_interface_rows.h"
#include "app/window/window_actions.h"
#include "tests/app/kinds/canopen/canopen_window_test.h"
#include "tests/app/press_connect.h"
#include "widgets/comparison/comparison_page.h"
#include "widgets/connect/check_list.h"
#include "widgets/kinds/canopen/can_settings_form.h"
#include "widgets/look/inline_message.h"

#include <QLabel>
#include <QMessageBox>
#include <QStatusBar>
#include <QUndoStack>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::nodeFive;
using test::nodeSix;

class CanopenConnection : public test::CanopenWindowTest
{
protected:
    ConnectPage &connection() { return *window().findChild<ConnectPage *>(QStringLiteral("canSettings")); }
    InlineMessage &notice() { return *window().findChild<InlineMessage *>(QStringLiteral("canNotice")); }
    void choose(const QString &link)
    {
        connection().findChild<QComboBox *>(QStringLiteral("link"))->setCurrentText(link);
    }
    // As the user types it.
    void typeInterface(const QString &name)
    {
        canActions().settings->trigger();
        choose(QStringLiteral("CAN interface"));
        for (auto *form : connection().findChildren<CanSettingsForm *>())
            if (form->isVisible())
                form->showPlan(KindData(CanopenPlan{{.link = QStringLiteral("can:") + name}}));
    }
    void connectTo(const QString &name)
    {
        typeInterface(name);
        test::pressConnect(connection());
    }
    void click(const QWidget &in, const QString &text)
    {
        for (auto *found : in.findChildren<QPushButton *>())
            if (plainLabel(found->text()) == text && found->isVisibleTo(&in)) {
                EXPECT_TRUE(found->isEnabled()) << text.toStdString();
                QTest::mouseClick(found, Qt::LeftButton);
                return;
            }
        ADD_FAILURE() << text.toStdString();
    }
    // Of the messages of the page that are seen.
    QString said()
    {
        QStringList sentences;
        for (const auto *message : connection().findChildren<InlineMessage *>())
            if (message->isVisibleTo(&connection()))
                sentences << message->sentence();
        return sentences.join(u'\n');
    }
};

TEST_F(CanopenConnection, TheKeyOpensThePageAndTheProjectHasWhatWasConnected)
{
    QTest::keyClick(&window(), Qt::Key_F8, Qt::ControlModifier);
    EXPECT_EQ(page(), &connection());
    connectTo(QStringLiteral("can0"));
    ASSERT_TRUE(hasOpened());
    ASSERT_EQ(bench.made.size(), 1U);
    EXPECT_EQ(bench.made.front().where, QStringLiteral("can0"));
    const CanopenPlan *planned = canopenPlan(shown->project().project(), firstCanBus);
    ASSERT_NE(planned, nullptr);
    EXPECT_EQ(planned->settings.link, QStringLiteral("can:can0"));
    EXPECT_TRUE(shown->project().undoStack().undoText().contains(QStringLiteral("CAN bus")));
    canActions().disconnectBus->trigger();
    EXPECT_FALSE(canBus().isOpen());
}

TEST_F(CanopenConnection, TheTrainingBusIsConnectedByItsAction)
{
    canActions().training->trigger();
    advance(200);
    EXPECT_TRUE(canBus().isOpen());
    EXPECT_TRUE(tree().has(nodeSix));
    EXPECT_FALSE(canActions().training->isEnabled());
    EXPECT_TRUE(canActions().afresh->isEnabled());
    EXPECT_EQ(canopenPlan(shown->project().project(), firstCanBus), nullptr); // nothing is kept of it
    canActions().afresh->trigger();
    advance(100);
    EXPECT_TRUE(canBus().isOpen());
}

TEST_F(CanopenConnection, AnAdapterThatMayAcknowledgeIsOpenedOnceTheUserAgrees)
{
    bench.listensOnly = false;
    connectTo(QStringLiteral("can0"));
    ASSERT_TRUE(comes([this] { return !canBus().isOpening(); }));
    EXPECT_FALSE(canBus().isOpen());
    EXPECT_TRUE(said().contains(QStringLiteral("listen-only on"))) << said().toStdString();
    click(connection(), QStringLiteral("Watch all the same"));
    EXPECT_TRUE(hasOpened());
}

TEST_F(CanopenConnection, WhatIsMissingIsSaidWithTheCommandThatHelps)
{
    bench.isMissing = true;
    connectTo(QStringLiteral("can0"));
    ASSERT_TRUE(comes([this] { return !canBus().isOpening(); }));
    EXPECT_TRUE(said().contains(QStringLiteral("There is no CAN interface can0"))) << said().toStdString();
    EXPECT_EQ(canopenPlan(shown->project().project(), firstCanBus), nullptr);
}

TEST_F(CanopenConnection, TheTestListensAndTellsWhoIsHeard)
{
    plan(QStringLiteral("can:can0"), {nodeSix});
    canActions().settings->trigger();
    click(connection(), QStringLiteral("Test"));
    ASSERT_TRUE(comes([this] { return connection().steps().count() == 3; }));
    ASSERT_TRUE(comes([this] { return !connection().isTesting(); }));
    EXPECT_EQ(bench.sent, 0);
    QStringList told;
    for (const auto *label : connection().steps().findChildren<QLabel *>())
        told << label->text();
    EXPECT_TRUE(told.join(u'\n').contains(QStringLiteral("Node 6 (06h)"))) << told.join(u'\n').toStdString();
    EXPECT_FALSE(canBus().isOpen());
}

TEST_F(CanopenConnection, OperateAsksOnARealBusAndNothingIsSentBefore)
{
    plan(QStringLiteral("can:can0"), {nodeFive});
    connectTo(QStringLiteral("can0"));
    ASSERT_TRUE(hasOpened());
    tree().choose(nodeFive);
    advance(300);
    EXPECT_EQ(bench.sent, 0);
    actions().operate->trigger();
    auto *question = window().findChild<QMessageBox *>(QStringLiteral("operateQuestion"));
    ASSERT_NE(question, nullptr);
    EXPECT_TRUE(question->text().contains(QStringLiteral("This CAN bus is real")));
    EXPECT_EQ(bench.sent, 0);
    click(*question, QStringLiteral("Operate"));
    EXPECT_TRUE(comes([this] { return session().isOperating() && bench.sent > 0; }));
}

TEST_F(CanopenConnection, SilenceIsSaidBeforeOperateAndJ1939HoldsBack)
{
    for (std::size_t each = 0; each < canopen::trainingEncoders().size(); ++each)
        bench.plant.withEncoder(each, [](canopen::SimulatedNode &node) { node.setOn(false); });
    plan(QStringLiteral("can:can0"), {nodeFive});
    connectTo(QStringLiteral("can0"));
    ASSERT_TRUE(hasOpened());
    tree().choose(nodeFive);
    actions().operate->trigger();
    auto *question = window().findChild<QMessageBox *>(QStringLiteral("operateQuestion"));
    ASSERT_NE(question, nullptr);
    EXPECT_TRUE(
        question->informativeText().startsWith(QStringLiteral("Nothing was heard on the bus so far")));
    auto other = std::make_shared<SimulatedCanAdapter>(125'000, Instant());
    bench.plant.bus()->add(other);
    bench.plant.bus()->locked([&] {
        other->open(CanUse::operate);
        return other->queue({.id = 0x0CFFE0E0, .isExtended = true});
    });
    ASSERT_TRUE(comes([this] { return session().latest().figures.received > 0; }));
    click(*question, QStringLiteral("Operate"));
    ASSERT_TRUE(comes([this] { return session().isOperating() && notice().isVisibleTo(&window()); }));
    EXPECT_TRUE(notice().sentence().contains(QStringLiteral("J1939")));
    EXPECT_EQ(bench.sent, 0);
    click(notice(), QStringLiteral("Send all the same"));
    EXPECT_TRUE(comes([this] { return bench.sent > 0; }));
}

TEST_F(CanopenConnection, BesideAnotherMasterTheUserIsAskedBeforeAnythingIsSent)
{
    canActions().training->trigger();
    auto plc = std::make_shared<SimulatedCanAdapter>(125'000, Instant());
    canBus().training()->bus()->add(plc);
    canBus().training()->bus()->locked([&] {
        plc->open(CanUse::operate);
        return plc->queue({.id = 0x80}); // SYNC
    });
    ASSERT_TRUE(comes([this] { return session().latest().isHeldBack(); }));
    advance(50);
    ASSERT_TRUE(notice().isVisibleTo(&window()));
    EXPECT_TRUE(notice().sentence().contains(QStringLiteral("SYNC")));
    click(notice(), QStringLiteral("Send all the same"));
    EXPECT_TRUE(comes([this] { return !session().latest().isHeldBack(); }));
    EXPECT_FALSE(notice().isVisibleTo(&window()));
}

TEST_F(CanopenConnection, TheStatusLineTellsAdapterRateLoadAndWhoIsHeard)
{
    canActions().training->trigger();
    tree().choose(nodeSix);
    advance(1'500);
    const auto shownTexts = [this] {
        QStringList texts;
        for (const auto *label : window().statusBar()->findChildren<QLabel *>())
            if (label->isVisible())
                texts << label->text();
        return texts.join(u'\n');
    };
    EXPECT_TRUE(shownTexts().contains(QStringLiteral("125 kBit/s, load "))) << shownTexts().toStdString();
    EXPECT_TRUE(shownTexts().contains(QStringLiteral("3 of 3 heard"))) << shownTexts().toStdString();
    for (const Place place : session().places())
        (void)session().remove(place);
    advance(500);
    EXPECT_TRUE(shownTexts().contains(QStringLiteral("nodes heard: 3"))) << shownTexts().toStdString();
}

TEST(CanInterfacesOfTheForm, TellWhatTheSystemTellsAndTheCommandThatHelps)
{
    const CanInterfaceRows rows =
        canInterfaceRows({{.name = QStringLiteral("can0")},
                          {.name = QStringLiteral("can1"),
                           .isUp = true,
                           .status = {.state = CanState::active, .rate = 83'333, .listensOnly = true}},
                          {.name = QStringLiteral("can2"),
                           .isUp = true,
                           .status = {.state = CanState::busOff, .rate = 125'000}},
                          {.name = QStringLiteral("can3"), .isUp = true, .status = {.listensOnly = false}}});
    ASSERT_EQ(rows.rows.size(), 4U);
    EXPECT_EQ(rows.rows[0].state, QStringLiteral("switched off"));
    EXPECT_EQ(rows.rows[0].trouble(250'000).command,
              QStringLiteral("sudo ip link set can0 up type can bitrate 250000"));
    EXPECT_EQ(rows.rows[1].state, QStringLiteral("on, 83.333 kBit/s, no errors, listens only"));
    EXPECT_EQ(rows.rows[1].trouble(125'000), Trouble());
    EXPECT_EQ(rows.rows[2].trouble(125'000).command,
              QStringLiteral("sudo ip link set can2 type can restart"));
    EXPECT_TRUE(rows.rows[3].trouble(125'000).command.contains(QStringLiteral("listen-only on")));
    EXPECT_FALSE(canInterfaceRows({}).none.sentence.isEmpty());
}

} // namespace
} // namespace codewheel
