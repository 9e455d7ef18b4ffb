// SPDX-License-Identifier: GPL-3.0-or-later
// A question that has just opened is not answered by the key or click that opened it.
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/structure/structure_view.h"

#include <QAction>
#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::fraba;

class NewQuestions : public test::WindowTest
{
protected:
    ~NewQuestions() override { QApplication::setDoubleClickInterval(0); }

    void askForReset()
    {
        for (QAction *action : window().findChild<ParameterPanel *>()->functionActions())
            if (action->objectName() == QStringLiteral("resetToDefault"))
                action->trigger();
    }
    static QAbstractButton *yes(QWidget &dialog)
    {
        for (auto *button : dialog.findChildren<QAbstractButton *>())
            if (button->text() == QStringLiteral("&Reset"))
                return button;
        return nullptr;
    }
    bool isReset() { return bus().encoder(fraba)->runningJob().has_value(); }
};

TEST_F(NewQuestions, TheSecondOfTwoQuickClicksAgreesToNothing)
{
    QApplication::setDoubleClickInterval(10 * 60 * 1'000);
    const test::Question question([](QWidget &dialog) {
        QTest::mouseClick(yes(dialog), Qt::LeftButton);
        EXPECT_TRUE(dialog.isVisible());
        QTest::keyClick(&dialog, Qt::Key_R);
        QTest::qWait(200); // it would be pressed with a delay
        EXPECT_TRUE(dialog.isVisible());
        QTest::keyClick(&dialog, Qt::Key_Escape);
        EXPECT_FALSE(dialog.isVisible());
    });
    askForReset();
    EXPECT_FALSE(isReset());
}

TEST_F(NewQuestions, AlarmStopWorksAtOnceInAQuestion)
{
    QApplication::setDoubleClickInterval(10 * 60 * 1'000);
    const test::Question question([this](QWidget &dialog) {
        QTest::mouseClick(dialog.findChild<QAbstractButton *>(QStringLiteral("alarmStop")), Qt::LeftButton);
        advance(100);
        EXPECT_FALSE(bus().isRunning());
        dialog.close();
    });
    askForReset();
}

TEST_F(NewQuestions, ALetterThatIsHeldAgreesToNothing)
{
    const test::Question question([](QWidget &dialog) {
        for (int repeats = 0; repeats < 5; ++repeats) {
            QTest::simulateEvent(&dialog, true, Qt::Key_R, Qt::NoModifier, QStringLiteral("r"), true);
            QTest::simulateEvent(&dialog, true, Qt::Key_R, Qt::AltModifier, QStringLiteral("r"), true);
            QTest::qWait(50);
        }
        EXPECT_TRUE(dialog.isVisible());
        QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    askForReset();
    EXPECT_FALSE(isReset());
}

// "Write…" and the button of its review have the same letter.
TEST_F(NewQuestions, AltAndALetterThatIsHeldPressesOneButton)
{
    auto *first = new QPushButton(QStringLiteral("&J first"), &window());
    auto *second = new QPushButton(QStringLiteral("&J second"), &window());
    int pressed = 0;
    QObject::connect(first, &QPushButton::clicked, first, [&] {
        first->hide();
        second->show();
    });
    QObject::connect(second, &QPushButton::clicked, second, [&] { ++pressed; });
    first->show();
    second->hide();
    QTest::simulateEvent(&window(), true, Qt::Key_J, Qt::AltModifier, QStringLiteral("j"), false);
    ASSERT_TRUE(QTest::qWaitFor([&] { return second->isVisible(); }));
    for (int repeats = 0; repeats < 5; ++repeats) {
        QTest::simulateEvent(&window(), true, Qt::Key_J, Qt::AltModifier, QStringLiteral("j"), true);
        QTest::qWait(150);
    }
    EXPECT_EQ(pressed, 0);
    QTest::simulateEvent(&window(), true, Qt::Key_J, Qt::AltModifier, QStringLiteral("j"), false);
    EXPECT_TRUE(QTest::qWaitFor([&] { return pressed == 1; }));
}

} // namespace
} // namespace codewheel
