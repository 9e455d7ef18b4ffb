// SPDX-License-Identifier: GPL-3.0-or-later
// Each size of the window has an arrangement of its own, and gets it back when the size returns.
#include "tests/app/window_test.h"

#include <QAction>
#include <QDockWidget>
#include <QSettings>
#include <QTimer>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr QSize small(960, 600);
constexpr QSize usual(1280, 800);
constexpr QSize large(1920, 1080);

class WindowLayoutsTest : public test::WindowTest
{
protected:
    using Places = QMap<QString, QRect>; // of the front panels

    WindowLayoutsTest() { resizeTo(usual); }

    QDockWidget &panel(const char *name) { return *window().findChild<QDockWidget *>(QLatin1String(name)); }
    Qt::DockWidgetArea areaOf(const char *name) { return window().dockWidgetArea(&panel(name)); }
    bool isOneColumn() { return areaOf("parametersDock") == Qt::LeftDockWidgetArea; }

    Places places()
    {
        Places found;
        for (const auto *dock : window().findChildren<QDockWidget *>())
            if (dock->isVisible() && window().rect().intersects(dock->geometry()))
                found[dock->objectName()] = dock->geometry();
        return found;
    }
};

TEST_F(WindowLayoutsTest, ANarrowWindowHasOneColumnWithTabs)
{
    resizeTo(small);
    for (auto *dock : window().findChildren<QDockWidget *>())
        EXPECT_NE(window().dockWidgetArea(dock), Qt::RightDockWidgetArea) << dock->objectName().toStdString();
    EXPECT_EQ(panel("structureDock").x(), panel("parametersDock").x()) << "one above the other";
    EXPECT_LT(panel("structureDock").y(), panel("parametersDock").y());
    EXPECT_TRUE(window().tabifiedDockWidgets(&panel("parametersDock")).contains(&panel("dialDock")));
}

TEST_F(WindowLayoutsTest, InTheSmallestWindowACardHasItsBitsInOneRowAndIsWhole)
{
    resizeTo(small);
    const auto *card = window().findChild<WordCard *>();
    ASSERT_NE(card, nullptr);
    EXPECT_LE(card->height(), 210) << "32 bits in a row";
    EXPECT_EQ(card->visibleRegion().boundingRect(), card->rect())
        << "nothing is scrolled to, Write is in sight";
}

TEST_F(WindowLayoutsTest, SmallAndLargeAgainGivesBackWhatWasThere)
{
    panel("messagesDock").close();
    window().addDockWidget(Qt::LeftDockWidgetArea, &panel("deviceDock"));
    window().resizeDocks({&panel("structureDock")}, {250}, Qt::Horizontal);
    advance(50);
    const Places before = places();
    resizeTo(small);
    EXPECT_NE(places(), before);
    panel("sequenceDock").close();
    advance(50);
    const Places inSmall = places();
    resizeTo(usual);
    EXPECT_EQ(places(), before);
    resizeTo(large);
    EXPECT_FALSE(panel("messagesDock").isHidden()) << "a size that is new has all";
    resizeTo(small);
    EXPECT_EQ(places(), inSmall);
    resizeTo(usual);
    EXPECT_EQ(places(), before);
}

TEST_F(WindowLayoutsTest, WithinOneArrangementAPanelThatGaveWayComesBack)
{
    const Places before = places();
    resizeTo({1210, 730});
    EXPECT_NE(places(), before);
    resizeTo(usual);
    EXPECT_EQ(places(), before);
}

TEST_F(WindowLayoutsTest, TheFocusStaysWhereItIs)
{
    auto *tree = window().findChild<QWidget *>(QStringLiteral("structure"));
    tree->setFocus();
    for (const QSize size : {small, large, usual}) {
        resizeTo(size);
        advance(200);
        EXPECT_EQ(window().focusWidget(), tree) << size.width();
    }
}

TEST_F(WindowLayoutsTest, WhileTheEdgeMovesNothingIsArrangedAnew)
{
    auto *settling = window().findChild<QTimer *>(QStringLiteral("settling"));
    const auto rest = settling->intervalAsDuration();
    settling->setInterval(std::chrono::hours(1)); // a slow computer takes longer than that for a step
    for (int width = usual.width(); width >= small.width(); width -= 16) {
        window().resize(width, usual.height());
        advance(1);
        EXPECT_FALSE(isOneColumn()) << width;
    }
    EXPECT_TRUE(settling->isActive());
    settling->setInterval(rest);
    EXPECT_EQ(window().width(), small.width()) << "however much the columns hold";
    EXPECT_TRUE(QTest::qWaitFor([this] { return isOneColumn(); }));
}

TEST_F(WindowLayoutsTest, TheNextRunHasTheLayoutOfEachSize)
{
    panel("messagesDock").close();
    resizeTo(small);
    panel("sequenceDock").close();
    advance(50);
    const Places inSmall = places();
    window().saveWindow();
    open();
    advance(50);
    EXPECT_EQ(window().size(), small);
    EXPECT_EQ(places(), inSmall);
    resizeTo(usual);
    EXPECT_TRUE(panel("messagesDock").isHidden());
    EXPECT_FALSE(panel("sequenceDock").isHidden());
}

TEST_F(WindowLayoutsTest, WhatIsNoLayoutOfThisVersionGivesWayToTheDefault)
{
    const Places atFirst = places();
    window().saveWindow();
    shown.reset();
    QSettings(folder.filePath(QStringLiteral("window.ini")), QSettings::IniFormat)
        .setValue(QStringLiteral("window/layouts/usual"), QByteArray("of another time"));
    open();
    advance(50);
    EXPECT_EQ(places().keys(), atFirst.keys());
}

TEST_F(WindowLayoutsTest, APanelThatFloatsOnAScreenThatIsGoneComesIntoSight)
{
    panel("dialDock").setFloating(true);
    panel("dialDock").move(9'000, 9'000);
    resizeTo(small);
    resizeTo(usual);
    ASSERT_TRUE(panel("dialDock").isFloating());
    EXPECT_TRUE(panel("dialDock").screen()->availableGeometry().intersects(panel("dialDock").geometry()));
}

TEST_F(WindowLayoutsTest, TheDefaultIsThatOfTheSizeAlone)
{
    panel("messagesDock").close();
    resizeTo(small);
    panel("sequenceDock").close();
    actions().defaultLayout->trigger();
    EXPECT_TRUE(isOneColumn());
    EXPECT_FALSE(panel("sequenceDock").isHidden());
    resizeTo(usual);
    EXPECT_TRUE(panel("messagesDock").isHidden());
}

} // namespace
} // namespace codewheel
