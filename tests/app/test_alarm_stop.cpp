// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/alarm_stop.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"

#include <QApplication>
#include <QSet>
#include <QTest>
#include <QToolButton>
#include <QWidget>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class AlarmStopTest : public test::WindowTest
{
protected:
    AlarmStopTest()
    {
        send(fraba, 0x0200'00FF);
        send(baumer, 0x0400'0001);
    }
    void expectZero()
    {
        advance(5);
        EXPECT_EQ(out(fraba), 0u);
        EXPECT_EQ(out(baumer), 0u);
    }
    static void pressKey(QWidget *widget) { QTest::keyClick(widget, Qt::Key_F12, Qt::ControlModifier); }
};

TEST_F(AlarmStopTest, ItsButtonZeroesTheWholeRing)
{
    auto *button = window().findChild<QToolButton *>(QStringLiteral("alarmStop"));
    ASSERT_NE(button, nullptr);
    EXPECT_EQ(button->accessibleName(), QStringLiteral("ALARM STOP 2 buses"));
    EXPECT_TRUE(button->toolTip().contains(QStringLiteral("Ring: all OUT words become 0")));
    QTest::mouseClick(button, Qt::LeftButton);
    expectZero();
}

TEST_F(AlarmStopTest, ItsKeyWorksFromEveryFocus)
{
    QSet<const QWidget *> tried;
    for (QWidget *widget : window().findChildren<QWidget *>()) {
        if (!widget->isVisible() || (widget->focusPolicy() & Qt::TabFocus) == 0 || !widget->isEnabled())
            continue;
        send(fraba, 0x0000'0001);
        ASSERT_NE(out(fraba), 0u);
        widget->setFocus();
        tried << QApplication::focusWidget();
        pressKey(QApplication::focusWidget());
        advance(5);
        EXPECT_EQ(out(fraba), 0u) << widget->metaObject()->className() << " "
                                  << widget->accessibleName().toStdString();
        bus().setRunning(true);
        advance(5);
    }
    EXPECT_GE(tried.size(), 50);
}

TEST_F(AlarmStopTest, ItsKeyWorksWhileAQuestionIsAsked)
{
    test::Question question([this](QWidget &dialog) {
        pressKey(&dialog);
        expectZero();
        dialog.close();
    });
    actions().stop->trigger();
    EXPECT_EQ(bus().latest().state, MasterState::ready) << "the question was not answered";
}

TEST_F(AlarmStopTest, EveryModalDialogCarriesAButtonForIt)
{
    test::Question question([this](QWidget &dialog) {
        auto *button = dialog.findChild<QToolButton *>(QStringLiteral("alarmStop"));
        ASSERT_NE(button, nullptr);
        EXPECT_TRUE(button->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
        expectZero();
        dialog.close();
    });
    actions().about->trigger();
}

TEST_F(AlarmStopTest, WorksInWatchAndWhileStopped)
{
    bus().setOperate(false);
    advance(5);
    actions().alarmStop->trigger();
    expectZero();
}

} // namespace
} // namespace codewheel
