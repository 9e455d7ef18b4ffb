// SPDX-License-Identifier: GPL-3.0-or-later
// Keys in the fields for texts, and what a form takes before it uses its fields.
#include "widgets/input/form_fields.h"
#include "widgets/input/number_fields.h"
#include "widgets/input/text_fields.h"

#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWidget>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class TextFieldsTest : public testing::Test
{
protected:
    TextFieldsTest()
    {
        auto *rows = new QVBoxLayout(&form);
        for (QWidget *field : std::initializer_list<QWidget *>{name, note, number})
            rows->addWidget(field);
        number->setRange(0, 100);
        number->setValue(7);
        name->setText(QStringLiteral("Crane"));
        note->setTakenText(QStringLiteral("in cabinet 3"));
        form.show();
        form.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&form));
        name->setFocus();
        name->end(false);
    }

    QWidget form;
    TextField *name = new TextField(&form);
    NoteField *note = new NoteField(&form);
    IntegerField *number = new IntegerField(&form);
    QSignalSpy names{name, &TextField::taken};
    QSignalSpy notes{note, &NoteField::taken};
};

TEST_F(TextFieldsTest, ALineIsTakenOnceItIsLeftOrReturnIsPressed)
{
    QTest::keyClicks(name, QStringLiteral(" 1"));
    EXPECT_EQ(names.count(), 0);
    EXPECT_EQ(name->takenText(), QStringLiteral("Crane"));
    QTest::keyClick(name, Qt::Key_Return);
    ASSERT_EQ(names.count(), 1);
    EXPECT_EQ(names.at(0).at(0).toString(), QStringLiteral("Crane 1"));
    QTest::keyClicks(name, QStringLiteral("2"));
    number->setFocus();
    ASSERT_EQ(names.count(), 2);
    EXPECT_EQ(name->takenText(), QStringLiteral("Crane 12"));
    name->setFocus();
    number->setFocus();
    EXPECT_EQ(names.count(), 2) << "nothing was typed";
}

TEST_F(TextFieldsTest, EscGivesTheTextBefore)
{
    QTest::keyClicks(name, QStringLiteral(" 1"));
    QTest::keyClick(name, Qt::Key_Escape);
    EXPECT_EQ(name->text(), QStringLiteral("Crane"));
    note->setFocus();
    QTest::keyClicks(note, QStringLiteral("not "));
    QTest::keyClick(note, Qt::Key_Escape);
    EXPECT_EQ(note->toPlainText(), QStringLiteral("in cabinet 3"));
    number->setFocus();
    EXPECT_EQ(names.count() + notes.count(), 0);
}

TEST_F(TextFieldsTest, ANoteIsTakenOnceItIsLeft)
{
    note->setFocus();
    note->moveCursor(QTextCursor::End);
    QTest::keyClick(note, Qt::Key_Return);
    QTest::keyClicks(note, QStringLiteral("key: foreman"));
    EXPECT_EQ(notes.count(), 0);
    name->setFocus();
    ASSERT_EQ(notes.count(), 1);
    EXPECT_EQ(note->takenText(), QStringLiteral("in cabinet 3\nkey: foreman"));
}

TEST_F(TextFieldsTest, WhoSavesTakesWhatIsBeingTyped)
{
    QTest::keyClicks(name, QStringLiteral(" 1"));
    takeFocusedField();
    EXPECT_EQ(names.count(), 1);
    EXPECT_TRUE(name->hasFocus());
    QTest::keyClicks(name, QStringLiteral("2"));
    EXPECT_EQ(name->text(), QStringLiteral("Crane 12")) << "typing goes on";
}

TEST_F(TextFieldsTest, AFormTakesItsFieldsOrSaysWhichIsRefused)
{
    number->setFocus();
    number->selectAll();
    QTest::keyClicks(number, QStringLiteral("9"));
    EXPECT_EQ(takeFields(form), QString());
    EXPECT_EQ(number->value(), 9);
    number->selectAll();
    QTest::keyClicks(number, QStringLiteral("999"));
    name->setFocus();
    EXPECT_EQ(takeFields(form), QStringLiteral("999 is outside 0 to 100."));
    EXPECT_TRUE(number->hasFocus());
    EXPECT_EQ(number->value(), 9);
}

} // namespace
} // namespace codewheel
