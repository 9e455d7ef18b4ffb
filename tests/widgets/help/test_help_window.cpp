// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/help_window.h"
#include "widgets/look/appearance.h"

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QScrollBar>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTreeWidget>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class HelpWindowTest : public testing::Test
{
protected:
    HelpWindowTest()
    {
        help.show();
        help.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&help));
        help.resize(900, 600);
        QCoreApplication::processEvents();
    }
    ~HelpWindowTest() override { QLocale::setDefault(QLocale::c()); }

    QTextBrowser &page() { return *help.findChild<QTextBrowser *>(QStringLiteral("helpPage")); }
    QListWidget &hits() { return *help.findChild<QListWidget *>(QStringLiteral("helpHits")); }
    QTreeWidget &contents() { return *help.findChild<QTreeWidget *>(QStringLiteral("helpContents")); }
    QString result() { return help.findChild<QLabel *>(QStringLiteral("helpFindResult"))->text(); }
    // The text at the top of the visible part, or close to it.
    QString atTop() { return page().cursorForPosition({20, 20}).block().text(); }
    void type(const char *text) { QTest::keyClicks(QApplication::focusWidget(), QLatin1String(text)); }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    }

    HelpWindow help;
};

TEST_F(HelpWindowTest, ShowsATopicAtItsHeadingAndGoesBackAndForward)
{
    help.showTopic(QStringLiteral("parameters.md#write"));
    EXPECT_EQ(atTop(), QStringLiteral("Write"));
    EXPECT_EQ(contents().currentItem()->text(0), QStringLiteral("Write"));
    page().verticalScrollBar()->setValue(page().verticalScrollBar()->value() - 30);
    const int left = page().verticalScrollBar()->value();
    help.showTopic(QStringLiteral("dial.md"));
    EXPECT_EQ(atTop(), QStringLiteral("The dial"));
    press(Qt::Key_Left, Qt::AltModifier);
    EXPECT_EQ(help.shown(), Manual::url(QStringLiteral("parameters.md#write")));
    EXPECT_EQ(page().verticalScrollBar()->value(), left) << "where it was left";
    press(Qt::Key_Right, Qt::AltModifier);
    EXPECT_EQ(help.shown(), Manual::url(QStringLiteral("dial.md")));
}

TEST_F(HelpWindowTest, ALinkOfAPageOpensWhereItLeads)
{
    help.showTopic(QStringLiteral("report.md"));
    press(Qt::Key_Tab); // to the first link
    press(Qt::Key_Return);
    EXPECT_EQ(help.shown(), Manual::url(QStringLiteral("dial.md#print")));
    EXPECT_EQ(atTop(), QStringLiteral("Print"));
}

TEST_F(HelpWindowTest, SearchesAllPagesByKeysAlone)
{
    help.showTopic({});
    press(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    type("adapter unplugged");
    ASSERT_GT(hits().count(), 0);
    EXPECT_TRUE(hits().isVisible());
    press(Qt::Key_Down);
    EXPECT_EQ(help.shown().fileName(), QStringLiteral("serial-line.md"));
    EXPECT_FALSE(page().extraSelections().isEmpty()) << "marked on the page";
    EXPECT_TRUE(page().textCursor().hasSelection());
    press(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    press(Qt::Key_Escape);
    EXPECT_TRUE(contents().isVisible());
    EXPECT_TRUE(page().extraSelections().isEmpty());
    EXPECT_TRUE(help.isVisible());
}

TEST_F(HelpWindowTest, SaysThatNoSectionHasTheWords)
{
    press(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    type("xyzzy");
    EXPECT_EQ(help.findChild<QLabel *>(QStringLiteral("helpHitCount"))->text(),
              QStringLiteral("No section of the manual has all these words."));
}

TEST_F(HelpWindowTest, FindsInThePage)
{
    help.showTopic(QStringLiteral("eeprom.md"));
    press(Qt::Key_F, Qt::ControlModifier);
    type("encoder");
    EXPECT_TRUE(result().startsWith(QStringLiteral("1 of "))) << result().toStdString();
    press(Qt::Key_F3);
    EXPECT_TRUE(result().startsWith(QStringLiteral("2 of "))) << result().toStdString();
    press(Qt::Key_F3, Qt::ShiftModifier);
    press(Qt::Key_F3, Qt::ShiftModifier);
    const QStringList last = result().split(u' ');
    EXPECT_EQ(last.front(), last.back()) << "around the beginning";
    press(Qt::Key_Escape);
    EXPECT_TRUE(page().hasFocus());
    EXPECT_TRUE(page().extraSelections().isEmpty());
    press(Qt::Key_Escape);
    EXPECT_FALSE(help.isVisible());
}

TEST_F(HelpWindowTest, KeepsItsSize)
{
    help.resize(700, 500);
    HelpWindow next;
    next.restoreLayout(help.layoutState());
    EXPECT_EQ(next.size(), QSize(700, 500));
    next.restoreLayout(QByteArray("broken"));
    EXPECT_EQ(next.size(), QSize(700, 500));
}

TEST_F(HelpWindowTest, NoPageIsWiderThanItsWindow)
{
    help.resize(640, 480);
    for (const ManualPage &each : help.manual().pages()) {
        help.showTopic(each.url.toString());
        QCoreApplication::processEvents(); // for fitting the pictures
        EXPECT_LE(page().document()->size().width(), page().viewport()->width() + 1)
            << each.url.fileName().toStdString();
    }
}

} // namespace
} // namespace codewheel
