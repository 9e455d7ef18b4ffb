// SPDX-License-Identifier: GPL-3.0-or-later
// While a page is open, the panels at the bottom are folded to their tabs.
#include "tests/app/window_test.h"
#include "widgets/structure/structure_view.h"

#include <QAction>
#include <QDockWidget>
#include <QTabBar>

namespace codewheel {
namespace {

class BottomFoldTest : public test::WindowTest
{
protected:
    BottomFoldTest() { resizeTo({1280, 800}); }
    QDockWidget &panel(const char *name) { return *window().findChild<QDockWidget *>(QLatin1String(name)); }
    int height() // of the front panel at the bottom
    {
        QCoreApplication::processEvents(); // for the layout
        for (const char *name : {"messagesDock", "traceDock", "sequenceDock", "terminalDock"})
            if (const QDockWidget &each = panel(name); !each.isFloating() && !each.visibleRegion().isEmpty())
                return each.height();
        return 0;
    }
    bool isFolded()
    {
        return QTest::qWaitFor([this] { return height() < 10; });
    }
    void clickTab(const QString &title)
    {
        for (auto *tabs : window().findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly))
            for (int i = 0; i < tabs->count(); ++i)
                if (tabs->isVisible() && tabs->tabText(i) == title) {
                    QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(i).center());
                    return;
                }
        FAIL() << title.toStdString();
    }
};

TEST_F(BottomFoldTest, APageHasTheirHeightUntilItIsClosed)
{
    const int before = height();
    EXPECT_GT(before, 100);
    actions().cams->trigger();
    EXPECT_TRUE(isFolded());
    const int low = page()->height();
    actions().transfer->trigger();
    EXPECT_TRUE(isFolded()) << "another page";
    actions().closePage->trigger();
    EXPECT_NEAR(height(), before, 2);
    EXPECT_LT(page()->height(), low);
}

TEST_F(BottomFoldTest, AClickOnATabUnfoldsThemWhileThePageStays)
{
    const int before = height();
    actions().cams->trigger();
    EXPECT_TRUE(isFolded());
    clickTab(QStringLiteral("Handshake trace"));
    EXPECT_NEAR(height(), before, 2);
    actions().transfer->trigger();
    EXPECT_NEAR(height(), before, 2) << "they stay so for the next page";
    actions().closePage->trigger();
    EXPECT_NEAR(height(), before, 2);
}

TEST_F(BottomFoldTest, ItsKeyGivesTheMonitorsTheHeightAndTakesItBack)
{
    const int before = height();
    const int low = page()->height();
    QTest::keyClick(&window(), Qt::Key_F7, Qt::ControlModifier);
    EXPECT_TRUE(isFolded());
    EXPECT_TRUE(actions().foldBottom->isChecked());
    EXPECT_GT(page()->height(), low + 100);
    QTest::keyClick(&window(), Qt::Key_F7, Qt::ControlModifier);
    EXPECT_NEAR(height(), before, 2);
    EXPECT_FALSE(actions().foldBottom->isChecked());
}

TEST_F(BottomFoldTest, WhatTheUserFoldedStaysSoAfterAPage)
{
    actions().foldBottom->trigger();
    actions().cams->trigger();
    actions().closePage->trigger();
    EXPECT_TRUE(isFolded());
    clickTab(QStringLiteral("Messages"));
    EXPECT_GT(height(), 100);
    EXPECT_FALSE(actions().foldBottom->isChecked());
    actions().cams->trigger();
    EXPECT_TRUE(actions().foldBottom->isChecked()) << "by the page";
    actions().closePage->trigger();
    EXPECT_GT(height(), 100);
}

TEST_F(BottomFoldTest, NoKeyReachesAFoldedPanel)
{
    actions().cams->trigger();
    ASSERT_TRUE(isFolded());
    for (const char *name : {"messagesDock", "traceDock", "sequenceDock"})
        EXPECT_FALSE(panel(name).widget()->isEnabled()) << name;
    actions().closePage->trigger();
    for (const char *name : {"messagesDock", "traceDock", "sequenceDock"})
        EXPECT_TRUE(panel(name).widget()->isEnabled()) << name;
}

TEST_F(BottomFoldTest, ATabElsewhereUnfoldsNothing)
{
    actions().cams->trigger();
    clickTab(QStringLiteral("Device"));
    EXPECT_TRUE(isFolded());
}

TEST_F(BottomFoldTest, TheKeyOfAPanelUnfoldsIt)
{
    const int before = height();
    actions().cams->trigger();
    EXPECT_TRUE(isFolded());
    QTest::keyClick(&window(), Qt::Key_6, Qt::AltModifier); // the front one
    EXPECT_NEAR(height(), before, 2);
    EXPECT_TRUE(panel("traceDock").isVisible());
    QTest::keyClick(&window(), Qt::Key_6, Qt::AltModifier);
    EXPECT_FALSE(panel("traceDock").isVisible()) << "in sight, it is closed as ever";
}

TEST_F(BottomFoldTest, WhatAPageAsksForIsSeen)
{
    actions().cams->trigger();
    lineActions().terminal->trigger();
    QCoreApplication::processEvents();
    EXPECT_GT(panel("terminalDock").height(), 100);
}

TEST_F(BottomFoldTest, OneThatFloatsIsLeftAlone)
{
    auto &messages = panel("messagesDock");
    messages.setFloating(true);
    messages.resize(400, 300);
    advance(50);
    const QSize before = messages.size();
    actions().cams->trigger();
    EXPECT_TRUE(isFolded());
    EXPECT_EQ(messages.size(), before);
}

TEST_F(BottomFoldTest, OneThatStandsAloneKeepsItsTitle)
{
    for (auto *other : window().findChildren<QDockWidget *>())
        if (other != &panel("traceDock") && window().dockWidgetArea(other) == Qt::BottomDockWidgetArea)
            other->close();
    const int before = height();
    actions().cams->trigger();
    EXPECT_TRUE(QTest::qWaitFor([this] { return height() < 40; })) << height();
    EXPECT_GT(height(), 10);
    QTest::mouseClick(&panel("traceDock"), Qt::LeftButton, {}, QPoint(20, 5));
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(height() - before) <= 2; })) << height();
}

TEST_F(BottomFoldTest, WhatIsKeptIsNotFolded)
{
    const int before = height();
    actions().cams->trigger();
    EXPECT_TRUE(isFolded());
    window().saveWindow();
    EXPECT_TRUE(isFolded());
    open(); // with the saved layout
    EXPECT_NEAR(height(), before, 2);
}

TEST_F(BottomFoldTest, TheDefaultLayoutCanBeAskedForOnAPage)
{
    const int before = height();
    actions().cams->trigger();
    actions().defaultLayout->trigger();
    EXPECT_TRUE(isFolded());
    actions().closePage->trigger();
    EXPECT_NEAR(height(), before, 20);
}

} // namespace
} // namespace codewheel
