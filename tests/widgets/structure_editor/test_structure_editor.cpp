// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/plan/ring_plan.h"
#include "tests/support/places.h"
#include "tests/support/plans.h"
#include "tests/widgets/structure_editor/plan_test.h"
#include "widgets/kinds/interbus/master/ring_plan_fields.h"
#include "widgets/look/inline_message.h"
#include "widgets/structure_editor/plan_model.h"
#include "widgets/structure_editor/structure_editor.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QDragMoveEvent>
#include <QDropEvent>
#include <QEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QModelIndex>
#include <QPoint>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class StructureEditorTest : public test::PlanTest
{
protected:
    StructureEditorTest()
    {
        editor.addFields(firstBus, new RingPlanFields(document, firstBus));
        editor.resize(900, 620);
        editor.show();
        editor.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&editor));
        choose(QStringLiteral("1.0"));
        tree.setFocus();
    }

    void choose(const QString &number) { editor.choose(*Place::parse(number)); }
    QModelIndex indexOf(const QString &number, int column = test::numberColumn) const
    {
        return static_cast<PlanModel *>(tree.model())->indexOf(id(number), column);
    }
    QString current() const { return tree.currentIndex().siblingAtColumn(0).data().toString(); }
    void key(int key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(&tree, Qt::Key(key), modifiers);
    }
    void edit(const QString &number, int column, const QString &text)
    {
        tree.setCurrentIndex(indexOf(number, column));
        tree.scrollTo(indexOf(number, column));
        const QPoint at = tree.visualRect(indexOf(number, column)).center();
        QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(tree.viewport(), Qt::LeftButton, {}, at);
        auto *field = tree.viewport()->findChild<QLineEdit *>();
        ASSERT_NE(field, nullptr);
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        QCoreApplication::processEvents(); // the input is taken afterwards
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    template <typename Widget>
    Widget &child(const char *name) const
    {
        auto *found = editor.findChild<Widget *>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    QString message() const
    {
        const auto *shown = editor.findChild<InlineMessage *>();
        return shown->isVisible() ? shown->sentence() : QString();
    }
    // Like the mouse, but without the drag's own event loop.
    void drop(const QString &number, const QPoint &at)
    {
        const std::unique_ptr<QMimeData> data(tree.model()->mimeData({indexOf(number)}));
        QDragEnterEvent enter(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
        QCoreApplication::sendEvent(tree.viewport(), &enter);
        QDragMoveEvent move(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
        QCoreApplication::sendEvent(tree.viewport(), &move);
        QDropEvent event(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
        QCoreApplication::sendEvent(tree.viewport(), &event);
    }

    StructureEditor editor{document, catalog};
    QTreeView &tree = *editor.findChild<QTreeView *>(QStringLiteral("plan"));
};

TEST_F(StructureEditorTest, KeysMoveTheChosenDeviceAndItStaysChosen)
{
    key(Qt::Key_Down, Qt::AltModifier);
    EXPECT_EQ(order(), QStringLiteral("1.0=2 1.1=3 1.2=4 2.0=5 3.0=6 4.0=1 5.0=7 6.0=8 7.0=9"));
    EXPECT_EQ(current(), QStringLiteral("4.0"));
    key(Qt::Key_Right, Qt::AltModifier);
    EXPECT_EQ(at(QStringLiteral("4.0")).level, 1);
    EXPECT_EQ(current(), QStringLiteral("4.0"));
    key(Qt::Key_B, Qt::ControlModifier);
    EXPECT_EQ(current(), QStringLiteral("1.3"));
    key(Qt::Key_Left, Qt::AltModifier);
    key(Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(current(), QStringLiteral("1.0"));
}

TEST_F(StructureEditorTest, EscapeClosesTheInsertPanel)
{
    auto &search = child<QLineEdit>("catalogSearch");
    key(Qt::Key_Insert);
    ASSERT_TRUE(search.isVisible());
    QTest::keyClick(&search, Qt::Key_Escape);
    EXPECT_FALSE(search.isVisible());
    EXPECT_TRUE(tree.hasFocus());
    key(Qt::Key_Insert);
    child<QAbstractButton>("closeInsert").click();
    EXPECT_FALSE(search.isVisible());
}

TEST_F(StructureEditorTest, TheNumbersOfABranchAreSeenFromTheStart)
{
    const QModelIndex inBranch = indexOf(QStringLiteral("2.1"));
    EXPECT_GE(tree.visualRect(inBranch).width(), tree.sizeHintForIndex(inBranch).width());
}

TEST_F(StructureEditorTest, AKeyRemovesAndUndoBringsBack)
{
    choose(QStringLiteral("2.0"));
    key(Qt::Key_Delete, Qt::ControlModifier);
    EXPECT_EQ(document.project().devices.size(), 4u);
    document.undoStack().undo();
    EXPECT_EQ(document.project().devices.size(), 9u);
    EXPECT_TRUE(tree.isExpanded(indexOf(QStringLiteral("2.0"))));
}

TEST_F(StructureEditorTest, CellsAreEditedWithTheMouse)
{
    edit(QStringLiteral("1.0"), test::stationColumn, QStringLiteral("Crane 1, hoist"));
    EXPECT_EQ(document.device("1.0"_ring).station, QStringLiteral("Crane 1, hoist"));
    edit(QStringLiteral("2.1"), test::outColumn, QStringLiteral("128"));
    EXPECT_EQ(document.device("2.1"_ring).its<GivenAddresses>().out, 128);
    edit(QStringLiteral("2.1"), test::outColumn, QStringLiteral("-3"));
    EXPECT_TRUE(message().contains(QStringLiteral("-3"))) << message().toStdString();
    EXPECT_EQ(document.device("2.1"_ring).its<GivenAddresses>().out, 128);
}

TEST_F(StructureEditorTest, AnAddressThatIsRefusedStaysInItsFieldUntilItIsCorrectedOrGivenUp)
{
    edit(QStringLiteral("2.1"), test::outColumn, QStringLiteral("12x"));
    auto *field = tree.viewport()->findChild<QLineEdit *>();
    ASSERT_NE(field, nullptr);
    EXPECT_EQ(field->text(), QStringLiteral("12x"));
    child<QComboBox>("addressUnit").setFocus();
    ASSERT_NE(tree.viewport()->findChild<QLineEdit *>(), nullptr) << "left, it is still there";
    EXPECT_EQ(document.device("2.1"_ring).its<GivenAddresses>().out, std::nullopt);
    QTest::keyClick(field, Qt::Key_Backspace);
    EXPECT_EQ(message(), QString());
    QTest::keyClick(field, Qt::Key_Return);
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_EQ(document.device("2.1"_ring).its<GivenAddresses>().out, 12);
    edit(QStringLiteral("2.1"), test::outColumn, QStringLiteral("y"));
    QTest::keyClick(tree.viewport()->findChild<QLineEdit *>(), Qt::Key_Escape);
    EXPECT_EQ(message(), QString());
    EXPECT_EQ(document.device("2.1"_ring).its<GivenAddresses>().out, 12);
    EXPECT_EQ(document.undoStack().count(), 1);
}

TEST_F(StructureEditorTest, StepsOfANumberAreOneStepOfUndo)
{
    auto &cable = child<QDoubleSpinBox>("cableKilometres");
    cable.setFocus();
    for (int i = 0; i < 5; ++i)
        QTest::keyClick(&cable, Qt::Key_Up);
    EXPECT_DOUBLE_EQ(ringPlan(document.project(), firstBus).cableKilometres, 0.5);
    EXPECT_EQ(document.undoStack().count(), 1);
    auto &first = child<QSpinBox>("firstAddress");
    first.setFocus();
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&first, Qt::Key_Up);
    EXPECT_EQ(document.undoStack().count(), 2);
    QTest::keyClick(&first, Qt::Key_Return);
    QTest::keyClick(&first, Qt::Key_Up);
    EXPECT_EQ(document.undoStack().count(), 3) << "another one";
    document.undoStack().undo();
    EXPECT_EQ(ringPlan(document.project(), firstBus).addresses.first, 3);
}

TEST_F(StructureEditorTest, ADeviceIsDraggedOntoABusTerminalAndBetweenOthers)
{
    drop(QStringLiteral("1.0"), tree.visualRect(indexOf(QStringLiteral("6.0"))).center());
    EXPECT_EQ(at(QStringLiteral("6.0")).level, 1) << order().toStdString();
    drop(QStringLiteral("6.0"), tree.visualRect(indexOf(QStringLiteral("1.0"))).topLeft() + QPoint(9, 1));
    EXPECT_EQ(order(), QStringLiteral("1.0=1 2.0=2 2.1=3 2.2=4 3.0=5 4.0=6 5.0=7 6.0=8 7.0=9"));
    EXPECT_EQ(document.undoStack().count(), 2);
    drop(QStringLiteral("2.0"), tree.visualRect(indexOf(QStringLiteral("2.0"))).center());
    EXPECT_EQ(document.undoStack().count(), 2);
}

TEST_F(StructureEditorTest, ADeviceOfTheCatalogIsSearchedAndInserted)
{
    key(Qt::Key_Insert);
    auto &search = child<QLineEdit>("catalogSearch");
    ASSERT_TRUE(search.isVisible());
    QTest::keyClicks(&search, QStringLiteral("gxp6w"));
    EXPECT_EQ(child<QListWidget>("catalogDevices").count(), 1);
    QTest::keyClick(&search, Qt::Key_Return);
    EXPECT_EQ(current(), QStringLiteral("2.0"));
    EXPECT_EQ(at(QStringLiteral("2.0")).deviceKey, QStringLiteral("baumer-gxp6w"));
    EXPECT_EQ(at(QStringLiteral("2.0")).inWords, 2);
}

TEST_F(StructureEditorTest, TheCatalogIsSearchedByWords)
{
    key(Qt::Key_Insert);
    auto &search = child<QLineEdit>("catalogSearch");
    auto &found = child<QListWidget>("catalogDevices");
    QTest::keyClicks(&search, QStringLiteral("gxp6w baumer "));
    ASSERT_EQ(found.count(), 1);
    EXPECT_TRUE(found.item(0)->text().contains(QStringLiteral("GXP6W")));
    QTest::keyClicks(&search, QStringLiteral("fraba"));
    EXPECT_EQ(found.count(), 0);
}

TEST_F(StructureEditorTest, ADeviceIsInsertedByItsCodes)
{
    choose(QStringLiteral("2.0"));
    key(Qt::Key_Insert);
    auto &length = child<QLineEdit>("insertLengthCode");
    QTest::keyClicks(&child<QLineEdit>("insertIdCode"), QStringLiteral("BE"));
    QTest::keyClicks(&length, QStringLiteral("81h"));
    EXPECT_EQ(child<QLabel>("insertReading").text(),
              QStringLiteral("81BEh: Inline digital input, words: IN 1, OUT 0"));
    EXPECT_EQ(child<QComboBox>("insertPlace").currentText(), QStringLiteral("On the local bus of 2.0"));
    QTest::keyClick(&length, Qt::Key_Return);
    EXPECT_EQ(at(QStringLiteral("2.3")).deviceCode, 0x81BEU);
    length.clear();
    QTest::keyClicks(&child<QLineEdit>("insertIdCode"), QStringLiteral("x"));
    EXPECT_FALSE(child<QPushButton>("insertDevice").isEnabled());
}

TEST_F(StructureEditorTest, WhatIsRefusedIsSaidOnTheSpotUntilSomethingElseIsDone)
{
    choose(QStringLiteral("2.0"));
    key(Qt::Key_Right, Qt::AltModifier);
    EXPECT_EQ(
        message(),
        QStringLiteral(
            "The bus cannot be built like this: Nothing can hang below 1.0: it is not a bus terminal."));
    key(Qt::Key_Down, Qt::AltModifier);
    EXPECT_EQ(message(), QString());
}

TEST_F(StructureEditorTest, SearchGoesFromOneToTheNext)
{
    auto &search = child<QLineEdit>("structureSearch");
    QTest::keyClicks(&search, QStringLiteral("37h"));
    EXPECT_EQ(current(), QStringLiteral("1.0"));
    EXPECT_EQ(child<QLabel>("structureFound").text(), QStringLiteral("1 of 2"));
    QTest::keyClick(&search, Qt::Key_Return);
    EXPECT_EQ(current(), QStringLiteral("4.0"));
    QTest::keyClick(&search, Qt::Key_Return);
    EXPECT_EQ(current(), QStringLiteral("1.0"));
    QTest::keyClick(&search, Qt::Key_Return, Qt::ShiftModifier);
    EXPECT_EQ(current(), QStringLiteral("4.0"));
    search.clear();
    QTest::keyClicks(&search, QStringLiteral("nowhere"));
    EXPECT_EQ(child<QLabel>("structureFound").text(), QStringLiteral("not found"));
}

TEST_F(StructureEditorTest, TheToolsHaveTheirWordsWhereThereIsRoom)
{
    const auto withWords = [this] {
        int count = 0;
        for (const auto *button : editor.findChild<QToolBar *>()->findChildren<QToolButton *>())
            if (!button->text().isEmpty() && button->toolButtonStyle() == Qt::ToolButtonTextBesideIcon)
                ++count;
        return count;
    };
    editor.resize(1400, 600);
    QCoreApplication::processEvents();
    EXPECT_EQ(withWords(), 7);
    editor.resize(560, 600);
    QCoreApplication::processEvents();
    EXPECT_EQ(withWords(), 1) << "Insert keeps its own";
}

TEST_F(StructureEditorTest, TheSummaryCountsAndTellsTheCycleTime)
{
    const auto shown = [this](const char *label) {
        return child<QLabel>(label).text().replace(QChar::Nbsp, u' '); // lines break between the figures
    };
    EXPECT_EQ(shown("planCounts"),
              QStringLiteral("Devices 9 / 512, remote bus 7 / 254, levels 2 / 16, longest local bus 2 / 63, "
                             "PCP 0 / 62, inputs 208 / 4096, outputs 160 / 4096"));
    EXPECT_EQ(child<QLabel>("planCounts").text().count(u' '), 6) << "none breaks in itself";
    EXPECT_EQ(shown("planTimes"),
              QStringLiteral("Cycle about 1.05 / 1.71 ms at 500 kBd, 0.41 / 0.95 ms at 2 MBd (G3 / G4)"));
    choose(QStringLiteral("2.0"));
    key(Qt::Key_Delete, Qt::ControlModifier);
    EXPECT_TRUE(shown("planCounts").startsWith(QStringLiteral("Devices 4 / 512")));
}

TEST_F(StructureEditorTest, TheStep5RuleIsSwitchedOnAndUndone)
{
    QTest::mouseClick(&child<QCheckBox>("step5"), Qt::LeftButton, {}, QPoint(8, 8));
    EXPECT_TRUE(ringPlan(document.project(), firstBus).addresses.step5);
    EXPECT_TRUE(indexOf(QStringLiteral("1.0"), test::findingsColumn)
                    .data()
                    .toString()
                    .contains(QStringLiteral("P127")));
    document.undoStack().undo();
    EXPECT_FALSE(child<QCheckBox>("step5").isChecked());
    EXPECT_EQ(indexOf(QStringLiteral("1.0"), test::findingsColumn).data().toString(), QString());
}

} // namespace
} // namespace codewheel
