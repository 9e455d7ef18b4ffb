// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/plan/esc_line_plan.h"
#include "tests/support/plans.h"
#include "widgets/project/bus_model.h"
#include "widgets/project/project_page.h"

#include <QAccessible>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTableView>
#include <QtTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

Project projectWith(const QString &title, const QString &note)
{
    Project project;
    project.title = title;
    project.note = note;
    return project;
}

class ProjectPageTest : public testing::Test
{
protected:
    ProjectPageTest()
    {
        page.resize(600, 400);
        page.show();
        page.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&page));
    }

    template <typename Widget>
    Widget &child(const char *name) const
    {
        return *page.findChild<Widget *>(QLatin1String(name));
    }
    QLineEdit &title() const { return child<QLineEdit>("projectTitle"); }
    QPlainTextEdit &note() const { return child<QPlainTextEdit>("projectNote"); }

    ProjectDocument document;
    ProjectPage page{document};
};

TEST_F(ProjectPageTest, WhatIsTypedInOneGoIsOneStepOfUndo)
{
    title().setFocus();
    QTest::keyClicks(&title(), QStringLiteral("Crane 1"));
    EXPECT_EQ(document.project().title, QString()) << "half typed";
    note().setFocus();
    EXPECT_EQ(document.project().title, QStringLiteral("Crane 1"));
    QTest::keyClicks(&note(), QStringLiteral("spare part"));
    QTest::keyClick(&note(), Qt::Key_Return);
    QTest::keyClicks(&note(), QStringLiteral("in cabinet 3"));
    EXPECT_EQ(document.project().note, QString()) << "half typed";
    title().setFocus();
    EXPECT_EQ(document.project().note, QStringLiteral("spare part\nin cabinet 3"));
    EXPECT_EQ(document.undoStack().count(), 2);
    EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("Note on the project"));
    document.undoStack().undo();
    EXPECT_EQ(note().toPlainText(), QString());
    EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("Title of the project"));
    document.undoStack().undo();
    EXPECT_EQ(title().text(), QString());
    document.undoStack().redo();
    EXPECT_EQ(title().text(), QStringLiteral("Crane 1"));
}

TEST_F(ProjectPageTest, TypingInTheMiddleStaysThere)
{
    document.edit(projectWith(QStringLiteral("Crane 1"), QStringLiteral("cabinet")), {});
    title().setFocus();
    title().setCursorPosition(5);
    QTest::keyClicks(&title(), QStringLiteral("s"));
    EXPECT_EQ(title().cursorPosition(), 6);
    note().setFocus();
    note().moveCursor(QTextCursor::Start);
    QTest::keyClicks(&note(), QStringLiteral("a "));
    EXPECT_EQ(note().toPlainText(), QStringLiteral("a cabinet"));
    EXPECT_EQ(note().textCursor().position(), 2);
}

TEST_F(ProjectPageTest, WhatIsHalfTypedOutlivesAnEditElsewhereAndEscGivesItUp)
{
    document.edit(projectWith(QStringLiteral("Crane"), QStringLiteral("cabinet")), {});
    title().setFocus();
    title().end(false);
    QTest::keyClicks(&title(), QStringLiteral(" 1"));
    Project elsewhere = document.project();
    changeRing(elsewhere, [&](RingPlan &ring) { ring.cableKilometres = 2; });
    document.edit(elsewhere, {});
    EXPECT_EQ(title().text(), QStringLiteral("Crane 1"));
    QTest::keyClick(&title(), Qt::Key_Escape);
    note().setFocus();
    EXPECT_EQ(document.project(), elsewhere);
}

TEST_F(ProjectPageTest, AnotherProjectShowsItsOwn)
{
    QTest::keyClicks(&title(), QStringLiteral("Crane 1"));
    document.setProject(projectWith(QStringLiteral("Press"), QStringLiteral("hot")),
                        QStringLiteral("/tmp/press.codewheel"));
    EXPECT_EQ(title().text(), QStringLiteral("Press"));
    EXPECT_EQ(note().toPlainText(), QStringLiteral("hot"));
    EXPECT_TRUE(child<QLabel>("projectFile").text().contains(QStringLiteral("press.codewheel")));
    EXPECT_EQ(document.undoStack().count(), 0) << "showing is no edit";
}

TEST_F(ProjectPageTest, TheLinkOfEachBusIsSeen)
{
    Project project = document.project();
    changeRing(project, [](RingPlan &ring) {
        ring.link = {.kind = QStringLiteral("modbus"),
                     .settings = {{QStringLiteral("port"), QStringLiteral("/dev/ttyUSB0")}}};
    });
    EscLinePlan line;
    line.settings.port = QStringLiteral("/dev/ttyUSB1");
    setLinePlan(project, firstLine, line);
    document.setProject(project, {});
    const QAbstractItemModel &buses = *child<QTableView>("projectBuses").model();
    EXPECT_EQ(buses.index(0, BusModel::link).data(), QStringLiteral("modbus, port = /dev/ttyUSB0"));
    EXPECT_EQ(buses.index(1, BusModel::link).data(), QStringLiteral("/dev/ttyUSB1, 19200 Bd, 8N2"));
}

TEST_F(ProjectPageTest, EveryFieldHasANameAndATip)
{
    for (QWidget *field : {static_cast<QWidget *>(&title()), static_cast<QWidget *>(&note())}) {
        EXPECT_FALSE(field->toolTip().isEmpty());
        EXPECT_FALSE(QAccessible::queryAccessibleInterface(field)->text(QAccessible::Name).isEmpty());
    }
}

} // namespace
} // namespace codewheel
