// SPDX-License-Identifier: GPL-3.0-or-later
// Where the focus goes by a key.
#include "tests/app/window_test.h"
#include "widgets/connect/connect_page.h"
#include "widgets/find/find_page.h"
#include "widgets/kinds/esc/line/esc_line_settings_form.h"
#include "widgets/look/label_text.h"
#include "widgets/monitor/word_view.h"

#include <QAbstractButton>
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
    const auto fields = page.findChild<EscLineSettingsForm *>()->findChildren<QSpinBox *>();
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
    EXPECT_TRUE(page.findChild<EscLineSettingsForm *>()->isAncestorOf(QApplication::focusWidget()))
        << QApplication::focusWidget()->objectName().toStdString()
        << QApplication::focusWidget()->metaObject()->className()
        << QApplication::focusWidget()->parentWidget()->metaObject()->className();
}

// What is done to the word comes before what is done to the card, and before anything else.
TEST_F(FocusRulesTest, TabGoesFromTheBitsToTheHexFieldAndTheButtonsOfTheWord)
{
    QTest::keyClick(&window(), Qt::Key_1, Qt::ControlModifier);
    ASSERT_NE(qobject_cast<WordView *>(QApplication::focusWidget()), nullptr);
    QTest::keyClick(QApplication::focusWidget(),
                    Qt::Key_Space); // stages a bit, so that there is something to write
    QStringList reached;
    for (int i = 0; i < 12; ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QWidget *now = QApplication::focusWidget();
        const auto *button = qobject_cast<QAbstractButton *>(now);
        reached << (button != nullptr && !button->text().isEmpty()
                        ? plainLabel(button->text())
                        : QString::fromLatin1(now->metaObject()->className()));
    }
    const qsizetype write = reached.indexOf(QStringLiteral("Write"));
    EXPECT_EQ(reached.front(), QStringLiteral("codewheel::WordField")) << reached.join(u' ').toStdString();
    EXPECT_GT(write, 0) << reached.join(u' ').toStdString();
    EXPECT_EQ(reached.indexOf(QStringLiteral("Discard")), write + 1) << reached.join(u' ').toStdString();
    EXPECT_GT(reached.indexOf(QStringLiteral("Show")), write) << reached.join(u' ').toStdString();
}

} // namespace
} // namespace codewheel
