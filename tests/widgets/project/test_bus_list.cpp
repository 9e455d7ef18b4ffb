// SPDX-License-Identifier: GPL-3.0-or-later
// The buses of the project, on its page, edited by keys and mouse.
#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "tests/support/model_tester.h"
#include "tests/support/plans.h"
#include "widgets/look/inline_message.h"
#include "widgets/project/bus_list.h"
#include "widgets/project/bus_model.h"
#include "widgets/project/project_page.h"

#include <QAccessible>
#include <QAction>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>
#include <QtTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

// Behind those of the training.
constexpr BusId firstFree{4};
constexpr BusId secondFree{5};

void plan(Project &project, BusId bus, const char16_t *kind, std::size_t devices = 0)
{
    planBus(project, bus, *busKind(kind));
    std::vector<ProjectDevice> its(devices);
    for (std::size_t i = 0; i < devices; ++i)
        its[i].standAt({bus, NodeId(std::to_string(i + 1) + ".0")});
    setDevicesOn(project, bus, std::move(its));
}

class BusListTest : public testing::Test
{
protected:
    BusListTest()
    {
        page.resize(700, 500);
        page.show();
        page.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&page));
        table().setFocus();
    }

    QTableView &table() const { return *page.findChild<QTableView *>(QStringLiteral("projectBuses")); }
    InlineMessage &message() { return *page.buses().findChild<InlineMessage *>(); }
    QString cell(int row, BusModel::Column column) const
    {
        return table().model()->index(row, column).data().toString();
    }
    QStringList names() const
    {
        QStringList all;
        for (int row = 0; row < table().model()->rowCount(); ++row)
            all << cell(row, BusModel::name);
        return all;
    }
    QLineEdit *field() const { return table().viewport()->findChild<QLineEdit *>(); }

    // By keyboard: the menu opens on its first kind.
    void add(int kind)
    {
        QTest::keyClick(&table(), Qt::Key_Insert);
        auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
        ASSERT_NE(menu, nullptr);
        for (int i = 0; i < kind; ++i)
            QTest::keyClick(menu, Qt::Key_Down);
        QTest::keyClick(menu, Qt::Key_Return);
        page.activateWindow(); // without a desktop, nothing returns the activation that the menu took
        EXPECT_TRUE(QTest::qWaitForWindowActive(&page));
    }
    void addRing() { add(0); }
    void addLine() { add(1); }
    // The view takes it in its event loop.
    void pressReturn()
    {
        QTest::keyClick(field(), Qt::Key_Return);
        QCoreApplication::processEvents();
    }
    void choose(int row) { table().selectRow(row); }
    void rename(int row, const QString &name)
    {
        choose(row);
        QTest::keyClick(&table(), Qt::Key_F2);
        ASSERT_NE(field(), nullptr);
        field()->selectAll();
        QTest::keyClicks(field(), name);
    }
    QPushButton *answer()
    {
        for (auto *button : message().findChildren<QPushButton *>())
            if (button->isVisible())
                return button;
        return nullptr;
    }

    ProjectDocument document;
    ProjectPage page{document};
    test::ModelTester tester{*table().model()};
};

TEST_F(BusListTest, ShowsNameKindAndDevices)
{
    Project project;
    plan(project, firstBus, u"interbus", 3);
    plan(project, secondFree, u"esc");
    document.setProject(project, {});
    EXPECT_EQ(names(), QStringList({QStringLiteral("Ring"), QStringLiteral("Line")}));
    EXPECT_EQ(cell(0, BusModel::kind), QStringLiteral("INTERBUS ring"));
    EXPECT_EQ(cell(1, BusModel::kind), QStringLiteral("Serial line (ESC)"));
    EXPECT_EQ(cell(0, BusModel::devices), QStringLiteral("3"));
    EXPECT_EQ(cell(1, BusModel::devices), QStringLiteral("0"));
}

TEST_F(BusListTest, SaysThatANewBusIsSimulatedAtFirst)
{
    addLine();
    ASSERT_TRUE(message().isVisible());
    EXPECT_TRUE(message().sentence().contains(QStringLiteral("\"Line\" is simulated")))
        << message().sentence().toStdString();
    EXPECT_EQ(answer(), nullptr);
}

TEST_F(BusListTest, AddedBusesGetTheNumbersThatAreFree)
{
    addLine();
    addRing();
    addLine();
    ASSERT_EQ(document.project().buses.size(), 4U);
    EXPECT_EQ(document.project().buses[1].kind, QStringLiteral("esc")) << "that of the training line";
    EXPECT_EQ(findBus(document.project(), firstFree)->kind, QStringLiteral("interbus"));
    EXPECT_EQ(findBus(document.project(), secondFree)->kind, QStringLiteral("esc"));
    EXPECT_EQ(names(), QStringList({QStringLiteral("Ring"), QStringLiteral("Line"), QStringLiteral("Ring 2"),
                                    QStringLiteral("Line 2")}));
    EXPECT_EQ(table().currentIndex().row(), 3) << "the new one is chosen";
    EXPECT_EQ(document.undoStack().count(), 3);
    EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("Add Line 2"));
    document.undoStack().undo();
    EXPECT_EQ(names().size(), 3);
}

TEST_F(BusListTest, ARingTakesTheNumberOfTheTrainingRingWhereThatIsFree)
{
    Project project;
    project.buses.clear();
    plan(project, secondFree, u"esc");
    document.setProject(project, {});
    addRing();
    EXPECT_EQ(document.project().buses.front().id, firstBus);
    addRing();
    EXPECT_EQ(document.project().buses.back().id, BusId{6}) << "never that of the training line";
}

TEST_F(BusListTest, ANumberThatIsConnectedAsAnotherBusIsLeftOut)
{
    page.buses().setIsFree([](BusId bus, const QString &) { return bus != firstFree; });
    addRing();
    EXPECT_EQ(document.project().buses.back().id, secondFree);
}

TEST_F(BusListTest, BehindTheLargestNumberThatAFileCanHaveAFreeOneIsFound)
{
    Project project;
    plan(project, BusId{std::numeric_limits<int>::max()}, u"interbus");
    document.setProject(project, {});
    addRing();
    EXPECT_NE(findBus(document.project(), firstFree), nullptr);
}

TEST_F(BusListTest, RenamingIsOneStepOfUndo)
{
    rename(0, QStringLiteral(" Crane 1 "));
    pressReturn();
    EXPECT_EQ(document.project().buses[0].name, QStringLiteral("Crane 1"));
    EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("Rename Ring"));
    EXPECT_EQ(document.undoStack().count(), 1);
    document.undoStack().undo();
    EXPECT_EQ(names(), QStringList(QStringLiteral("Ring")));
}

TEST_F(BusListTest, WhatIsNoNameIsRefusedAndStays)
{
    addRing();
    for (const auto &wrong : {QStringLiteral(" "), QStringLiteral("Ring"), QStringLiteral("A/B")}) {
        rename(1, wrong);
        pressReturn();
        ASSERT_NE(field(), nullptr);
        EXPECT_EQ(field()->text(), wrong);
        EXPECT_TRUE(message().isVisible()) << wrong.toStdString();
        QTest::keyClick(field(), Qt::Key_Escape);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        EXPECT_FALSE(message().isVisible());
    }
    EXPECT_EQ(names()[1], QStringLiteral("Ring 2"));
    EXPECT_EQ(document.undoStack().count(), 1);
}

TEST_F(BusListTest, WhatIsRefusedStaysWhileAnotherRowIsClicked)
{
    addRing();
    rename(1, QStringLiteral("A/B"));
    const QPoint other = table().visualRect(table().model()->index(0, 0)).center();
    table().setFocus(); // as a click gives it
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, other);
    QTest::mouseDClick(table().viewport(), Qt::LeftButton, {}, other);
    QTest::keyClick(field(), Qt::Key_Up);
    QTest::keyClick(&table(), Qt::Key_Up);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    ASSERT_NE(field(), nullptr);
    EXPECT_EQ(field()->text(), QStringLiteral("A/B"));
    EXPECT_TRUE(field()->hasFocus());
    EXPECT_TRUE(message().isVisible());
    EXPECT_EQ(table().currentIndex().row(), 1);
    QTest::keyClick(field(), Qt::Key_Escape);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, other);
    EXPECT_EQ(table().currentIndex().row(), 0);
}

TEST_F(BusListTest, AnotherEditWaitsForWhatIsRefused)
{
    addRing();
    rename(1, QStringLiteral("Ring"));
    QTest::keyClick(field(), Qt::Key_Insert);
    if (QWidget *menu = QApplication::activePopupWidget())
        QTest::keyClick(menu, Qt::Key_Return);
    ASSERT_NE(field(), nullptr);
    EXPECT_EQ(field()->text(), QStringLiteral("Ring"));
    EXPECT_TRUE(message().isVisible());
    EXPECT_EQ(document.undoStack().count(), 1);
}

TEST_F(BusListTest, WhatIsHalfTypedOutlivesAnEditElsewhere)
{
    rename(0, QStringLiteral("Cra"));
    Project elsewhere = document.project();
    plan(elsewhere, firstBus, u"interbus", 2);
    plan(elsewhere, firstLine, u"esc");
    document.edit(elsewhere, {});
    ASSERT_NE(field(), nullptr);
    EXPECT_EQ(field()->text(), QStringLiteral("Cra"));
    EXPECT_EQ(names().size(), 2);
    QTest::keyClicks(field(), QStringLiteral("ne"));
    pressReturn();
    EXPECT_EQ(names()[0], QStringLiteral("Crane"));
}

TEST_F(BusListTest, ABusWithoutDevicesGoesAtOnce)
{
    addRing();
    QTest::keyClick(&table(), Qt::Key_Delete);
    EXPECT_EQ(names(), QStringList(QStringLiteral("Ring")));
    EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("Remove Ring 2"));
    EXPECT_TRUE(table().currentIndex().isValid());
}

TEST_F(BusListTest, WhereDevicesGoWithItItIsAsked)
{
    Project project;
    plan(project, firstFree, u"interbus", 2);
    project.buses.back().name = QStringLiteral("Hoist & <b>crab</b>");
    document.setProject(project, {});
    choose(1);
    QTest::keyClick(&table(), Qt::Key_Delete);
    EXPECT_EQ(document.project(), project) << "only asked";
    ASSERT_NE(answer(), nullptr);
    EXPECT_EQ(answer()->text(), QStringLiteral("&Remove \"Hoist && <b>crab</b>\" and its 2 devices"));
    QTest::mouseClick(answer(), Qt::LeftButton);
    EXPECT_EQ(document.project().buses.size(), 1U);
    EXPECT_TRUE(document.project().devices.empty());
    EXPECT_FALSE(message().isVisible());
    document.undoStack().undo();
    EXPECT_EQ(document.project(), project) << "one step";
}

TEST_F(BusListTest, AQuestionAboutSomethingElseThanBeforeIsNone)
{
    Project project;
    plan(project, firstFree, u"interbus", 2);
    document.setProject(project, {});
    choose(1);
    QTest::keyClick(&table(), Qt::Key_Delete);
    ASSERT_TRUE(message().isVisible());
    Project titled = project;
    titled.title = QStringLiteral("Crane");
    document.edit(titled, {});
    EXPECT_TRUE(message().isVisible());
    plan(titled, firstFree, u"interbus", 3);
    document.edit(titled, {});
    EXPECT_FALSE(message().isVisible());
}

TEST_F(BusListTest, NothingIsToBeRemovedWhereNoBusIs)
{
    QTest::keyClick(&table(), Qt::Key_Delete);
    EXPECT_TRUE(names().isEmpty());
    QTest::keyClick(&table(), Qt::Key_Delete);
    QTest::keyClick(&table(), Qt::Key_F2);
    EXPECT_EQ(document.undoStack().count(), 1);
    addRing();
    EXPECT_EQ(document.project().buses, usualBuses());
}

TEST_F(BusListTest, AProjectHasAsManyAsItsFileTakes)
{
    Project project;
    for (int number = 3; project.buses.size() < mostBuses; ++number)
        plan(project, BusId{number}, u"esc");
    document.setProject(project, {});
    QTest::keyClick(&table(), Qt::Key_Insert);
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
}

TEST_F(BusListTest, EverythingHasANameAndATip)
{
    EXPECT_FALSE(table().toolTip().isEmpty());
    EXPECT_FALSE(QAccessible::queryAccessibleInterface(&table())->text(QAccessible::Name).isEmpty());
    int tools = 0;
    for (auto *button : page.buses().findChildren<QToolButton *>()) {
        if (button->isHidden() || button->defaultAction() == nullptr)
            continue;
        ++tools;
        EXPECT_FALSE(button->toolTip().isEmpty());
        EXPECT_FALSE(QAccessible::queryAccessibleInterface(button)->text(QAccessible::Name).isEmpty());
    }
    EXPECT_EQ(tools, 3);
}

} // namespace
} // namespace codewheel
