// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse, keys and wheel on the fields for numbers.
#include "widgets/input/input_rules.h"
#include "widgets/input/number_fields.h"

#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QtTest/qtestspontaneevent.h>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class NumberFieldsTest : public testing::Test
{
protected:
    NumberFieldsTest()
    {
        installInputRules(&rules);
        auto *form = new QWidget;
        auto *rows = new QVBoxLayout(form);
        for (QWidget *field : std::initializer_list<QWidget *>{&decimal, &whole, &choice, &slider, &other})
            rows->addWidget(field);
        rows->addSpacing(2'000);
        area.setWidget(form);
        decimal.setRange(0, 1'000'000);
        decimal.setDecimals(4);
        decimal.setValue(25);
        whole.setRange(0, 100);
        whole.setSuffix(QStringLiteral(" %"));
        whole.setValue(7);
        choice.addItems({QStringLiteral("one"), QStringLiteral("two"), QStringLiteral("three")});
        slider.setOrientation(Qt::Horizontal);
        slider.setValue(50);
        area.resize(300, 200);
        area.show();
        area.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&area));
        other.setFocus();
    }
    ~NumberFieldsTest() override
    {
        area.takeWidget(); // the fields are members
        for (QWidget *field : std::initializer_list<QWidget *>{&decimal, &whole, &choice, &slider, &other})
            field->setParent(nullptr);
    }

    static void type(QAbstractSpinBox &field, const char *text)
    {
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, QString::fromLatin1(text));
    }

    // One notch, as sent by a mouse.
    void turnWheelOver(QWidget &field)
    {
        const QPoint local = field.rect().center();
        QWheelEvent event(local, field.mapToGlobal(local), {}, QPoint(0, -120), Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QSpontaneKeyEvent::setSpontaneous(&event); // otherwise it would not be passed on
        qApp->notify(&field, &event);
    }
    int scrolled() const { return area.verticalScrollBar()->value(); }

    QObject rules; // that hold as long as it lives
    QScrollArea area;
    DecimalField decimal;
    IntegerField whole;
    QComboBox choice;
    QSlider slider;
    QLineEdit other;
};

TEST_F(NumberFieldsTest, AValueIsTakenWhenReturnIsPressedAndNotBefore)
{
    const QSignalSpy changes(&decimal, &QDoubleSpinBox::valueChanged);
    type(decimal, "0,01");
    EXPECT_EQ(changes.size(), 0);
    EXPECT_EQ(decimal.value(), 25);
    QTest::keyClick(&decimal, Qt::Key_Return);
    EXPECT_EQ(changes.size(), 1);
    EXPECT_EQ(decimal.value(), 0.01);
}

TEST_F(NumberFieldsTest, AValueIsTakenWhenTheFieldIsLeft)
{
    type(whole, "42");
    EXPECT_EQ(whole.value(), 7);
    QTest::keyClick(&whole, Qt::Key_Tab);
    EXPECT_EQ(whole.value(), 42);
    EXPECT_EQ(whole.text(), QStringLiteral("42 %"));
}

TEST_F(NumberFieldsTest, WhatIsRefusedIsSaidAtTheFieldAndNotTaken)
{
    type(decimal, "1,000");
    EXPECT_FALSE(decimal.hasAcceptableInput());
    QLineEdit *text = decimal.findChild<QLineEdit *>();
    EXPECT_TRUE(text->accessibleDescription().contains(QStringLiteral("may mean")));
    other.setFocus();
    EXPECT_EQ(decimal.value(), 25);
    EXPECT_EQ(decimal.text(), QStringLiteral("1,000")); // to be corrected
    EXPECT_TRUE(text->accessibleDescription().contains(QStringLiteral("may mean")));
    decimal.setValue(3);
    EXPECT_EQ(decimal.text(), QStringLiteral("3.0000"));
    EXPECT_EQ(text->accessibleDescription(), QString());

    type(whole, "2.5");
    EXPECT_TRUE(
        whole.findChild<QLineEdit *>()->accessibleDescription().contains(QStringLiteral("whole number")));
    other.setFocus();
    EXPECT_EQ(whole.value(), 7);

    type(whole, "1.000");
    EXPECT_TRUE(whole.findChild<QLineEdit *>()->accessibleDescription().contains(
        QStringLiteral("Digits only, for example 1000")));
    other.setFocus();
    EXPECT_EQ(whole.value(), 7);

    type(whole, "300");
    EXPECT_TRUE(whole.findChild<QLineEdit *>()->accessibleDescription().contains(QStringLiteral("0 to 100")));
    other.setFocus();
    EXPECT_EQ(whole.value(), 7);
}

TEST_F(NumberFieldsTest, TheRangeIsSaidAsNumbersAreWrittenInTheCountry)
{
    const auto complaint = [](QWidget &field) {
        return field.findChild<QLineEdit *>()->accessibleDescription();
    };
    decimal.setDecimals(1);
    whole.setRange(1, 8'388'608);
    for (const auto &[locale, range] :
         {std::pair(QLocale(QLocale::English, QLocale::UnitedStates), QStringLiteral("1 to 8,388,608")),
          {QLocale(QLocale::German, QLocale::Germany), QStringLiteral("1 to 8.388.608")}}) {
        whole.setLocale(locale);
        type(whole, "9000000");
        EXPECT_TRUE(complaint(whole).contains(QStringLiteral("9000000 is outside ") + range))
            << complaint(whole).toStdString();
    }
    decimal.setLocale(QLocale(QLocale::German, QLocale::Germany));
    type(decimal, "2000000");
    EXPECT_TRUE(complaint(decimal).contains(QStringLiteral("0,0 to 1.000.000,0")))
        << complaint(decimal).toStdString();
}

TEST_F(NumberFieldsTest, TheNumberOfSomethingHasNoSignsBetweenThousands)
{
    whole.setLocale(QLocale(QLocale::German, QLocale::Germany));
    whole.setRange(1, 65'535);
    leaveSeparatorsOut(whole);
    type(whole, "70000");
    const QString complaint = whole.findChild<QLineEdit *>()->accessibleDescription();
    EXPECT_TRUE(complaint.contains(QStringLiteral("1 to 65535"))) << complaint.toStdString();
}

TEST_F(NumberFieldsTest, SpacesMayStandBetweenDigits)
{
    decimal.setRange(0, 10'000);
    type(decimal, "1 000");
    EXPECT_EQ(decimal.findChild<QLineEdit *>()->accessibleDescription(), QString());
    QTest::keyClick(&decimal, Qt::Key_Return);
    EXPECT_EQ(decimal.value(), 1000);
}

TEST_F(NumberFieldsTest, WhatIsRefusedStaysToBeCorrectedAfterReturn)
{
    type(decimal, "1,000");
    QTest::keyClick(&decimal, Qt::Key_Return);
    EXPECT_EQ(decimal.text(), QStringLiteral("1,000"));
    EXPECT_EQ(decimal.value(), 25);
    QTest::keyClick(&decimal, Qt::Key_Backspace);
    QTest::keyClick(&decimal, Qt::Key_Return);
    EXPECT_EQ(decimal.value(), 1);
}

TEST_F(NumberFieldsTest, WhatIsRefusedIsStillThereWhenItsPageIsShownAgain)
{
    const QLineEdit *text = decimal.findChild<QLineEdit *>();
    for (const bool hasFocus : {true, false}) {
        type(decimal, "1,000");
        if (!hasFocus)
            other.setFocus();
        area.hide();
        area.show();
        EXPECT_EQ(decimal.text(), QStringLiteral("1,000")) << hasFocus;
        EXPECT_TRUE(text->accessibleDescription().contains(QStringLiteral("may mean"))) << hasFocus;
    }
}

TEST_F(NumberFieldsTest, WhatCodeSetsIsNotMarkedAsRefused)
{
    type(decimal, "1,000");
    other.setFocus();
    const QSignalBlocker quiet(&decimal);
    decimal.setValue(25); // as before
    EXPECT_EQ(decimal.text(), QStringLiteral("25.0000"));
    EXPECT_EQ(decimal.findChild<QLineEdit *>()->accessibleDescription(), QString());
}

TEST_F(NumberFieldsTest, EscGivesTheValueBefore)
{
    type(whole, "42");
    QTest::keyClick(&whole, Qt::Key_Escape);
    EXPECT_EQ(whole.text(), QStringLiteral("7 %"));
    other.setFocus();
    EXPECT_EQ(whole.value(), 7);
}

TEST_F(NumberFieldsTest, TheWheelScrollsOverAFieldWithoutFocus)
{
    for (QWidget *field : std::initializer_list<QWidget *>{&decimal, &whole, &choice, &slider}) {
        const int before = scrolled();
        turnWheelOver(*field);
        EXPECT_GT(scrolled(), before) << field->metaObject()->className();
    }
    EXPECT_EQ(decimal.value(), 25);
    EXPECT_EQ(whole.value(), 7);
    EXPECT_EQ(choice.currentIndex(), 0);
    EXPECT_EQ(slider.value(), 50);
}

TEST_F(NumberFieldsTest, TheWheelChangesTheFieldThatHasTheFocus)
{
    whole.setFocus();
    turnWheelOver(whole);
    EXPECT_EQ(whole.value(), 6);
    EXPECT_EQ(scrolled(), 0);
}

TEST_F(NumberFieldsTest, TheWheelGivesNoFocus)
{
    DecimalField field;
    QComboBox box;
    field.ensurePolished();
    box.ensurePolished();
    EXPECT_EQ(field.focusPolicy(), Qt::StrongFocus);
    EXPECT_EQ(box.focusPolicy(), Qt::StrongFocus);
}

} // namespace
} // namespace codewheel
