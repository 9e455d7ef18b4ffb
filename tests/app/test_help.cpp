// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/window_test.h"

#include <QAction>
#include <QDialog>
#include <QTest>
#include <QTextBrowser>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class HelpTest : public test::WindowTest
{
protected:
    QDialog *keys() { return window().findChild<QDialog *>(QStringLiteral("keys")); }
};

TEST_F(HelpTest, TheListOfKeysFitsASmallScreenAndLeavesTheWindowAtWork)
{
    actions().keys->trigger();
    ASSERT_NE(keys(), nullptr);
    EXPECT_LE(keys()->height(), 600);
    EXPECT_FALSE(keys()->isModal());
    const QString text = keys()->findChild<QTextBrowser *>()->toPlainText();
    for (const char *expected : {"The whole window", "Ctrl+F12", "Handshake trace", "Sequence"})
        EXPECT_TRUE(text.contains(QLatin1String(expected))) << expected;
    actions().keys->trigger();
    EXPECT_EQ(window().findChildren<QDialog *>(QStringLiteral("keys")).size(), 1) << "it is one list";
}

TEST_F(HelpTest, AlarmStopWorksWhileTheKeysAreRead)
{
    send(test::fraba, 0x0200'00FF);
    actions().keys->trigger();
    keys()->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(keys()));
    QTest::keyClick(keys(), Qt::Key_F12, Qt::ControlModifier);
    advance(10);
    EXPECT_EQ(out(test::fraba), 0U);
}

} // namespace
} // namespace codewheel
