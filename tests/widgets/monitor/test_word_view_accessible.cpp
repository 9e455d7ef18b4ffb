// SPDX-License-Identifier: GPL-3.0-or-later
// What assistive technology can do with a word, using only QAccessible interfaces.
#include "widgets/monitor/word_view.h"

#include <QAccessible>
#include <QAccessibleActionInterface>
#include <QAccessibleInterface>
#include <QPoint>
#include <QSignalSpy>
#include <QTest>
#include <QWidget>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class AccessibleWord : public testing::Test
{
protected:
    AccessibleWord()
    {
        window.resize(1400, 200);
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
        word = QAccessible::queryAccessibleInterface(view);
        EXPECT_NE(word, nullptr);
    }

    // As a screen reader finds it: by name and role.
    QAccessibleInterface *bitNamed(const QString &name) const
    {
        for (int i = 0; i < word->childCount(); ++i)
            if (word->child(i)->text(QAccessible::Name) == name &&
                word->child(i)->role() == QAccessible::CheckBox)
                return word->child(i);
        return nullptr;
    }

    QWidget window;
    WordView *view = new WordView(
        wordForm(32, nullptr),
        {{.caption = QStringLiteral("OUT"),
          .place = QStringLiteral("OUT 1.0"),
          .isEditable = true,
          .bitText = [](int bit) { return bit == 25 ? QStringLiteral("Parameter number") : QString(); }},
         {.caption = QStringLiteral("IN"), .place = QStringLiteral("IN 1.0")}},
        &window);
    QAccessibleInterface *word = nullptr;
};

TEST_F(AccessibleWord, IsAGroupOfCheckBoxesWordByWordHighestFirst)
{
    EXPECT_EQ(word->role(), QAccessible::Grouping);
    EXPECT_EQ(word->text(QAccessible::Name), QStringLiteral("OUT 1.0, IN 1.0 bits"));
    ASSERT_EQ(word->childCount(), 64);
    for (int i = 0; i < 64; ++i) {
        QAccessibleInterface *bit = word->child(i);
        ASSERT_NE(bit, nullptr);
        EXPECT_EQ(bit->role(), QAccessible::CheckBox);
        EXPECT_EQ(bit->text(QAccessible::Name),
                  QStringLiteral("%1 1.0 bit %2")
                      .arg(i < 32 ? QStringLiteral("OUT") : QStringLiteral("IN"))
                      .arg(31 - i % 32));
        EXPECT_EQ(bit->parent(), word);
        EXPECT_EQ(word->indexOfChild(bit), i);
        EXPECT_EQ(word->child(i), bit) << "a new object each time";
        EXPECT_TRUE(bit->state().checkable);
        EXPECT_TRUE(bit->state().focusable);
    }
    EXPECT_EQ(word->child(64), nullptr);
    EXPECT_EQ(word->child(-1), nullptr);
}

TEST_F(AccessibleWord, TellsWhichBitsAreSet)
{
    view->setWord(0, 0x0200'00FF, 0x0200'00FF, 0, {});
    for (int i = 0; i < 32; ++i)
        EXPECT_EQ(word->child(i)->state().checked != 0, ((0x0200'00FFU >> (31 - i)) & 1) != 0)
            << "child " << i;
}

TEST_F(AccessibleWord, TellsMeaningAndWhatIsNotSent)
{
    QAccessibleInterface *bit = bitNamed(QStringLiteral("OUT 1.0 bit 25"));
    ASSERT_NE(bit, nullptr);
    EXPECT_EQ(bit->text(QAccessible::Description), QStringLiteral("Parameter number"));
    view->setWord(0, 0x0300'0000, 0, 0, {});
    EXPECT_EQ(bit->text(QAccessible::Description), QStringLiteral("Parameter number (not sent yet)"));
    EXPECT_EQ(bitNamed(QStringLiteral("OUT 1.0 bit 24"))->text(QAccessible::Description),
              QStringLiteral("Not sent yet"));
}

TEST_F(AccessibleWord, AnOutputBitHasAToggleAction)
{
    const QSignalSpy toggled(view, &WordView::bitToggled);
    QAccessibleInterface *bit = bitNamed(QStringLiteral("OUT 1.0 bit 25"));
    ASSERT_NE(bit, nullptr);
    QAccessibleActionInterface *actions = bit->actionInterface();
    ASSERT_NE(actions, nullptr);
    EXPECT_TRUE(actions->actionNames().contains(QAccessibleActionInterface::toggleAction()));
    actions->doAction(QAccessibleActionInterface::toggleAction());
    ASSERT_EQ(toggled.size(), 1);
    EXPECT_EQ(toggled.first().first().value<WordBit>(), (WordBit{0, 25}));
}

TEST_F(AccessibleWord, AnInputBitHasNone)
{
    const QSignalSpy toggled(view, &WordView::bitToggled);
    QAccessibleInterface *bit = bitNamed(QStringLiteral("IN 1.0 bit 25"));
    ASSERT_NE(bit, nullptr);
    EXPECT_TRUE(bit->state().readOnly);
    EXPECT_EQ(bit->actionInterface()->actionNames(),
              QStringList{QAccessibleActionInterface::setFocusAction()});
    bit->actionInterface()->doAction(QAccessibleActionInterface::toggleAction());
    EXPECT_TRUE(toggled.isEmpty());
}

TEST_F(AccessibleWord, FocusCanBeSetAndFound)
{
    QAccessibleInterface *bit = bitNamed(QStringLiteral("OUT 1.0 bit 3"));
    ASSERT_NE(bit, nullptr);
    EXPECT_FALSE(bit->state().focused);
    bit->actionInterface()->doAction(QAccessibleActionInterface::setFocusAction());
    EXPECT_TRUE(bit->state().focused);
    EXPECT_EQ(word->focusChild(), bit);
}

TEST_F(AccessibleWord, ABitIsFoundByItsPlaceOnTheScreen)
{
    for (const int i : {0, 6, 31, 40}) {
        const QPoint center = word->child(i)->rect().center();
        EXPECT_EQ(word->childAt(center.x(), center.y()), word->child(i));
    }
}

TEST_F(AccessibleWord, BitsOfAWordThatIsGoneAreGone)
{
    const QAccessible::Id id = QAccessible::uniqueId(word->child(0));
    ASSERT_NE(QAccessible::accessibleInterface(id), nullptr);
    delete view;
    EXPECT_EQ(QAccessible::accessibleInterface(id), nullptr);
}

} // namespace
} // namespace codewheel
