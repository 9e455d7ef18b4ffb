// SPDX-License-Identifier: GPL-3.0-or-later
// The questions asked before the bus is stopped and the window is closed.
#include "kinds/interbus/words/k3_word.h"
#include "language.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "widgets/job/cancel_question.h"

#include <QLabel>
#include <QTest>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class LeavingTest : public test::WindowTest
{
protected:
    void startHandshake()
    {
        ASSERT_TRUE(bus().encoder(baumer)->start(
            WriteParameters{.values = {{Parameter::steps, 255}, {Parameter::revolutions, 1}}, .previous = {}},
            Pace::byHand));
        advance(20);
        bus().encoder(baumer)->proceed();
        advance(100);
        ASSERT_EQ(in(baumer), 0xC200'00FFu);
    }
};

TEST_F(LeavingTest, WithAllWordsZeroNothingIsAsked)
{
    actions().stop->trigger();
    advance(5);
    EXPECT_FALSE(bus().isRunning());
    window().close();
    advance(5);
    EXPECT_FALSE(window().isVisible());
}

TEST_F(LeavingTest, StopNamesTheDevicesWhoseOutIsNotZeroAndSetsThemToZero)
{
    send(fraba, 0x0000'0001);
    test::Question question = test::Question::answeredBy(QStringLiteral("Set to 00000000"));
    actions().stop->trigger();
    EXPECT_TRUE(question.text().contains(QStringLiteral("OUT 1.0 is 00000001")))
        << question.text().toStdString();
    EXPECT_FALSE(question.text().contains(QStringLiteral("2.0")));
    advance(50);
    EXPECT_EQ(out(fraba), 0u);
    EXPECT_FALSE(bus().isRunning());
}

TEST_F(LeavingTest, StopLeavesTheWordsIfTheUserSaysSo)
{
    send(fraba, 0x0000'0001);
    test::Question question = test::Question::answeredBy(QStringLiteral("Leave as they are"));
    actions().stop->trigger();
    advance(50);
    EXPECT_EQ(out(fraba), 1u);
    EXPECT_FALSE(bus().isRunning());
}

// 00000000 alone leaves it there.
TEST_F(LeavingTest, AWordThatBeganAParameterizationIsBroughtBackByRun)
{
    send(baumer, 0x0200'00FF);
    advance(100);
    ASSERT_EQ(in(baumer), 0xC200'00FFu);
    test::Question question = test::Question::answeredBy(QStringLiteral("Send run"));
    window().close();
    EXPECT_TRUE(question.text().contains(QStringLiteral("IN (C20000FF) confirms Steps with the data 255")))
        << question.text().toStdString();
    EXPECT_FALSE(question.text().contains(QStringLiteral("normal running")));
    advance(500);
    EXPECT_EQ(out(baumer), 0u);
    EXPECT_TRUE(k3::isOperation(in(baumer)));
    EXPECT_FALSE(window().isVisible());
}

TEST_F(LeavingTest, ACamWordIsNotTakenForAParameter)
{
    send(fraba, 0x2080'0001);
    advance(100);
    send(fraba, 0x4200'0064);
    advance(100);
    send(fraba, 0);
    ASSERT_EQ(in(fraba), 0xC200'0064u);
    test::Question question = test::Question::answeredBy(QStringLiteral("Leave as they are"));
    actions().stop->trigger();
    EXPECT_TRUE(
        question.text().contains(QStringLiteral("IN (C2000064) says: Acknowledged: Start of cam 1 = 100.")))
        << question.text().toStdString();
    EXPECT_FALSE(question.text().contains(QStringLiteral("with the data")));
}

TEST_F(LeavingTest, AnEncoderThatStaysInParameterizationIsSaidTo)
{
    send(baumer, 0x0200'00FF);
    advance(100);
    send(baumer, 0);
    ASSERT_EQ(in(baumer), 0xC200'00FFu);
    test::Question question = test::Question::answeredBy(QStringLiteral("Leave as they are"));
    actions().stop->trigger();
    EXPECT_TRUE(
        question.text().contains(QStringLiteral("OUT 2.0 is 00000000. The encoder is in parameterization")))
        << question.text().toStdString();
    advance(50);
    EXPECT_FALSE(bus().isRunning());
}

TEST_F(LeavingTest, CancelKeepsTheBusRunning)
{
    send(fraba, 0x0000'0001);
    test::Question question = test::Question::answeredBy(QStringLiteral("Cancel"));
    actions().stop->trigger();
    advance(50);
    EXPECT_EQ(out(fraba), 1u);
    EXPECT_TRUE(bus().isRunning());
}

// By then what it says is not true.
TEST_F(LeavingTest, AlarmStopTakesTheQuestionAwayAndTheUserStays)
{
    send(fraba, 0x0000'0001);
    test::Question question([this](QWidget &) {
        actions().alarmStop->trigger();
        advance(50);
    });
    window().close();
    EXPECT_TRUE(question.wasAsked());
    EXPECT_EQ(out(fraba), 0u);
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    EXPECT_TRUE(window().isVisible());
}

TEST_F(LeavingTest, TheQuestionHowToEndAHandshakeIsWholeAndReturnSpendsNothing)
{
    startHandshake();
    const int writes = bus().encoder(baumer)->eepromWrites();
    test::Question question([](QWidget &dialog) {
        const auto &text = *dialog.findChild<CancelQuestion *>()->findChild<QLabel *>();
        EXPECT_TRUE(QTest::qWaitFor([&] { return text.visibleRegion().boundingRect() == text.rect(); }));
        EXPECT_GE(text.height(), text.heightForWidth(text.width()));
        QTest::keyClick(&dialog, Qt::Key_Return);
    });
    window().close();
    advance(200);
    EXPECT_TRUE(question.wasAsked());
    EXPECT_TRUE(window().isVisible());
    EXPECT_TRUE(bus().encoder(baumer)->runningJob()) << "it goes on";
    EXPECT_EQ(bus().encoder(baumer)->eepromWrites(), writes);
}

TEST_F(LeavingTest, ClosingAsksHowToEndAHandshake)
{
    startHandshake();
    test::Question question = test::Question::answeredBy(QStringLiteral("Run"));
    window().close();
    EXPECT_TRUE(window().isVisible()) << "until the encoder is back in operation";
    advance(300);
    EXPECT_TRUE(k3::isOperation(in(baumer)));
    EXPECT_EQ(bus().encoder(baumer)->known(Parameter::steps)->value, 255);
    EXPECT_FALSE(window().isVisible());
}

// Its sentences are long, and say what the controller will see.
TEST_F(LeavingTest, NothingOfTheQuestionIsCutOff)
{
    Language language;
    language.use(QStringLiteral("de"));
    startHandshake();
    const test::Question question([](QWidget &dialog) {
        QTest::qWait(50);
        int labels = 0;
        for (const QLabel *label : dialog.findChildren<QLabel *>()) {
            EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
            ++labels;
        }
        EXPECT_GE(labels, 1);
        dialog.close();
    });
    window().close();
    advance(50);
    EXPECT_TRUE(bus().encoder(baumer)->runningJob());
}

TEST_F(LeavingTest, GoingOnWithTheHandshakeKeepsTheWindow)
{
    startHandshake();
    test::Question question = test::Question::answeredBy(QStringLiteral("Go on"));
    window().close();
    advance(100);
    EXPECT_TRUE(window().isVisible());
    EXPECT_TRUE(bus().encoder(baumer)->runningJob());
    EXPECT_EQ(out(baumer), 0x0200'00FFu) << "nothing was sent";
}

// The first word is in OUT, but the window has not heard of it yet.
TEST_F(LeavingTest, WhatWasTakenBeforeTheEncoderHeardOfItIsAskedAbout)
{
    EncoderSession &encoder = *bus().encoder(baumer);
    ASSERT_TRUE(encoder.start(WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}));
    bool closes = false;
    QObject::connect(&encoder, &EncoderSession::latestChanged, &window(), [&] {
        if (encoder.runningJob() && !std::exchange(closes, true))
            window().close();
    });
    test::Question question = test::Question::answeredBy(QStringLiteral("Run with"));
    for (int i = 0; i < 300 && !question.wasAsked(); ++i)
        advance(1);
    EXPECT_TRUE(question.wasAsked());
    advance(300);
    EXPECT_EQ(encoder.latest().state, EncoderState::operation);
}

TEST_F(LeavingTest, AJobThatOnlyReadsIsEndedWithoutAQuestion)
{
    ASSERT_TRUE(bus().encoder(fraba)->start(ReadParameters{{Parameter::steps}}, Pace::byHand));
    advance(20);
    bus().encoder(fraba)->proceed();
    advance(20);
    ASSERT_NE(out(fraba), 0u);
    window().close();
    advance(300);
    EXPECT_EQ(out(fraba), 0u);
    EXPECT_FALSE(window().isVisible());
}

// Gone without an answer, the question how to end it is no consent.
TEST_F(LeavingTest, AJobThatEndsUnderItsQuestionLeavesNothingByItself)
{
    startHandshake();
    std::optional<test::Question> second;
    const test::Question first([&](QWidget &) {
        EncoderSession &encoder = *bus().encoder(baumer);
        for (int step = 0; step < 20 && encoder.runningJob(); ++step) {
            encoder.proceed();
            advance(100);
        }
        EXPECT_FALSE(encoder.runningJob());
        second.emplace(test::Question::answeredBy(QStringLiteral("Cancel")));
    });
    actions().stop->trigger();
    advance(50);
    EXPECT_TRUE(second->text().contains(QStringLiteral("has ended before an answer")))
        << second->text().toStdString();
    EXPECT_TRUE(bus().isRunning());

    actions().stop->trigger();
    advance(50);
    EXPECT_FALSE(bus().isRunning()) << "nothing is at work any longer";
}

TEST_F(LeavingTest, WhatRunHasMadeValidIsNotCalledUnconfirmed)
{
    startHandshake();
    EncoderSession &encoder = *bus().encoder(baumer);
    for (int step = 0; step < 2; ++step) { // revolutions, run
        encoder.proceed();
        advance(100);
    }
    ASSERT_TRUE(k3::isOperation(in(baumer)));
    ASSERT_TRUE(encoder.runningJob());
    test::Question question = test::Question::answeredBy(QStringLiteral("Leave it with"));
    window().close();
    EXPECT_TRUE(question.text().contains(QStringLiteral("is valid"))) << question.text().toStdString();
    EXPECT_FALSE(question.text().contains(QStringLiteral("not confirmed")));
    EXPECT_FALSE(question.text().contains(QStringLiteral("parameterization")));
    advance(300);
    EXPECT_FALSE(window().isVisible());
    EXPECT_EQ(encoder.known(Parameter::steps)->value, 255);
}

} // namespace
} // namespace codewheel
