// SPDX-License-Identifier: GPL-3.0-or-later
// Cancel at each step with each choice, closing, and what stops a handshake.
#include "tests/widgets/wizard/wizard_test.h"

#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>

namespace codewheel {
namespace {

constexpr std::int64_t stepsBefore = 8192;

class WizardHandshake : public test::WizardTest
{
protected:
    // Goes to the handshake page: steps 255 and revolutions 2 at 1.0, all values read first.
    void begin(const char *steps = "255", const char *revolutions = "2")
    {
        wizard.setEncoder(&fraba());
        next();
        click("readAll");
        bus.advance(2000);
        next();
        next();
        type("steps", steps);
        type("revolutions", revolutions);
        next();
        next();
        EXPECT_EQ(wizard.page(), ParameterWizard::handshake);
        bus.advance(60);
    }
    void step(int count)
    {
        for (int i = 0; i < count; ++i) {
            click("nextStep");
            bus.advance(60);
        }
    }
    void settle() { bus.advance(3000); }
    std::int64_t readBack(Parameter parameter)
    {
        EXPECT_TRUE(fraba().start(ReadParameters{{parameter}}));
        bus.advance(300);
        return fraba().known(parameter)->value.number();
    }
};

TEST_F(WizardHandshake, NothingIsSentBeforeTheFirstStepIsAskedFor)
{
    begin();
    settle();
    EXPECT_EQ(out(), 0u);
    EXPECT_EQ(wizard.effect(), QStringLiteral("Nothing is sent before the first step."));
    EXPECT_TRUE(wizard.isBusy());
    EXPECT_FALSE(isEnabled("wizardNext"));
    EXPECT_FALSE(isEnabled("wizardBack"));
}

TEST_F(WizardHandshake, CancelBeforeAnythingWasTakenAsksNothing)
{
    begin();
    click("wizardCancel");
    bus.advance(60);
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_EQ(out(), 0u);
    EXPECT_EQ(states(), QStringList{QStringLiteral("done")});
    EXPECT_EQ(text("leftIn"), QStringLiteral("The encoder is in operation."));
    EXPECT_EQ(fraba().eepromWrites(), 0);
}

// IN shows the answer of the read-out then, and no position; run was sent long before.
TEST_F(WizardHandshake, WhileItIsReadBackWhatItHasTakenIsValidAlready)
{
    begin();
    step(5);
    ASSERT_EQ(fraba().latest().state, EncoderState::readOut);
    const auto question = test::Question::answeredBy(QStringLiteral("Leave it with what it has"));
    click("wizardCancel");
    settle();
    EXPECT_EQ(fraba().latest().state, EncoderState::operation);
}

// Steps: 1 steps, 2 revolutions, 3 run, 4 normal running, then the read-back.
struct CancelRow
{
    int stepsTaken;
    const char *button;
    EncoderState leftIn;
    std::int64_t steps; // afterwards; 0: cannot be read, the encoder is in parameterization
};

class WizardCancelTable : public WizardHandshake, public testing::WithParamInterface<CancelRow>
{};

TEST_P(WizardCancelTable, LeavesTheEncoderAsWasChosen)
{
    const CancelRow &row = GetParam();
    begin();
    step(row.stepsTaken);
    const auto question = test::Question::answeredBy(QString::fromLatin1(row.button));
    click("wizardCancel");
    settle();
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_EQ(out(), 0u);
    EXPECT_EQ(fraba().latest().state, row.leftIn);
    EXPECT_EQ(text("leftIn").contains(QStringLiteral("read back and match")), row.steps == stepsBefore)
        << text("leftIn").toStdString();
    if (row.steps != 0) {
        EXPECT_EQ(readBack(Parameter::steps), row.steps);
    }
}

INSTANTIATE_TEST_SUITE_P(EachStepEachChoice, WizardCancelTable,
                         testing::Values(CancelRow{1, "Restore", EncoderState::operation, stepsBefore},
                                         CancelRow{2, "Restore", EncoderState::operation, stepsBefore},
                                         CancelRow{3, "Restore", EncoderState::operation, stepsBefore},
                                         CancelRow{4, "Restore", EncoderState::operation, stepsBefore},
                                         CancelRow{1, "Run", EncoderState::operation, 255},
                                         CancelRow{2, "Run", EncoderState::operation, 255},
                                         CancelRow{1, "Leave", EncoderState::parameterization, 0},
                                         CancelRow{2, "Leave", EncoderState::parameterization, 0},
                                         CancelRow{3, "Leave", EncoderState::operation, 255},
                                         CancelRow{4, "Leave", EncoderState::operation, 255}));

TEST_F(WizardHandshake, AValueOnItsWayIsRestoredToo)
{
    begin();
    click("nextStep");
    bus.advance(8); // confirmed, but not settled yet
    ASSERT_EQ(fraba().latest().state, EncoderState::parameterization);
    const auto question = test::Question::answeredBy(QStringLiteral("Restore"));
    click("wizardCancel");
    settle();
    EXPECT_EQ(fraba().latest().state, EncoderState::operation);
    EXPECT_EQ(readBack(Parameter::steps), stepsBefore);
}

TEST_F(WizardHandshake, GoingOnAfterTheQuestionEndsVerified)
{
    begin();
    step(1);
    const auto question = test::Question::answeredBy(QStringLiteral("Go on"));
    click("wizardCancel");
    EXPECT_TRUE(wizard.isBusy());
    stepByHand();
    EXPECT_TRUE(text("leftIn").startsWith(QStringLiteral("Verified")));
}

TEST_F(WizardHandshake, LeftInParameterizationItCanBeBroughtBack)
{
    begin();
    step(1);
    {
        const auto question = test::Question::answeredBy(QStringLiteral("Leave"));
        click("wizardCancel");
        settle();
    }
    {
        const auto question = test::Question::answeredBy(QStringLiteral("Cancel"));
        click("recoverRestore");
        EXPECT_FALSE(fraba().runningJob());
    }
    const auto question = test::Question::answeredBy(QStringLiteral("Restore"));
    click("recoverRestore");
    EXPECT_TRUE(question.text().contains(QStringLiteral("Written before run is sent")))
        << question.text().toStdString();
    EXPECT_TRUE(question.text().contains(QStringLiteral("Steps = 8192"))) << question.text().toStdString();
    EXPECT_TRUE(question.text().contains(QStringLiteral("EEPROM"))) << question.text().toStdString();
    settle();
    EXPECT_EQ(fraba().latest().state, EncoderState::operation);
    EXPECT_EQ(readBack(Parameter::steps), stepsBefore);
}

TEST_F(WizardHandshake, SwitchedToByItselfItRunsToItsEnd)
{
    begin();
    step(1);
    click("runByItself");
    for (int i = 0; i < 100 && wizard.isBusy(); ++i)
        bus.advance(60);
    EXPECT_TRUE(text("leftIn").startsWith(QStringLiteral("Verified")));
    EXPECT_EQ(readBack(Parameter::steps), 255);
}

TEST_F(WizardHandshake, ClosingLeavesItToGoOn)
{
    begin();
    EXPECT_TRUE(wizard.lostByClosing().contains(QStringLiteral("may give no position")))
        << wizard.lostByClosing().toStdString();
    wizard.leave();
    EXPECT_TRUE(wizard.isBusy());
    EXPECT_EQ(wizard.page(), ParameterWizard::handshake);
}

// Baumer manual, example 2, with a value within the present range: run fails with error 1.
TEST_F(WizardHandshake, AnErrorStopsItAndRestoreBringsTheEncoderBack)
{
    begin("9000", "1"); // finer than the disc
    stepByHand();
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_TRUE(sentence("handshakeProblem").startsWith(QStringLiteral("Error 1")))
        << sentence("handshakeProblem").toStdString();
    EXPECT_EQ(fraba().latest().state, EncoderState::error);
    EXPECT_EQ(out(), 0u);
    const auto question = test::Question::answeredBy(QStringLiteral("Restore"));
    click("recoverRestore");
    settle();
    EXPECT_EQ(fraba().latest().state, EncoderState::operation);
    EXPECT_EQ(readBack(Parameter::steps), stepsBefore);
    EXPECT_EQ(sentence("handshakeProblem"), QString());
    next();
    const QString report = find<QPlainTextEdit>("account")->toPlainText();
    EXPECT_TRUE(report.contains(QStringLiteral("Error 1")));
    EXPECT_TRUE(report.contains(QStringLiteral("Brought back")));
}

TEST_F(WizardHandshake, AnEncoderSwitchedOffTimesOut)
{
    begin();
    controls->setFault(TrainingFault::powerOff, NodeId("1.0"), 1);
    click("nextStep");
    settle();
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_TRUE(sentence("handshakeProblem").contains(QStringLiteral("did not answer")))
        << sentence("handshakeProblem").toStdString();
    EXPECT_EQ(out(), 0u);
}

TEST_F(WizardHandshake, AlarmStopEndsItAndClosesTheQuestion)
{
    begin();
    step(1);
    QTimer::singleShot(0, qApp, [this] {
        ASSERT_NE(QApplication::activeModalWidget(), nullptr);
        bus.alarmStop();
        bus.advance(10);
    });
    click("wizardCancel");
    settle();
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_TRUE(find<QAbstractButton>("recoverRun")->isVisible());
}

// By somebody else, or while the link was lost.
TEST_F(WizardHandshake, WhatTheEncoderIsInByNowIsSaidOnceItIsSeen)
{
    begin();
    step(1);
    QTimer::singleShot(0, qApp, [this] {
        bus.alarmStop();
        bus.advance(10);
    });
    click("wizardCancel");
    settle();
    ASSERT_TRUE(find<QAbstractButton>("recoverRun")->isVisible());
    EXPECT_TRUE(text("leftIn").contains(QStringLiteral("parameterization")));
    bus.setRunning(true);
    bus.advance(50);
    ASSERT_TRUE(fraba().start(EndParameterization{}));
    bus.advance(1'000);
    ASSERT_EQ(fraba().latest().state, EncoderState::operation);
    EXPECT_FALSE(find<QAbstractButton>("recoverRun")->isVisible());
    EXPECT_TRUE(text("leftIn").contains(QStringLiteral("The encoder is in operation.")))
        << text("leftIn").toStdString();
}

TEST_F(WizardHandshake, TheReportFollowsTheEncoderAndTellsHowItWas)
{
    begin();
    step(2);
    EXPECT_EQ(wizard.effect(), QStringLiteral("Writes to the encoder."));
    bus.alarmStop();
    bus.advance(10);
    next();
    ASSERT_EQ(wizard.page(), ParameterWizard::report);
    EXPECT_TRUE(text("reportLeftIn").contains(QStringLiteral("parameterization")));
    bus.setRunning(true);
    bus.advance(50);
    controls->powerCycle("1.0"_ring.node);
    bus.advance(5'000);
    ASSERT_EQ(fraba().latest().state, EncoderState::operation);
    EXPECT_EQ(text("reportLeftIn"), QStringLiteral("The encoder is in operation."));
    const QString report = find<QPlainTextEdit>("account")->toPlainText();
    EXPECT_TRUE(report.contains(QStringLiteral("State at the end of the handshake"))) << report.toStdString();
    EXPECT_TRUE(report.contains(QStringLiteral("The encoder is in parameterization")))
        << report.toStdString();
}

TEST_F(WizardHandshake, RunIsNotSentAfterwardsWithoutAQuestion)
{
    begin();
    step(1);
    QTimer::singleShot(0, qApp, [this] {
        bus.alarmStop();
        bus.advance(10);
    });
    click("wizardCancel");
    settle();
    bus.setRunning(true);
    bus.advance(50);
    {
        const test::Question question([](QWidget &box) { QTest::keyClick(&box, Qt::Key_Return); });
        click("recoverRun");
        EXPECT_TRUE(question.text().contains(QStringLiteral("it can jump"))) << question.text().toStdString();
    }
    settle();
    EXPECT_EQ(fraba().latest().state, EncoderState::parameterization) << "the default is Cancel";
    const auto question = test::Question::answeredBy(QStringLiteral("Send run"));
    click("recoverRun");
    settle();
    EXPECT_EQ(fraba().latest().state, EncoderState::operation);
}

TEST_F(WizardHandshake, InWatchItSaysSoAndMayBeTriedAgain)
{
    bus.setOperate(false);
    bus.advance(5);
    wizard.setEncoder(&baumer());
    next();
    next();
    next();
    type("steps", "4096");
    next();
    next();
    EXPECT_TRUE(sentence("handshakeProblem").contains(QStringLiteral("Operate")));
    bus.setOperate(true);
    bus.advance(5);
    QTest::mouseClick(find<InlineMessage>("handshakeProblem")->findChild<QPushButton *>(), Qt::LeftButton);
    EXPECT_TRUE(wizard.isBusy());
}

TEST_F(WizardHandshake, AfterRunItSaysWhatIsValidAndWhereThePositionWent)
{
    fraba().tell(Parameter::startUpMode, 1);
    begin();
    const auto before = *fraba().latest().position;
    step(1);
    const auto question = test::Question::answeredBy(QStringLiteral("Run"));
    click("wizardCancel");
    settle();
    EXPECT_EQ(text("leftIn"), QStringLiteral("Valid now: Steps = 255. The position went from %1 to %2. The "
                                             "encoder is in operation.")
                                  .arg(QLocale().toString(qlonglong{before}),
                                       QLocale().toString(qlonglong{*fraba().latest().position})));
}

// In parameterization nobody sees whether it does.
TEST_F(WizardHandshake, WhatThePositionWillReadIsSaidOfAShaftThatStands)
{
    fraba().tell(Parameter::startUpMode, 1);
    begin();
    controls->turnBy(NodeId("1.0"), 1'000); // by hand minutes pass before the first step
    bus.advance(60);
    const auto shown = *fraba().latest().position;
    step(1);
    QString asked;
    int scrolled = -1;
    const test::Question question([&](QWidget &dialog) {
        QTest::qWait(50);
        for (const auto *label : dialog.findChildren<QLabel *>())
            asked += label->text();
        scrolled = 0;
        for (const auto *area : dialog.findChildren<QScrollArea *>())
            scrolled += area->verticalScrollBar()->maximum();
        QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    click("wizardCancel");
    EXPECT_TRUE(asked.contains(QStringLiteral("If the shaft has not moved since"))) << asked.toStdString();
    EXPECT_EQ(scrolled, 0);
    const auto then =
        QRegularExpression(QStringLiteral("it will then read (?:about )?([0-9,]+)\\.")).match(asked);
    ASSERT_TRUE(then.hasMatch()) << asked.toStdString();
    EXPECT_NEAR(QLocale().toDouble(then.captured(1)), static_cast<double>(shown) * 255 / 8192, 2);
}

// The values of before are read in the same job.
TEST_F(WizardHandshake, WhatItReadsBeforeItWritesTellsThePositionToo)
{
    wizard.setEncoder(&fraba());
    next();
    click("isPositionMode");
    bus.advance(5);
    next();
    next();
    for (const auto &value : ParameterValues{{Parameter::steps, 255},
                                             {Parameter::revolutions, 1},
                                             {Parameter::direction, 3},
                                             {Parameter::zeroOffset, 7}})
        wanted.set("1.0"_ring, value.parameter, value.value);
    next();
    next();
    bus.advance(60);
    for (int pressed = 0; pressed < 40 && fraba().latest().state != EncoderState::parameterization; ++pressed)
        step(1);
    ASSERT_TRUE(wizard.isBusy());
    const auto question = test::Question::answeredBy(QStringLiteral("Restore"));
    click("wizardCancel");
    EXPECT_TRUE(question.text().contains(QStringLiteral("it will then read")))
        << question.text().toStdString();
    settle();
}

// A Baumer encoder needs run before it is restored, so its question is the longest.
TEST_F(WizardHandshake, TheLongestQuestionIsSeenAsAWhole)
{
    for (const auto &[parameter, value] : {std::pair{Parameter::coding, 3},
                                           {Parameter::steps, 8'192},
                                           {Parameter::revolutions, 1},
                                           {Parameter::measuringRange, 4'096}})
        baumer().tell(parameter, value);
    wizard.setEncoder(&baumer());
    next();
    next();
    next();
    type("steps", "4096");
    next();
    next();
    bus.advance(60);
    step(1);
    const QFont usual = QApplication::font();
    for (const double size : {9.0, 11.0, 13.0, 13.5, 14.0}) {
        SCOPED_TRACE(size);
        QFont font = usual;
        font.setPointSizeF(size);
        QApplication::setFont(font);
        const test::Question question([](QWidget &dialog) {
            QTest::qWait(50);
            for (const auto *area : dialog.findChildren<QScrollArea *>())
                EXPECT_EQ(area->verticalScrollBar()->maximum(), 0);
            for (const auto *label : dialog.findChildren<QLabel *>())
                EXPECT_GE(label->height(), label->heightForWidth(label->width()));
            QTest::keyClick(&dialog, Qt::Key_Escape);
        });
        click("wizardCancel");
        EXPECT_TRUE(question.text().contains(QStringLiteral("Before that, run makes valid")));
    }
    QApplication::setFont(usual);
}

// Written all the same because a preset acts once, so there is nothing to give back.
TEST_F(WizardHandshake, WhatWasWrittenAsItHadBeenIsReadBackTooWhenTheRestIsRestored)
{
    wizard.setEncoder(&fraba());
    next();
    click("readAll");
    bus.advance(2000);
    click("isPositionMode");
    bus.advance(5);
    next();
    next();
    type("steps", "255");
    type("preset", "0");
    leaveField();
    next();
    next();
    bus.advance(60);
    step(4); // steps, preset, run, normal running
    ASSERT_EQ(fraba().known(Parameter::preset)->evidence, Evidence::echoed);
    const auto question = test::Question::answeredBy(QStringLiteral("Restore"));
    click("wizardCancel");
    settle();
    EXPECT_TRUE(text("leftIn").contains(QStringLiteral("read back and match")))
        << text("leftIn").toStdString();
    EXPECT_EQ(fraba().known(Parameter::preset)->evidence, Evidence::read);
    EXPECT_EQ(fraba().known(Parameter::steps)->evidence, Evidence::read);
}

TEST_F(WizardHandshake, TheTitleSaysThatItWritesOnlyAsLongAsItDoes)
{
    const QSignalSpy headChanged(&wizard, &Page::headChanged);
    begin();
    step(2);
    ASSERT_EQ(wizard.effect(), QStringLiteral("Writes to the encoder."));
    const auto before = headChanged.count();
    bus.alarmStop();
    bus.advance(10);
    ASSERT_FALSE(wizard.isBusy());
    EXPECT_EQ(wizard.effect(), QStringLiteral("Nothing is being sent."));
    EXPECT_GT(headChanged.count(), before);
}

TEST_F(WizardHandshake, TheQuestionBeforeRunKnowsThePositionThatTheOneOfCancelKnew)
{
    fraba().tell(Parameter::startUpMode, 1);
    begin();
    step(1);
    QString foretold;
    {
        const auto question = test::Question::answeredBy(QStringLiteral("Leave"));
        click("wizardCancel");
        settle();
        const QRegularExpression position(QStringLiteral("it will then read [^\n]*"));
        foretold = position.match(question.text()).captured(0).section(u'\n', 0, 0).trimmed();
    }
    ASSERT_FALSE(foretold.isEmpty());
    const auto question = test::Question::answeredBy(QStringLiteral("Cancel"));
    click("recoverRun");
    EXPECT_TRUE(question.text().contains(foretold)) << question.text().toStdString();
    EXPECT_FALSE(question.text().contains(QStringLiteral("is not known"))) << question.text().toStdString();
}

TEST_F(WizardHandshake, TheQuestionBeforeRunKnowsNoPositionIfTheEncoderHasTakenMoreSince)
{
    fraba().tell(Parameter::startUpMode, 1);
    begin();
    step(1);
    {
        const auto question = test::Question::answeredBy(QStringLiteral("Leave"));
        click("wizardCancel");
        settle();
    }
    ASSERT_TRUE(fraba().start(SendWords{.words = {0x0400'0004, 0x0000'0000}}));
    bus.advance(200);
    ASSERT_EQ(fraba().latest().state, EncoderState::parameterization);
    const auto question = test::Question::answeredBy(QStringLiteral("Cancel"));
    click("recoverRun");
    EXPECT_TRUE(question.text().contains(QStringLiteral("Which position it will read is not known.")))
        << question.text().toStdString();
}

} // namespace
} // namespace codewheel
