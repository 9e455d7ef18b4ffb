// SPDX-License-Identifier: GPL-3.0-or-later
// Which device the panels show, and editing the project while nothing is connected.
#include "kinds/interbus/ring/ring_edit.h"
#include "tests/app/window_test.h"
#include "tests/support/places.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/cams/cam_sheet.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/structure/structure_view.h"
#include "widgets/structure_editor/plan_edits.h"
#include "widgets/structure_editor/structure_editor.h"

#include <QAction>
#include <QModelIndex>
#include <QTest>
#include <QTreeView>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class OfflineEditing : public test::WindowTest
{
protected:
    void goOffline()
    {
        ringActions().disconnectBus->trigger();
        advance(5);
        ASSERT_FALSE(bus().isOpen());
    }
    StructureView &tree() { return *window().findChild<StructureView *>(); }
    StructureEditor &editor() { return *window().findChild<StructureEditor *>(); }
    QTreeView &plan() { return *editor().findChild<QTreeView *>(QStringLiteral("plan")); }
    ParameterModel &parameters() { return *window().findChild<ParameterModel *>(); }
    QString chosenInPlan() { return plan().currentIndex().siblingAtColumn(0).data().toString(); }
    void chooseInPlan(int row)
    {
        const QModelIndex index = plan().model()->index(row, 0);
        plan().scrollTo(index);
        QTest::mouseClick(plan().viewport(), Qt::LeftButton, {}, plan().visualRect(index).center());
    }
    bool want(std::int64_t steps)
    {
        return parameters().setData(parameters().index(0, ParameterModel::wantedColumn), qlonglong{steps},
                                    Qt::EditRole);
    }
    ParameterValues wanted(Place number) { return shown->project().device(number).wanted; }
};

TEST_F(OfflineEditing, WhatIsUndoneOfAnotherEncoderIsShown)
{
    ASSERT_TRUE(want(4096));
    tree().choose(baumer);
    QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(wanted(fraba).empty());
    EXPECT_EQ(tree().current(), fraba);
    tree().choose(baumer);
    actions().redo->trigger();
    EXPECT_EQ(wanted(fraba), (ParameterValues{{Parameter::steps, 4096}}));
    EXPECT_EQ(tree().current(), fraba);
}

TEST_F(OfflineEditing, WantedValuesOfThePlannedEncoderAreEdited)
{
    goOffline();
    EXPECT_EQ(tree().current(), fraba) << "it stays chosen";
    ASSERT_TRUE(want(4096));
    EXPECT_EQ(wanted(fraba), (ParameterValues{{Parameter::steps, 4096}}));
    tree().choose(baumer);
    ASSERT_TRUE(want(255));
    EXPECT_EQ(wanted(baumer), (ParameterValues{{Parameter::steps, 255}}));
    actions().undo->trigger();
    EXPECT_TRUE(wanted(baumer).empty());
    EXPECT_EQ(wanted(fraba).size(), 1U);
    ringActions().connectBus->trigger();
    advance(50);
    EXPECT_EQ(tree().current(), baumer);
    ASSERT_TRUE(want(256)) << "connected, it is the same column";
    EXPECT_EQ(wanted(baumer), (ParameterValues{{Parameter::steps, 256}}));
}

TEST_F(OfflineEditing, CamsOfThePlannedEncoderAreEdited)
{
    goOffline();
    ASSERT_TRUE(actions().cams->isEnabled());
    QTest::keyClick(&window(), Qt::Key_F8);
    const auto &cams = *window().findChild<CamEditor *>();
    EXPECT_TRUE(cams.isVisible());
    cams.findChild<CamSheet *>()->setCam(2, {.start = 5, .stop = 10, .active = true}, {});
    EXPECT_EQ(shown->project().device(fraba).wantedCams.size(), 1U);
    tree().choose(baumer);
    EXPECT_FALSE(actions().cams->isEnabled());
}

TEST_F(OfflineEditing, NothingThatSendsCanBeAskedFor)
{
    goOffline();
    for (const QAction *action : {actions().wizard, actions().zeroOut, actions().replaceEncoder,
                                  actions().restoreValues, actions().openMonitor, actions().pinMonitor})
        EXPECT_FALSE(action->isEnabled()) << action->text().toStdString();
    for (const QAction *action : {actions().wizard, actions().zeroOut, actions().replaceEncoder})
        EXPECT_TRUE(action->toolTip().startsWith(QStringLiteral("Not connected")))
            << action->toolTip().toStdString();
}

TEST_F(OfflineEditing, NorOfAPlannedDeviceThatIsNoEncoder)
{
    goOffline();
    tree().choose("6.0"_ring);
    EXPECT_FALSE(actions().zeroOut->isEnabled());
}

TEST_F(OfflineEditing, ATraceIsExportedWhereThereIsOne)
{
    EXPECT_TRUE(actions().exportTrace->isEnabled());
    tree().choose(placeOnLine({0x05}));
    EXPECT_FALSE(actions().exportTrace->isEnabled()) << "it has a terminal";
    EXPECT_TRUE(actions().exportTrace->toolTip().startsWith(QStringLiteral("No connected encoder")));
    tree().choose(fraba);
    EXPECT_TRUE(actions().exportTrace->isEnabled());
    goOffline();
    EXPECT_FALSE(actions().exportTrace->isEnabled());
}

TEST_F(OfflineEditing, WhoChoosesKeepsTheFocus)
{
    auto *devices = tree().findChild<QTreeView *>();
    devices->setFocus();
    QTest::keyClick(devices, Qt::Key_Down);
    EXPECT_EQ(tree().current(), baumer);
    EXPECT_TRUE(devices->hasFocus());
    QTest::keyClick(&window(), Qt::Key_F4);
    chooseInPlan(3);
    EXPECT_TRUE(plan().hasFocus());
}

TEST_F(OfflineEditing, TreeAndStructureEditorFollowEachOther)
{
    goOffline();
    QTest::keyClick(&window(), Qt::Key_F4);
    tree().choose("5.0"_ring);
    EXPECT_EQ(chosenInPlan(), QStringLiteral("5.0"));
    chooseInPlan(1);
    EXPECT_EQ(tree().current(), baumer);
    ASSERT_TRUE(want(255));
    EXPECT_EQ(wanted(baumer).size(), 1U);
}

TEST_F(OfflineEditing, ADeviceStaysChosenWhileThePlanIsEdited)
{
    goOffline();
    QTest::keyClick(&window(), Qt::Key_F4);
    chooseInPlan(1);
    ASSERT_TRUE(want(255));
    QTest::keyClick(&plan(), Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(wanted(fraba).size(), 1U) << "Baumer is the first now";
    EXPECT_EQ(tree().current(), fraba);
    EXPECT_EQ(chosenInPlan(), QStringLiteral("1.0"));
    ASSERT_TRUE(want(256));
    EXPECT_EQ(wanted(fraba), (ParameterValues{{Parameter::steps, 256}}));
    actions().undo->trigger();
    actions().undo->trigger();
    EXPECT_EQ(tree().current(), baumer);
    EXPECT_EQ(chosenInPlan(), QStringLiteral("2.0"));
}

TEST_F(OfflineEditing, OfADeviceThatIsRemovedTheNextOneIsShown)
{
    goOffline();
    QTest::keyClick(&window(), Qt::Key_F4);
    chooseInPlan(1);
    QTest::keyClick(&plan(), Qt::Key_Delete, Qt::ControlModifier);
    EXPECT_EQ(shown->project().project().devices.size(), 6U);
    ASSERT_TRUE(tree().current().has_value());
    EXPECT_EQ(tree().current()->toString(), chosenInPlan());
    ASSERT_TRUE(shown->project().idAt(*tree().current()));
}

TEST_F(OfflineEditing, SeveralStaySelectedInTheStructureEditor)
{
    QTest::keyClick(&window(), Qt::Key_F4);
    chooseInPlan(0);
    QTest::keyClick(&plan(), Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_EQ(plan().selectionModel()->selectedRows().size(), 2);
    EXPECT_EQ(tree().current(), baumer);
}

TEST_F(OfflineEditing, APlannedDeviceThatIsNotConnectedIsEditedWhileTheRingRuns)
{
    const Catalog catalog = Catalog::builtIn();
    PlanEdits edits(shown->project(), catalog);
    const Participant same = shown->project().device(baumer).participant;
    ASSERT_TRUE(edits.insert(same, KindData(RingPlace{.terminal = {}, .onLocalBus = false, .row = 1000})));
    const Place added = shown->project().project().devices.back().place();
    QTest::keyClick(&window(), Qt::Key_F4);
    plan().setCurrentIndex(plan().model()->index(plan().model()->rowCount() - 1, 0));
    EXPECT_EQ(tree().current(), std::nullopt);
    ASSERT_TRUE(want(77));
    EXPECT_EQ(wanted(added), (ParameterValues{{Parameter::steps, 77}}));
    tree().choose(fraba);
    EXPECT_EQ(chosenInPlan(), QStringLiteral("1.0"));
}

} // namespace
} // namespace codewheel
