// SPDX-License-Identifier: GPL-3.0-or-later
// Where the focus goes by a key.
#include "tests/app/window_test.h"
#include "widgets/connect/connect_page.h"
#include "widgets/find/find_page.h"
#include "widgets/line/line_settings_form.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QSpinBox>

namespace codewheel {
namespace {

class FocusRulesTest : public test::WindowTest
{
protected:
    QDockWidget &panel(const char *name) { return *window().findChild<QDockWidget *>(QLatin1String(name)); }
};

TEST_F(FocusRulesTest, ALetterThatPageAndPanelHaveIsOfThePartWithTheFocus)
{
    actions().findEncoders->trigger();
    auto &find = *window().findChild<FindPage *>();
    auto &ofPage = *new QPushButton(QStringLiteral("&Quick"), &find);
    auto &ofPanel = *new QPushButton(QStringLiteral("&Quiet"), panel("dialDock").widget());
    ofPage.show();
    ofPanel.show();
    panel("dialDock").raise();
    advance(50);
    ASSERT_TRUE(ofPage.isVisible() && ofPanel.isVisible());
    const QSignalSpy pageClicked(&ofPage, &QPushButton::clicked);
    const QSignalSpy panelClicked(&ofPanel, &QPushButton::clicked);
    for (int times = 1; times <= 2; ++times) {
        ofPage.setFocus();
        QTest::keyClick(&window(), Qt::Key_Q, Qt::AltModifier);
        EXPECT_TRUE(QTest::qWaitFor([&] { return pageClicked.count() == times; })) << times;
    }
    EXPECT_EQ(panelClicked.count(), 0);
    ofPanel.setFocus();
    QTest::keyClick(&window(), Qt::Key_Q, Qt::AltModifier);
    EXPECT_TRUE(QTest::qWaitFor([&] { return panelClicked.count() == 1; }));
    EXPECT_EQ(pageClicked.count(), 2);
}

TEST_F(FocusRulesTest, AFieldReachedByItsLetterComesIntoSight)
{
    resizeTo({1024, 640});
    lineActions().settings->trigger();
    advance(50);
    auto &page = *window().findChild<ConnectPage *>(QStringLiteral("lineSettings"));
    const auto fields = page.findChild<LineSettingsForm *>()->findChildren<QSpinBox *>();
    ASSERT_FALSE(fields.isEmpty());
    QSpinBox &last = *fields.back();
    ASSERT_TRUE(last.visibleRegion().isEmpty()) << "below what is in sight";
    last.setFocus(Qt::ShortcutFocusReason);
    EXPECT_FALSE(last.visibleRegion().isEmpty());
}

TEST_F(FocusRulesTest, TabGoesFromTheFormToItsButtons)
{
    lineActions().settings->trigger();
    advance(50);
    auto &page = *window().findChild<ConnectPage *>(QStringLiteral("lineSettings"));
    page.setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    EXPECT_TRUE(page.findChild<LineSettingsForm *>()->isAncestorOf(QApplication::focusWidget()))
        << QApplication::focusWidget()->objectName().toStdString()
        << QApplication::focusWidget()->metaObject()->className()
        << QApplication::focusWidget()->parentWidget()->metaObject()->className();
}

} // namespace
} // namespace codewheel
