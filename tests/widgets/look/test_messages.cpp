// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences shown in place: inline messages and empty states.
#include "widgets/look/empty_state.h"
#include "widgets/look/inline_message.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QAccessibleInterface>
#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWidget>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

QAbstractButton *buttonNamed(const QWidget &parent, const QString &name)
{
    for (auto *button : parent.findChildren<QAbstractButton *>())
        if (button->isVisible() &&
            QAccessible::queryAccessibleInterface(button)->text(QAccessible::Name) == name)
            return button;
    return nullptr;
}

class InlineMessages : public testing::Test
{
protected:
    InlineMessages()
    {
        window.resize(600, 100);
        window.show();
    }

    QWidget window;
    InlineMessage message{&window};
    QString sentence = QStringLiteral("The word has 9 digits. At most 8 fit.");
};

TEST_F(InlineMessages, IsNotThereUntilThereIsSomethingToSay)
{
    EXPECT_FALSE(message.isVisible());
    message.showMessage(Role::fault, sentence);
    EXPECT_TRUE(message.isVisible());
    EXPECT_EQ(message.sentence(), sentence);
    EXPECT_EQ(QAccessible::queryAccessibleInterface(&message)->text(QAccessible::Name),
              QStringLiteral("Fault: ") + sentence);
}

TEST_F(InlineMessages, GoesWithItsCause)
{
    const QSignalSpy closed(&message, &InlineMessage::closed);
    message.showMessage(Role::fault, sentence);
    message.withdraw();
    EXPECT_FALSE(message.isVisible());
    EXPECT_EQ(message.sentence(), QString());
    EXPECT_TRUE(closed.isEmpty());
}

TEST_F(InlineMessages, InANarrowPanelTheButtonStandsBelowTheSentence)
{
    auto *column = new QVBoxLayout(&window);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(&message);
    message.showMessage(Role::attention, sentence, QStringLiteral("Name the encoder"));
    const auto *button = buttonNamed(message, QStringLiteral("Name the encoder"));
    const QLabel *said = nullptr;
    for (const auto *label : message.findChildren<QLabel *>())
        if (!label->text().isEmpty())
            said = label;
    const auto isBelow = [&](int width) {
        window.resize(width, 300);
        QCoreApplication::processEvents();
        EXPECT_LE(button->geometry().right(), message.width());
        EXPECT_FALSE(button->geometry().intersects(said->geometry()));
        return button->y() > said->geometry().bottom();
    };
    EXPECT_FALSE(isBelow(600));
    EXPECT_TRUE(isBelow(180));
    EXPECT_LE(window.width(), 180) << "it does not make its panel grow";
    EXPECT_FALSE(isBelow(600));
}

TEST_F(InlineMessages, ACommandIsShownAndCopied)
{
    message.showTrouble(Role::fault,
                        {QStringLiteral("You may not use <b>it</b>."), QStringLiteral("sudo a && b")});
    auto *copy = buttonNamed(message, QStringLiteral("Copy command"));
    ASSERT_NE(copy, nullptr);
    EXPECT_EQ(message.sentence(), QStringLiteral("You may not use <b>it</b>."));
    EXPECT_EQ(message.accessibleDescription(), QStringLiteral("sudo a && b"));
    QTest::mouseClick(copy, Qt::LeftButton);
    EXPECT_EQ(QGuiApplication::clipboard()->text(), QStringLiteral("sudo a && b"));
    EXPECT_NE(buttonNamed(message, QStringLiteral("Copied")), nullptr);
    message.showMessage(Role::fault, QStringLiteral("Something else."));
    EXPECT_EQ(buttonNamed(message, QStringLiteral("Copied")), nullptr);
    EXPECT_EQ(buttonNamed(message, QStringLiteral("Copy command")), nullptr);
    EXPECT_TRUE(message.command().isEmpty());
}

TEST_F(InlineMessages, CanBeClosed)
{
    const QSignalSpy closed(&message, &InlineMessage::closed);
    message.showMessage(Role::attention, sentence);
    QAbstractButton *button = buttonNamed(message, QStringLiteral("Close this message"));
    ASSERT_NE(button, nullptr);
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_FALSE(message.isVisible());
    EXPECT_EQ(closed.size(), 1);
}

TEST_F(InlineMessages, OffersWhatHelps)
{
    const QSignalSpy triggered(&message, &InlineMessage::actionTriggered);
    message.showMessage(Role::attention, sentence, QStringLiteral("Operate"));
    message.resize(message.sizeHint());
    QAbstractButton *button = buttonNamed(message, QStringLiteral("Operate"));
    ASSERT_NE(button, nullptr);
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_EQ(triggered.size(), 1);
    message.showMessage(Role::attention, sentence);
    EXPECT_EQ(buttonNamed(message, QStringLiteral("Operate")), nullptr);
}

// It comes between the mouse and what was to be clicked.
TEST_F(InlineMessages, ForTheTimeOfADoubleClickItTakesNoClick)
{
    const QSignalSpy triggered(&message, &InlineMessage::actionTriggered);
    const QSignalSpy closed(&message, &InlineMessage::closed);
    message.showMessage(Role::attention, sentence, QStringLiteral("Operate"));
    message.resize(message.sizeHint());
    QAbstractButton *button = buttonNamed(message, QStringLiteral("Operate"));
    ASSERT_NE(button, nullptr);
    QApplication::setDoubleClickInterval(10 * 60 * 1'000);
    QTest::mouseClick(button, Qt::LeftButton);
    QTest::mouseDClick(button, Qt::LeftButton);
    QTest::mouseClick(buttonNamed(message, QStringLiteral("Close this message")), Qt::LeftButton);
    EXPECT_TRUE(triggered.isEmpty());
    EXPECT_TRUE(closed.isEmpty());
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Space);
    EXPECT_EQ(triggered.size(), 1) << "a key goes where the focus is";
    QApplication::setDoubleClickInterval(0); // it is over
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_EQ(triggered.size(), 2);
}

TEST(EmptyState, SaysWhatBelongsHereAndOffersIt)
{
    EmptyState state(Icon::monitor, QStringLiteral("No monitor is open"), QStringLiteral("Choose a device."));
    const QSignalSpy triggered(&state, &EmptyState::actionTriggered);
    state.setAction(QStringLiteral("Open IN 32"));
    state.resize(300, 200);
    state.show();
    QAccessibleInterface *interface = QAccessible::queryAccessibleInterface(&state);
    EXPECT_EQ(interface->text(QAccessible::Name), QStringLiteral("No monitor is open"));
    EXPECT_EQ(interface->text(QAccessible::Description), QStringLiteral("Choose a device."));
    QAbstractButton *button = buttonNamed(state, QStringLiteral("Open IN 32"));
    ASSERT_NE(button, nullptr);
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_EQ(triggered.size(), 1);
    state.setAction({});
    EXPECT_EQ(buttonNamed(state, QStringLiteral("Open IN 32")), nullptr);
}

} // namespace
} // namespace codewheel
