// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/alarm_stop.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "tests/support/contrast.h"
#include "widgets/look/appearance.h"
#include "widgets/look/grid.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QHash>
#include <QImage>
#include <QLabel>
#include <QSet>
#include <QTest>
#include <QToolButton>
#include <QWidget>

#include <algorithm>
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

// The most frequent colour in its picture.
QRgb groundOf(QWidget &button)
{
    const QImage image = button.grab().toImage();
    QHash<QRgb, int> pixels;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            ++pixels[image.pixel(x, y)];
    return std::max_element(pixels.cbegin(), pixels.cend()).key();
}

TEST_F(AlarmStopTest, IsTheSameRedInLightAndDarkAndStandsOutFromBoth)
{
    auto *button = window().findChild<QToolButton *>(QStringLiteral("alarmStop"));
    QSet<QRgb> reds;
    for (const Scheme scheme : {Scheme::light, Scheme::dark}) {
        applyAppearance(*qApp, {.scheme = scheme});
        reds << groundOf(*button);
        EXPECT_GE(test::contrast(groundOf(*button), qApp->palette().window().color().rgb()), 3.0);
        EXPECT_GE(test::contrast(groundOf(*button), qRgb(255, 255, 255)), 4.5);
    }
    applyAppearance(*qApp, {.scheme = Scheme::light});
    EXPECT_EQ(reds.size(), 1);
}

TEST_F(AlarmStopTest, IsAsLargeAsTheQuestionBesideItButLeavesAFileDialogItsSave)
{
    QRgb besideQuestion = 0;
    {
        test::Question question([&](QWidget &dialog) {
            auto *button = dialog.findChild<QToolButton *>(QStringLiteral("alarmStop"));
            besideQuestion = groundOf(*button);
            for (const auto *label : dialog.findChildren<QLabel *>())
                EXPECT_GE(button->fontInfo().pixelSize(), label->fontInfo().pixelSize());
            EXPECT_TRUE(button->fontInfo().bold());
            const auto *answers = dialog.findChild<QDialogButtonBox *>();
            EXPECT_GE(button->geometry().top() - answers->geometry().bottom(), 3 * grid::unit)
                << "what is near the answers is hit by mistake";
            dialog.close();
        });
        actions().stop->trigger();
    }
    QRgb besideFiles = 0;
    {
        test::Question files([&](QWidget &dialog) {
            besideFiles = groundOf(*dialog.findChild<QToolButton *>(QStringLiteral("alarmStop")));
            dialog.close();
        });
        actions().openProject->trigger();
    }
    EXPECT_EQ(besideQuestion, groundOf(*window().findChild<QToolButton *>(QStringLiteral("alarmStop"))));
    EXPECT_EQ(besideFiles, qApp->palette().window().color().rgb());
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
