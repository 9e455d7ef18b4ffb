// SPDX-License-Identifier: GPL-3.0-or-later
// An encoder on a CAN bus is replaced in the window: number, values, and the proof that both are kept.
#include "app/window/window_actions.h"
#include "tests/app/kinds/canopen/canopen_window_test.h"
#include "widgets/kinds/canopen/setup/can_replace_steps.h"
#include "widgets/kinds/canopen/setup/node_setup_view.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/transfer/replace_page.h"

#include <QLabel>
#include <QMenuBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>

#include <gtest/gtest.h>
#include <map>

namespace codewheel {
namespace {

using test::nodeSix;

constexpr std::size_t oldSix = 1; // encoders of the training bus
constexpr std::size_t newOne = 3; // without a number

class CanopenReplace : public test::CanopenWindowTest
{
protected:
    CanopenReplace()
    {
        canActions().training->trigger();
        advance(1'500);
        shown->project().editDevice(nodeSix, QStringLiteral("wanted"), [](ProjectDevice &device) {
            device.wanted = {{Parameter::steps, 1'024}, {Parameter::measuringRange, 4'194'304}};
        });
        switchSupply(oldSix, false);
    }

    template <typename Widget>
    Widget &widget(const char *name = nullptr)
    {
        return *window().findChild<Widget *>(QString::fromLatin1(name));
    }
    ReplacePage &replacing() { return widget<ReplacePage>(); }
    // In the page of the replacement: there is one view of a number elsewhere.
    template <typename Widget>
    Widget &part(const char *name = nullptr)
    {
        return *replacing().findChild<Widget *>(QString::fromLatin1(name));
    }
    void press(QAbstractButton &button)
    {
        EXPECT_TRUE(button.isEnabled()) << button.text().toStdString();
        QTest::mouseClick(&button, Qt::LeftButton, {}, {6, button.height() / 2});
        advance(50);
    }
    void click(const char *name) { press(part<QPushButton>(name)); }
    bool mayGoOn() { return part<QPushButton>("replaceNext").isEnabled(); }
    void agree()
    {
        QTest::qWait(400); // a question takes no click at once
        for (auto *button : part<InlineMessage>("nodeSetupMessage").findChildren<QPushButton *>())
            if (plainLabel(button->text()) == QStringLiteral("Send"))
                press(*button);
        advance(20'000);
    }
    void switchSupply(std::size_t which, bool isOn)
    {
        canBus().training()->withEncoder(which, [isOn](canopen::SimulatedNode &node) { node.setOn(isOn); });
        advance(1'000);
    }
    std::optional<int> numberOf(std::size_t which)
    {
        return canBus().training()->withEncoder(which,
                                                [](canopen::SimulatedNode &node) { return node.node(); });
    }
    std::int64_t objectOf(std::size_t which, std::uint16_t index)
    {
        return canBus().training()->withEncoder(
            which, [index](canopen::SimulatedNode &node) { return node.objects().number(index, 0); });
    }
    // The page at the step of the number.
    void openAtNumber()
    {
        tree().choose(nodeSix);
        advance(100);
        ASSERT_TRUE(actions().replaceEncoder->isEnabled());
        actions().replaceEncoder->trigger();
        advance(50);
        click("replaceNext");
    }
    // The encoder without a number gets that of the old one.
    void giveNumber()
    {
        press(part<QRadioButton>("canReplaceHasNone"));
        click("nodeSetupFind");
        advance(30'000);
        click("nodeSetupWrite");
        agree();
    }
    // From there on, as far as the proof.
    void writeValues()
    {
        click("replaceNext"); // to the position
        advance(3'000);
        press(part<QRadioButton>("positionNone"));
        click("replaceNext");
        QTest::qWait(600); // no double click
        click("replaceNext");
        advance(20'000);
    }
    QString proof() { return part<QLabel>("canReplaceProof").text(); }
    QString told() { return part<InlineMessage>("nodeSetupMessage").sentence(); }
};

TEST_F(CanopenReplace, OneWithoutANumberGetsNumberAndValuesAndBothAreProven)
{
    openAtNumber();
    EXPECT_FALSE(mayGoOn()) << "it has no number yet";
    giveNumber();
    EXPECT_EQ(numberOf(newOne), 6) << told().toStdString();
    EXPECT_TRUE(mayGoOn());
    EXPECT_TRUE(replacing().lostByClosing().contains(QStringLiteral("has got the number 6 (06h)")));
    writeValues();
    EXPECT_EQ(objectOf(newOne, 0x6001), 1'024);
    click("replaceNext"); // from the account to the proof
    click("canReplaceCheck");
    advance(10'000);
    EXPECT_TRUE(proof().contains(QStringLiteral("not switched off"))) << proof().toStdString();
    switchSupply(newOne, false);
    switchSupply(newOne, true);
    click("canReplaceCheck");
    advance(15'000);
    EXPECT_TRUE(proof().startsWith(QStringLiteral("Proven"))) << proof().toStdString();
    EXPECT_TRUE(proof().contains(QStringLiteral("(2)"))) << proof().toStdString();
    EXPECT_EQ(objectOf(newOne, 0x6001), 1'024);
}

// The new one shows itself, loses its supply, and comes back somewhere else.
TEST_F(CanopenReplace, ThePositionThatIsOfferedIsThatOfTheEncoderThatWasThere)
{
    switchSupply(oldSix, true);
    advance(3'000);
    const auto before = shown->plant().positions().newest(nodeSix);
    ASSERT_TRUE(before);
    switchSupply(oldSix, false);
    openAtNumber();
    giveNumber();
    canBus().training()->withEncoder(newOne,
                                     [](canopen::SimulatedNode &node) { node.shaft().turnBy(20'000); });
    advance(2'000);
    switchSupply(newOne, false);
    advance(5'000);
    canBus().training()->withEncoder(newOne,
                                     [](canopen::SimulatedNode &node) { node.shaft().turnBy(30'000); });
    switchSupply(newOne, true);
    advance(5'000);
    ASSERT_NE(shown->plant().positions().newest(nodeSix)->position, before->position);
    EXPECT_EQ(shown->plant().positions().at(nodeSix)->position, before->position);
}

// A row of steps is beside it, and the buttons of the page below.
TEST_F(CanopenReplace, AltAndALetterDoesOneThing)
{
    openAtNumber();
    std::map<QKeySequence, QString> owners;
    QStringList texts;
    for (const QAction *menu : window().menuBar()->actions())
        texts << menu->text();
    for (const auto *button : replacing().findChildren<QAbstractButton *>())
        if (button->isVisible())
            texts << button->text();
    for (const auto *label : replacing().findChildren<QLabel *>())
        if (label->isVisible() && label->buddy() != nullptr)
            texts << label->text();
    for (const QString &text : texts) {
        const QKeySequence key = QKeySequence::mnemonic(text);
        EXPECT_TRUE(key.isEmpty() || owners.emplace(key, text).second)
            << text.toStdString() << " and " << owners[key].toStdString();
    }
    EXPECT_GT(owners.size(), 10U);
}

TEST_F(CanopenReplace, OneThatComesAsNode127IsAskedAboutFirst)
{
    canActions().unnumbered->trigger();
    advance(50);
    session().configure({.kind = canopen::LssRequest::Kind::fastScan});
    advance(30'000);
    session().configure({.kind = canopen::LssRequest::Kind::setNode, .number = 127});
    session().configure({.kind = canopen::LssRequest::Kind::store});
    session().configure({.kind = canopen::LssRequest::Kind::operateAll});
    advance(3'000);
    ASSERT_EQ(numberOf(newOne), 127);
    openAtNumber();
    EXPECT_EQ(part<QSpinBox>("canReplaceNumber").value(), 127);
    EXPECT_EQ(part<QSpinBox>("nodeSetupNumber").value(), 6);
    click("nodeSetupRead");
    advance(2'000);
    click("nodeSetupWrite");
    agree();
    EXPECT_EQ(numberOf(newOne), 6) << told().toStdString();
    EXPECT_TRUE(mayGoOn());
}

TEST_F(CanopenReplace, TheOldOneMustNotBeThereAnyMore)
{
    switchSupply(oldSix, true);
    openAtNumber();
    giveNumber();
    EXPECT_TRUE(told().contains(QStringLiteral("Another device has the number 6"))) << told().toStdString();
    EXPECT_FALSE(mayGoOn());
    EXPECT_EQ(numberOf(newOne), std::nullopt);
}

TEST_F(CanopenReplace, OneThatHasItsNumberAlreadyIsReadOnly)
{
    openAtNumber();
    giveNumber();
    actions().replaceEncoder->trigger(); // anew
    advance(50);
    click("replaceNext");
    press(part<QRadioButton>("canReplaceIsThere"));
    EXPECT_FALSE(mayGoOn());
    click("nodeSetupRead");
    advance(2'000);
    EXPECT_TRUE(mayGoOn());
    EXPECT_FALSE(part<QPushButton>("nodeSetupWrite").isEnabled());
}

} // namespace
} // namespace codewheel
