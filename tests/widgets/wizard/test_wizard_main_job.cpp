// SPDX-License-Identifier: GPL-3.0-or-later
// The main job: 255 steps, 1 revolution, clockwise, preset 0 at device 1.0, by mouse, by keys, by
// accessibility.
#include "tests/app/screen_reader.h"
#include "tests/widgets/wizard/wizard_test.h"

#include <QAccessible>
#include <QComboBox>
#include <QSignalSpy>

namespace codewheel {
namespace {

class WizardMainJob : public test::WizardTest
{
protected:
    // To the page of the values, with the mode told and nothing read; steps 255.
    void goToStepsUnread()
    {
        wizard.setEncoder(&fraba());
        next();
        click("isPositionMode");
        bus.advance(5);
        next();
        next();
        type("steps", "255");
    }
    void expectDone()
    {
        EXPECT_EQ(wizard.page(), ParameterWizard::handshake);
        EXPECT_FALSE(wizard.isBusy());
        EXPECT_TRUE(text("leftIn").startsWith(QStringLiteral("Verified: read back")))
            << text("leftIn").toStdString() << sentence("handshakeProblem").toStdString();
        const std::pair<Parameter, std::int64_t> values[] = {{Parameter::steps, 255},
                                                             {Parameter::revolutions, 1},
                                                             {Parameter::direction, 3},
                                                             {Parameter::preset, 0}};
        for (const auto &[parameter, value] : values) {
            ASSERT_TRUE(fraba().known(parameter));
            EXPECT_EQ(fraba().known(parameter)->value, value);
            EXPECT_EQ(fraba().known(parameter)->evidence, Evidence::read);
        }
        EXPECT_EQ(fraba().latest().state, EncoderState::operation);
        EXPECT_EQ(fraba().latest().position, 0);
        EXPECT_EQ(out(), 0u);
    }
};

TEST_F(WizardMainJob, ByMouse)
{
    wizard.setEncoder(&fraba());
    next();
    click("readAll");
    bus.advance(3000);
    click("isPositionMode");
    bus.advance(5);
    next();
    next();
    type("steps", "255");
    type("revolutions", "1");
    type("preset", "0");
    leaveField();
    EXPECT_TRUE(find<QAbstractButton>("initialisePreset")->isChecked());
    EXPECT_TRUE(text("scaleText").contains(QStringLiteral("255 steps per turn")));
    next();
    EXPECT_EQ(wizard.page(), ParameterWizard::review);
    EXPECT_EQ(out(), 0u);
    next();
    stepByHand();
    expectDone();
    next();
    EXPECT_TRUE(find<QPlainTextEdit>("account")->toPlainText().contains(QStringLiteral("020000FF")));
}

TEST_F(WizardMainJob, TheSecondOfTwoQuickPressesStartsNothing)
{
    goToStepsUnread();
    leaveField();
    QApplication::setDoubleClickInterval(10 * 60 * 1'000);
    next();
    next();
    EXPECT_EQ(wizard.page(), ParameterWizard::review);
    EXPECT_FALSE(wizard.isBusy());
    QApplication::setDoubleClickInterval(0);
    next();
    EXPECT_EQ(wizard.page(), ParameterWizard::handshake);
    EXPECT_TRUE(wizard.isBusy());
    bus.close();
}

TEST_F(WizardMainJob, UnreadValuesAreReadFirstAndWhatIsThereIsNotWritten)
{
    goToStepsUnread();
    type("revolutions", "1");
    find<QComboBox>("direction")->setFocus();
    QTest::keyClick(find<QComboBox>("direction"), Qt::Key_Down);
    type("preset", "0");
    next();
    EXPECT_TRUE(text("eepromWrites").contains(QStringLiteral("at most 5")));
    next();
    stepByHand();
    expectDone();
    EXPECT_EQ(fraba().eepromWrites(), 3); // steps, preset programmed again, preset activated
}

// A mnemonic shows its button pressed first, so the click comes a little later.
class WizardByKeys : public WizardMainJob
{
protected:
    static void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    }
    static void type(const char *text)
    {
        QTest::keyClicks(QApplication::focusWidget(), QString::fromLatin1(text));
    }
    void turnTo(ParameterWizard::Page page, Qt::Key mnemonic)
    {
        press(mnemonic, Qt::AltModifier);
        EXPECT_TRUE(QTest::qWaitFor([&] { return wizard.page() == page; })) << page;
    }
};

TEST_F(WizardByKeys, TheWholeJob)
{
    wizard.setEncoder(nullptr);
    press(Qt::Key_Down);
    press(Qt::Key_Home);
    EXPECT_EQ(wizard.encoder(), &fraba());
    turnTo(ParameterWizard::known, Qt::Key_N);
    press(Qt::Key_Space); // Read from encoder
    bus.advance(3000);
    press(Qt::Key_P, Qt::AltModifier); // It is in position mode
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return fraba().known(Parameter::startUpMode)->evidence == Evidence::told; }));
    bus.advance(5);
    turnTo(ParameterWizard::direction, Qt::Key_N);
    turnTo(ParameterWizard::values, Qt::Key_N);
    type("255");
    press(Qt::Key_Tab);
    type("1");
    press(Qt::Key_Tab);
    press(Qt::Key_Down); // CW
    press(Qt::Key_Tab);
    type("0");
    turnTo(ParameterWizard::review, Qt::Key_N);
    turnTo(ParameterWizard::handshake, Qt::Key_S);
    for (int i = 0; i < 50 && wizard.isBusy(); ++i) {
        bus.advance(600);
        if (wizard.isBusy())
            press(Qt::Key_Space); // Next step has the focus
    }
    expectDone();
    turnTo(ParameterWizard::report, Qt::Key_R);
}

TEST_F(WizardMainJob, ByAccessibilityAlone)
{
    const test::ScreenReader reader(wizard);
    QAccessibleInterface *list = reader.find(QAccessible::List, QStringLiteral("Encoders of the bus"));
    ASSERT_NE(list, nullptr);
    ASSERT_EQ(list->childCount(), 6);
    list->child(0)->actionInterface()->doAction(QAccessibleActionInterface::toggleAction());
    EXPECT_EQ(wizard.encoder(), &fraba());
    reader.press(QStringLiteral("Next"));
    reader.press(QStringLiteral("Read from encoder"));
    bus.advance(3000);
    reader.press(QStringLiteral("It is in position mode"));
    bus.advance(5);
    reader.press(QStringLiteral("Next"));
    reader.press(QStringLiteral("Next"));
    reader.type(QStringLiteral("Steps"), QStringLiteral("255"));
    reader.type(QStringLiteral("Revolutions"), QStringLiteral("1"));
    reader.type(QStringLiteral("Preset"), QStringLiteral("0"));
    reader.press(QStringLiteral("Next"));
    reader.press(QStringLiteral("Start the handshake"));
    for (int i = 0; i < 50 && wizard.isBusy(); ++i) {
        bus.advance(600);
        if (wizard.isBusy())
            reader.press(QStringLiteral("Next step"));
    }
    expectDone();
    reader.press(QStringLiteral("Report"));
    EXPECT_EQ(wizard.page(), ParameterWizard::report);
}

} // namespace
} // namespace codewheel
