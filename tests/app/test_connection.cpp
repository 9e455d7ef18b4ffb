// SPDX-License-Identifier: GPL-3.0-or-later
// Offline and online in the window.
#include "app/window/kinds/interbus/ring_connection.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "widgets/kinds/interbus/master/ring_comparison.h"
#include "widgets/structure/structure_view.h"
#include "widgets/structure_editor/plan_edits.h"
#include "widgets/structure_editor/structure_editor.h"

#include <QAbstractItemModel>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QPushButton>
#include <QStatusBar>
#include <QTableView>
#include <QTest>
#include <QTreeView>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;
using test::Question;

class ConnectionTest : public test::WindowTest
{
protected:
    QAbstractItemModel &tree()
    {
        return *window().findChild<QTreeView *>(QStringLiteral("structure"))->model();
    }
    QString row(int row, int column = 0)
    {
        return tree().index(row, column, tree().index(0, 0)).data().toString();
    }
    QAbstractItemModel &lines()
    {
        return *window()
                    .findChild<RingComparison *>()
                    ->findChild<QTableView *>(QStringLiteral("comparison"))
                    ->model();
    }
    QStringList messages()
    {
        QStringList texts;
        MessageModel &model = shown->messages();
        model.catchUp();
        for (int i = 0; i < model.rowCount(); ++i)
            for (int column = 0; column < model.columnCount(); ++column)
                texts << model.index(i, column).data().toString();
        return texts;
    }
    void removeBaumer()
    {
        const Catalog catalog = Catalog::builtIn();
        ProjectDocument &document = shown->project();
        ASSERT_TRUE(PlanEdits(document, catalog).remove({document.ids(firstBus)[1]}));
    }
};

TEST_F(ConnectionTest, OfflineTheTreeShowsTheProject)
{
    ringActions().disconnectBus->trigger();
    advance(5);
    EXPECT_FALSE(bus().isOpen());
    EXPECT_EQ(row(1), QStringLiteral("2.0  Baumer GXP6W K3"));
    EXPECT_EQ(row(1, 1), QStringLiteral("planned"));
    EXPECT_TRUE(monitors().cards().empty());
    EXPECT_TRUE(ringActions().connectBus->isEnabled());
    EXPECT_FALSE(actions().start->isEnabled());
    removeBaumer();
    EXPECT_EQ(row(1), QStringLiteral("2.0  FRABA OCD-IB K1"));
}

TEST_F(ConnectionTest, ConnectingAgainBringsAllBack)
{
    const std::size_t open = monitors().cards().size();
    ASSERT_GT(open, 0u);
    ringActions().disconnectBus->trigger();
    advance(5);
    ringActions().connectBus->trigger();
    advance(100);
    EXPECT_TRUE(bus().isRunning());
    EXPECT_EQ(monitors().cards().size(), open);
    EXPECT_EQ(row(1, 1), QStringLiteral("ok"));
    EXPECT_EQ(bus().encoder(fraba)->known(Parameter::startUpMode)->value, 1) << "as it was told before";
    EXPECT_TRUE(messages().join(u'|').contains(QStringLiteral("as the project says")))
        << messages().join(u'|').toStdString();
    window().showFrame();
}

TEST_F(ConnectionTest, DisconnectingAsksForOutWordsThatAreNotZero)
{
    send(fraba, 0x0000'0001);
    {
        const Question question = Question::answeredBy(QStringLiteral("Cancel"));
        ringActions().disconnectBus->trigger();
        EXPECT_TRUE(question.text().contains(QStringLiteral("OUT 1.0 is 00000001")));
    }
    EXPECT_TRUE(bus().isOpen());
    const Question question = Question::answeredBy(QStringLiteral("Set to 00000000"));
    ringActions().disconnectBus->trigger();
    advance(50);
    EXPECT_FALSE(bus().isOpen());
}

TEST_F(ConnectionTest, TheKeyOfAnActionThatIsDisabledSaysWhy)
{
    const auto press = [this] {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F5, Qt::ControlModifier | Qt::ShiftModifier);
        advance(50);
    };
    window().findChild<StructureView *>()->choose(fraba);
    window().findChild<StructureView *>()->setFocus();
    press();
    ASSERT_FALSE(bus().isOpen());
    EXPECT_EQ(window().statusBar()->currentMessage(), QString());
    window().findChild<StructureView *>()->choose(firstBus);
    press();
    EXPECT_TRUE(
        window().statusBar()->currentMessage().startsWith(QStringLiteral("Not possible now: Disconnect")))
        << window().statusBar()->currentMessage().toStdString();
    EXPECT_TRUE(window().statusBar()->currentMessage().endsWith(QStringLiteral("The ring is not connected.")))
        << window().statusBar()->currentMessage().toStdString();
}

TEST_F(ConnectionTest, StationsOfTheProjectStandInTheTree)
{
    shown->project().editDevice(baumer, {},
                                [](ProjectDevice &device) { device.station = QStringLiteral("hoist"); });
    EXPECT_EQ(row(1), QStringLiteral("hoist  2.0  Baumer GXP6W K3"));
    shown->project().undoStack().undo();
    EXPECT_EQ(row(1), QStringLiteral("2.0  Baumer GXP6W K3"));
}

TEST_F(ConnectionTest, NothingDiffersAtFirst)
{
    QTest::keyClick(&window(), Qt::Key_F9);
    auto &page = *window().findChild<RingComparison *>();
    EXPECT_TRUE(page.isVisible());
    EXPECT_EQ(page.differences(), 0);
    EXPECT_EQ(lines().rowCount(), 7);
}

TEST_F(ConnectionTest, WhatDiffersIsTakenOverIntoTheProjectAndUndone)
{
    removeBaumer();
    QTest::keyClick(&window(), Qt::Key_F9);
    auto &page = *window().findChild<RingComparison *>();
    EXPECT_EQ(page.differences(), 1);
    auto *only = page.findChild<QCheckBox *>(QStringLiteral("onlyDifferences"));
    only->click();
    ASSERT_EQ(lines().rowCount(), 1);
    EXPECT_TRUE(lines().index(0, 1).data().toString().contains(QStringLiteral("Baumer")));
    QTest::mouseClick(page.findChild<QPushButton *>(QStringLiteral("allIntoProject")), Qt::LeftButton);
    EXPECT_EQ(page.differences(), 0);
    EXPECT_EQ(shown->project().project().devices.at(1).participant.deviceCode, 0x0237U);
    shown->project().undoStack().undo();
    EXPECT_EQ(page.differences(), 1);
}

TEST_F(ConnectionTest, AKeyOpensTheStructureEditorAtTheChosenDevice)
{
    window().findChild<StructureView *>()->choose(baumer);
    QTest::keyClick(&window(), Qt::Key_F4);
    auto &editor = *window().findChild<StructureEditor *>();
    ASSERT_TRUE(editor.isVisible());
    const auto *plan = editor.findChild<QTreeView *>(QStringLiteral("plan"));
    EXPECT_EQ(plan->currentIndex().siblingAtColumn(0).data().toString(), QStringLiteral("2.0"));
}

} // namespace
} // namespace codewheel
