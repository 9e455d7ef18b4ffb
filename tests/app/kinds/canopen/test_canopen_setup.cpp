// SPDX-License-Identifier: GPL-3.0-or-later
// A device on a CAN bus gets its number and rate in the window.
#include "app/window/window_actions.h"
#include "tests/app/kinds/canopen/canopen_window_test.h"
#include "tests/app/question.h"
#include "vocabulary/refusal_text.h"
#include "widgets/kinds/canopen/setup/node_setup_page.h"
#include "widgets/kinds/canopen/setup/node_setup_view.h"
#include "widgets/kinds/canopen/setup/setup_steps.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::nodeFive;
using test::nodeSeven;
using test::nodeSix;

constexpr Place nodeNine{firstCanBus, NodeId("can:9")};
constexpr std::size_t encoderSix = 1;
constexpr std::size_t encoderWithoutNumber = 3;

class CanopenSetup : public test::CanopenWindowTest
{
protected:
    CanopenSetup()
    {
        canActions().training->trigger();
        advance(1'500);
    }

    template <typename Widget>
    Widget &widget(const char *name = nullptr)
    {
        return *window().findChild<Widget *>(QString::fromLatin1(name));
    }
    void click(const char *name)
    {
        auto &button = widget<QPushButton>(name);
        EXPECT_TRUE(button.isEnabled()) << name;
        QTest::mouseClick(&button, Qt::LeftButton);
        advance(50);
    }
    bool isPossible(const char *name) { return widget<QPushButton>(name).isEnabled(); }
    // Whoever the page is about is read, and is to get this number.
    void wantNumber(int number)
    {
        click("nodeSetupRead");
        advance(2'000);
        widget<QSpinBox>("nodeSetupNumber").setValue(number);
        advance(50);
    }
    void openFor(Place place)
    {
        tree().choose(place);
        advance(50);
        canActions().setup->trigger();
        advance(50);
    }
    // What was begun, at most.
    void untilDone(int most)
    {
        for (int passed = 0; passed < most && view().isBusy(); passed += 100)
            advance(100);
        advance(200);
    }
    // The question is answered.
    void agree()
    {
        QTest::qWait(400); // a question takes no click at once
        for (auto *button : widget<InlineMessage>("nodeSetupMessage").findChildren<QPushButton *>())
            if (plainLabel(button->text()) == QStringLiteral("Send"))
                QTest::mouseClick(button, Qt::LeftButton);
        advance(50);
    }
    void write(int number)
    {
        wantNumber(number);
        click("nodeSetupWrite");
        agree();
        untilDone(20'000);
    }
    QString told() { return widget<InlineMessage>("nodeSetupMessage").sentence(); }
    QString device() { return widget<QLabel>("nodeSetupDevice").text(); }
    QStringList steps() { return widget<SetupSteps>().shown(); }
    NodeSetupView &view() { return widget<NodeSetupView>(); }
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
    int writesOf(std::size_t which)
    {
        return static_cast<int>(canBus().training()->withEncoder(
            which, [](canopen::SimulatedNode &node) { return node.eepromWrites(); }));
    }
};

TEST_F(CanopenSetup, OpensForTheChosenEncoderAndSendsNothing)
{
    tree().choose(nodeSix);
    actions().watch->trigger();
    advance(200);
    const auto sent = session().latest().figures.sent;
    openFor(nodeSix);
    advance(1'000);
    EXPECT_EQ(page(), &widget<NodeSetupPage>());
    EXPECT_TRUE(device().contains(QStringLiteral("6 (06h)")));
    EXPECT_FALSE(isPossible("nodeSetupRead"));
    EXPECT_FALSE(isPossible("nodeSetupWrite"));
    EXPECT_EQ(session().latest().figures.sent, sent);
}

TEST_F(CanopenSetup, ShowsWhoWasReadAndWhatWillHappen)
{
    openFor(nodeSix);
    wantNumber(6);
    EXPECT_TRUE(device().contains(QStringLiteral("10Dh"))) << device().toStdString();
    EXPECT_FALSE(isPossible("nodeSetupWrite")) << "it has this number";
    widget<QSpinBox>("nodeSetupNumber").setValue(9);
    EXPECT_TRUE(isPossible("nodeSetupWrite"));
    EXPECT_TRUE(widget<QLabel>("nodeSetupConsequences").text().contains(QStringLiteral("EEPROM")));
    widget<QComboBox>("nodeSetupRate").setCurrentIndex(4);
    EXPECT_TRUE(widget<QLabel>("nodeSetupConsequences").text().contains(QStringLiteral("250 kBit/s")));
}

TEST_F(CanopenSetup, NothingIsWrittenBeforeTheQuestionIsAnswered)
{
    openFor(nodeSix);
    wantNumber(9);
    click("nodeSetupWrite");
    advance(5'000);
    EXPECT_TRUE(told().contains(QStringLiteral("Shall it be written?")));
    EXPECT_EQ(numberOf(encoderSix), 6);
    EXPECT_EQ(writesOf(encoderSix), 0);
    widget<QSpinBox>("nodeSetupNumber").setValue(10); // which is not what was asked about
    EXPECT_EQ(told(), QString());
}

// By the keyboard what sends nothing comes first, and nothing is to be looked for.
TEST_F(CanopenSetup, TheQuestionIsInSightAndReturnTwiceSendsNothing)
{
    resizeTo({1024, 640});
    openFor(nodeSix);
    wantNumber(9);
    widget<QComboBox>("nodeSetupRate").setCurrentIndex(4); // which has more to say
    auto &write = widget<QPushButton>("nodeSetupWrite");
    write.setFocus();
    QTest::keyClick(&write, Qt::Key_Space);
    advance(50);
    QTest::qWait(50);
    auto &message = widget<InlineMessage>("nodeSetupMessage");
    const QWidget *room = view().parentWidget();
    EXPECT_TRUE(room->rect().contains(QRect(message.mapTo(room, QPoint()), message.size())))
        << message.height();
    ASSERT_TRUE(message.isAncestorOf(QApplication::focusWidget()));
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Space})
        QTest::keyClick(QApplication::focusWidget(), key);
    advance(5'000);
    EXPECT_EQ(writesOf(encoderSix), 0);
    EXPECT_TRUE(write.hasFocus());
}

TEST_F(CanopenSetup, TheFocusStaysOnThePageWhileANumberIsGiven)
{
    openFor(nodeSix);
    write(9);
    EXPECT_TRUE(view().isToBeProven());
    EXPECT_TRUE(widget<QPushButton>("nodeSetupCheck").hasFocus())
        << QApplication::focusWidget()->objectName().toStdString();
}

TEST_F(CanopenSetup, TheEncoderHasItsNewNumberInTheTreeAndItIsProvenOnceItsSupplyWasOff)
{
    openFor(nodeSix);
    write(9);
    EXPECT_EQ(numberOf(encoderSix), 9);
    EXPECT_EQ(writesOf(encoderSix), 1);
    EXPECT_TRUE(tree().has(nodeNine));
    EXPECT_FALSE(tree().has(nodeSix));
    ASSERT_NE(session().encoder(nodeNine), nullptr);
    EXPECT_EQ(session().encoder(nodeNine)->device().key, QStringLiteral("canopen-406-multi-turn"));
    EXPECT_EQ(session().encoder(nodeNine)->eepromWrites(), 1);
    EXPECT_TRUE(view().isToBeProven());
    EXPECT_TRUE(told().contains(QStringLiteral("sure only once"))) << told().toStdString();
    EXPECT_TRUE(steps().contains(QStringLiteral("done: It is there as node 9 (09h)")))
        << steps().join(u'\n').toStdString();
    click("nodeSetupCheck"); // nobody has switched anything
    untilDone(8'000);
    EXPECT_FALSE(view().isProven());
    EXPECT_TRUE(told().contains(QStringLiteral("not switched off"))) << told().toStdString();
    switchSupply(encoderSix, false);
    switchSupply(encoderSix, true);
    click("nodeSetupCheck");
    untilDone(8'000);
    EXPECT_TRUE(view().isProven()) << told().toStdString();
    EXPECT_TRUE(told().startsWith(QStringLiteral("Proven")));
    EXPECT_TRUE(
        steps().contains(QStringLiteral("done: It is there as node 9 (09h) after its supply was off")));
    for (const QString &step : steps())
        EXPECT_TRUE(step.startsWith(QStringLiteral("done"))) << step.toStdString();
}

TEST_F(CanopenSetup, ANumberOfAnotherEncoderIsNotAskedAbout)
{
    openFor(nodeSix);
    wantNumber(7);
    click("nodeSetupWrite");
    EXPECT_TRUE(told().contains(QStringLiteral("already"))) << told().toStdString();
    advance(1'000);
    EXPECT_EQ(numberOf(encoderSix), 6);
}

TEST_F(CanopenSetup, ANumberAtWhichSomebodyAnswersIsNotGiven)
{
    (void)session().remove(nodeFive);
    openFor(nodeSix);
    write(5);
    EXPECT_TRUE(told().contains(QStringLiteral("Another device has the number"))) << told().toStdString();
    EXPECT_TRUE(told().contains(QStringLiteral("Nothing was changed.")));
    EXPECT_EQ(numberOf(encoderSix), 6);
    EXPECT_EQ(writesOf(encoderSix), 0);
}

TEST_F(CanopenSetup, ADeviceWithoutANumberIsFoundAndGetsOne)
{
    canActions().unnumbered->trigger();
    advance(50);
    click("nodeSetupFind");
    EXPECT_TRUE(device().contains(QStringLiteral("some seconds")));
    EXPECT_TRUE(isPossible("nodeSetupCancel"));
    untilDone(30'000);
    EXPECT_TRUE(device().contains(QStringLiteral("without a number"))) << device().toStdString();
    EXPECT_TRUE(device().contains(QStringLiteral("130015h"))) << device().toStdString();
    widget<QSpinBox>("nodeSetupNumber").setValue(9);
    click("nodeSetupWrite");
    agree();
    untilDone(20'000);
    EXPECT_EQ(numberOf(encoderWithoutNumber), 9);
    EXPECT_TRUE(view().isFound()) << told().toStdString();
    switchSupply(encoderWithoutNumber, false);
    switchSupply(encoderWithoutNumber, true);
    click("nodeSetupCheck");
    untilDone(8'000);
    EXPECT_TRUE(view().isProven()) << told().toStdString();
}

TEST_F(CanopenSetup, WhereNobodyIsWithoutANumberThatIsSaid)
{
    switchSupply(encoderWithoutNumber, false);
    canActions().unnumbered->trigger();
    click("nodeSetupFind");
    advance(5'000);
    EXPECT_TRUE(told().contains(QStringLiteral("No device without a number"))) << told().toStdString();
}

TEST_F(CanopenSetup, OneThatIsGoneAfterwardsIsNotCalledThere)
{
    openFor(nodeSix);
    wantNumber(9);
    click("nodeSetupWrite");
    agree();
    for (int i = 0; i < 400 && writesOf(encoderSix) == 0; ++i)
        advance(5);
    switchSupply(encoderSix, false);
    untilDone(20'000);
    EXPECT_FALSE(view().isFound());
    EXPECT_TRUE(told().contains(QStringLiteral("Nobody answers as node 9"))) << told().toStdString();
    EXPECT_TRUE(tree().has(nodeSix));
    switchSupply(encoderSix, true);
    click("nodeSetupCheck"); // it is looked for again, which proves nothing yet
    untilDone(10'000);
    EXPECT_TRUE(view().isFound());
    EXPECT_FALSE(view().isProven());
    EXPECT_TRUE(tree().has(nodeNine));
}

TEST_F(CanopenSetup, ABusThatIsLeftMeanwhileLeavesATrueSentence)
{
    openFor(nodeSix);
    wantNumber(9);
    click("nodeSetupWrite");
    agree();
    EXPECT_TRUE(view().isBusy());
    EXPECT_FALSE(window().mayGo()) << "it is being written";
    canBus().close();
    advance(100);
    EXPECT_FALSE(view().isBusy());
    EXPECT_TRUE(window().mayGo());
    EXPECT_TRUE(told().contains(QStringLiteral("supply off and on")) ||
                told().contains(QStringLiteral("Nothing was changed")))
        << told().toStdString();
    EXPECT_FALSE(isPossible("nodeSetupWrite"));
}

TEST_F(CanopenSetup, WhatIsWrittenIsLostByClosingOnlyWithoutItsProof)
{
    openFor(nodeSix);
    EXPECT_EQ(widget<NodeSetupPage>().lostByClosing(), QString());
    write(9);
    EXPECT_TRUE(widget<NodeSetupPage>().lostByClosing().contains(QStringLiteral("has not been checked")));
}

TEST_F(CanopenSetup, ARateIsStoredAndCheckedAtThatRateOnly)
{
    openFor(nodeSeven);
    click("nodeSetupRead");
    advance(2'000);
    QString said;
    QObject::connect(&view(), &NodeSetupView::messaged, &view(),
                     [&](const Message &message) { said = messageText(message); });
    widget<QComboBox>("nodeSetupRate").setCurrentIndex(4);
    click("nodeSetupWrite");
    agree();
    untilDone(10'000);
    EXPECT_TRUE(told().contains(QStringLiteral("250 kBit/s"))) << told().toStdString();
    EXPECT_TRUE(said.contains(QStringLiteral("Node 7 says that it has stored the rate 250 kBit/s")))
        << said.toStdString();
    EXPECT_TRUE(view().isToBeProven());
    click("nodeSetupCheck");
    advance(5'000);
    EXPECT_FALSE(view().isProven());
    EXPECT_TRUE(told().contains(QStringLiteral("Connect it at 250 kBit/s first"))) << told().toStdString();
}

class CanopenSetupIsLeft : public CanopenSetup
{
protected:
    // The first requests of writing number 9 to node 6 are out.
    CanopenSetupIsLeft()
    {
        openFor(nodeSix);
        wantNumber(9);
        click("nodeSetupWrite");
        agree();
        EXPECT_TRUE(view().isBusy());
    }
};

TEST_F(CanopenSetupIsLeft, TheWindowStaysUnlessTheUserBreaksTheWritingOff)
{
    test::Question question = test::Question::answeredBy(QStringLiteral("Stay"));
    window().close();
    EXPECT_TRUE(question.text().contains(QStringLiteral("Node 6 (06h)"))) << question.text().toStdString();
    EXPECT_TRUE(question.text().contains(QStringLiteral("old number or the new one")));
    EXPECT_TRUE(window().isVisible());
    untilDone(20'000);
    EXPECT_EQ(numberOf(encoderSix), 9) << "it has gone on";
}

TEST_F(CanopenSetupIsLeft, BrokenOffInTimeTheDeviceKeepsItsNumberAndTheWindowCloses)
{
    test::Question question = test::Question::answeredBy(QStringLiteral("Break it off"));
    window().close();
    EXPECT_TRUE(question.wasAsked());
    untilDone(10'000);
    EXPECT_FALSE(window().isVisible());
    EXPECT_EQ(writesOf(encoderSix), 0);
}

TEST_F(CanopenSetupIsLeft, WhatIsInDoubtAfterwardsIsSeenBeforeTheBusIsLeft)
{
    const QString taken = QStringLiteral("done: It takes the number 9 (09h)");
    for (int i = 0; i < 2'000 && !steps().contains(taken); ++i)
        advance(1);
    ASSERT_TRUE(view().isBusy() && steps().contains(taken)) << steps().join(u'\n').toStdString();
    canActions().settings->trigger();
    advance(1);
    test::Question question = test::Question::answeredBy(QStringLiteral("Break it off"));
    canActions().disconnectBus->trigger();
    EXPECT_TRUE(question.wasAsked());
    untilDone(10'000);
    EXPECT_NE(canBus().session(), nullptr) << "the user sees it first";
    EXPECT_EQ(page(), &widget<NodeSetupPage>());
    EXPECT_FALSE(told().isEmpty());
    canActions().disconnectBus->trigger();
    advance(200);
    EXPECT_EQ(canBus().session(), nullptr) << "and is not asked once more";
}

TEST_F(CanopenSetup, WhatOnlyReadsIsNotAskedAbout)
{
    openFor(nodeSix);
    click("nodeSetupRead");
    canActions().disconnectBus->trigger();
    advance(200);
    EXPECT_EQ(canBus().session(), nullptr);
}

} // namespace
} // namespace codewheel
