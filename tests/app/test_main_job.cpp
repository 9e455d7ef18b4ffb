// SPDX-License-Identifier: GPL-3.0-or-later
// The main job in the whole window: bits of the OUT word, the encoder's answer, the wizard with 255 steps, 1
// revolution, clockwise, preset 0, and what the encoder has afterwards. Once through accessibility only, once
// by keys only.
#include "tests/app/screen_reader.h"
#include "tests/app/window_test.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QAccessible>
#include <QApplication>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::fraba;

class MainJob : public test::WindowTest
{
protected:
    ParameterWizard &wizard() { return *window().findChild<ParameterWizard *>(); }
    EncoderSession &encoder() { return *bus().encoder(fraba); }

    void expectDone()
    {
        EXPECT_FALSE(wizard().isBusy());
        const std::pair<Parameter, std::int64_t> values[] = {{Parameter::steps, 255},
                                                             {Parameter::revolutions, 1},
                                                             {Parameter::direction, 3},
                                                             {Parameter::preset, 0}};
        for (const auto &[parameter, value] : values) {
            ASSERT_TRUE(encoder().known(parameter)) << parameterKey(parameter).toStdString();
            EXPECT_EQ(encoder().known(parameter)->value, value);
            EXPECT_EQ(encoder().known(parameter)->evidence, Evidence::read);
        }
        EXPECT_EQ(encoder().latest().state, EncoderState::operation);
        EXPECT_EQ(encoder().latest().position, 0) << "the preset was initialised";
        EXPECT_EQ(out(fraba), 0u);
    }
};

TEST_F(MainJob, ByAccessibilityAlone)
{
    const test::ScreenReader reader(window());
    // bits and the answer of the encoder
    reader.toggle(QStringLiteral("OUT 1.0 bit 27"));
    reader.toggle(QStringLiteral("OUT 1.0 bit 0"));
    EXPECT_EQ(reader.read(QStringLiteral("OUT 1.0 hexadecimal")), QStringLiteral("08000001"));
    EXPECT_EQ(out(fraba), 0u) << "staged, not sent";
    reader.press(QStringLiteral("Write OUT 1.0"));
    advance(66);
    EXPECT_EQ(reader.read(QStringLiteral("IN 1.0 hexadecimal")), QStringLiteral("C8000001"));
    EXPECT_TRUE(reader.isChecked(QStringLiteral("IN 1.0 bit 31")));
    reader.type(QStringLiteral("OUT 1.0 hexadecimal"), QStringLiteral("80000000"));
    reader.press(QStringLiteral("Write OUT 1.0"));
    advance(66);
    reader.type(QStringLiteral("OUT 1.0 hexadecimal"), QStringLiteral("00000000"));
    reader.press(QStringLiteral("Write OUT 1.0"));
    advance(66);
    EXPECT_EQ(encoder().known(Parameter::preset)->value, 1);

    reader.press(QStringLiteral("Parameter wizard"));
    reader.press(QStringLiteral("Next"));
    reader.press(QStringLiteral("Read from encoder"));
    advance(2000);
    reader.press(QStringLiteral("Next"));
    reader.press(QStringLiteral("Next"));
    reader.type(QStringLiteral("Steps"), QStringLiteral("255"));
    reader.type(QStringLiteral("Revolutions"), QStringLiteral("1"));
    reader.type(QStringLiteral("Preset"), QStringLiteral("0"));
    reader.press(QStringLiteral("Next"));
    ASSERT_EQ(wizard().page(), ParameterWizard::review);
    reader.press(QStringLiteral("Start the handshake"));
    for (int i = 0; i < 60 && wizard().isBusy(); ++i) {
        advance(600); // position 0 has to last
        if (wizard().isBusy())
            reader.press(QStringLiteral("Next step"));
    }
    advance(66);
    expectDone();
}

// A mnemonic shows its button pressed first, so the click comes a little later.
TEST_F(MainJob, ByKeysAlone)
{
    const auto press = [](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    };
    const auto type = [](const char *text) {
        QTest::keyClicks(QApplication::focusWidget(), QString::fromLatin1(text));
    };
    const auto reach = [](const QString &name) { // presses Tab until it has the focus
        for (int i = 0; i < 200; ++i) {
            if (QAccessible::queryAccessibleInterface(QApplication::focusWidget())->text(QAccessible::Name) ==
                name)
                return;
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        }
        ADD_FAILURE() << "Tab never comes to " << name.toStdString();
    };
    const auto turnTo = [&](ParameterWizard::Page page, Qt::Key mnemonic) {
        press(mnemonic, Qt::AltModifier);
        EXPECT_TRUE(QTest::qWaitFor([&] { return wizard().page() == page; })) << page;
    };

    reach(QStringLiteral("OUT 1.0 hexadecimal"));
    press(Qt::Key_A, Qt::ControlModifier);
    type("08000001");
    press(Qt::Key_Return, Qt::ControlModifier);
    advance(66);
    EXPECT_EQ(in(fraba), 0xC800'0001u);
    for (const char *word : {"80000000", "00000000"}) {
        press(Qt::Key_A, Qt::ControlModifier);
        type(word);
        press(Qt::Key_Return, Qt::ControlModifier);
        advance(66);
    }
    EXPECT_EQ(encoder().latest().state, EncoderState::operation);

    press(Qt::Key_F6);
    turnTo(ParameterWizard::known, Qt::Key_N);
    reach(QStringLiteral("Read from encoder"));
    press(Qt::Key_Space);
    advance(2000);
    turnTo(ParameterWizard::direction, Qt::Key_N);
    turnTo(ParameterWizard::values, Qt::Key_N);
    const std::pair<const char *, const char *> fields[] = {
        {"Steps", "255"}, {"Revolutions", "1"}, {"Preset", "0"}};
    for (const auto &[field, value] : fields) {
        reach(QString::fromLatin1(field));
        press(Qt::Key_A, Qt::ControlModifier);
        type(value);
    }
    turnTo(ParameterWizard::review, Qt::Key_N);
    turnTo(ParameterWizard::handshake, Qt::Key_S);
    for (int i = 0; i < 60 && wizard().isBusy(); ++i) {
        advance(600); // position 0 has to last
        if (wizard().isBusy())
            press(Qt::Key_Space); // Next step has the focus
    }
    advance(66);
    expectDone();
}

} // namespace
} // namespace codewheel
