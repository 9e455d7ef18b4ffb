// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/model_tester.h"
#include "tests/support/old_file.h"
#include "tests/support/places.h"
#include "tests/widgets/wizard/wizard_test.h"
#include "widgets/dial/code_disc.h"
#include "widgets/dial/now_and_then.h"
#include "widgets/job/account_view.h"
#include "widgets/job/step_table.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QRegularExpression>
#include <QTemporaryDir>

namespace codewheel {
namespace {

constexpr QSize smallestWizard(682, 476); // in a window of 1024 x 640

class WizardPages : public test::WizardTest
{
protected:
    QString verdict() const { return find<QWidget>("verdict")->accessibleName(); }
    const DialState &pictureOfReview() const
    {
        const auto discs = wizard.findChild<NowAndThen *>()->findChildren<CodeDisc *>();
        return discs.front()->state();
    }
    void beginHandshakeOfBaumer()
    {
        wizard.setEncoder(&baumer());
        next();
        next();
        next();
        type("steps", "4096");
        type("revolutions", "1");
        next();
        next();
    }
};

TEST_F(WizardPages, UnknownIsShownAsUnknownAndToldIsToldApart)
{
    wizard.setEncoder(&baumer());
    next();
    auto *table = find<QTableView>("known");
    test::ModelTester tester(*table->model());
    EXPECT_EQ(table->model()->index(0, 2).data(), QStringLiteral("unknown"));
    baumer().tell(Parameter::steps, 8192);
    EXPECT_EQ(table->model()->index(0, 2).data(), QStringLiteral("by hand"));
    EXPECT_FALSE(find<QAbstractButton>("readAll")->isVisible()); // no read-out
}

TEST_F(WizardPages, WhatIsKnownIsShownOfAnEncoderOfAnotherKindToo)
{
    const auto parameters = [this] { return find<QTableView>("known")->model()->rowCount(); };
    wizard.setEncoder(&fraba());
    next();
    const int ofFraba = parameters();
    find<QTableView>("known")->selectRow(2);
    click("wizardBack");
    wizard.setEncoder(&baumer());
    next();
    EXPECT_NE(parameters(), ofFraba);
    click("wizardBack");
    wizard.setEncoder(&fraba());
    next();
    EXPECT_EQ(parameters(), ofFraba);
    EXPECT_TRUE(find<QTableView>("known")->currentIndex().isValid());
}

TEST_F(WizardPages, AnEncoderThatOnlyTellsItsPositionCannotBeSetUp)
{
    wizard.setEncoder(bus.encoder("3.0"_ring));
    EXPECT_FALSE(isEnabled("wizardNext"));
    QStringList sentences;
    for (const auto *message : wizard.findChildren<InlineMessage *>())
        if (message->isVisible())
            sentences += message->sentence();
    EXPECT_EQ(sentences,
              QStringList{QStringLiteral("The FRABA OCD-IB K1 cannot be parameterized over the bus.")});
    wizard.setEncoder(&fraba());
    EXPECT_TRUE(isEnabled("wizardNext"));
}

TEST_F(WizardPages, DirectionIsCheckedByTurningTheShaft)
{
    wizard.setEncoder(&fraba());
    next();
    click("readAll");
    bus.advance(2000);
    click("isPositionMode");
    bus.advance(5);
    next();
    EXPECT_EQ(verdict(), QStringLiteral("Does not move yet"));
    controls->turnBy(NodeId("1.0"), 100);
    bus.advance(5);
    EXPECT_EQ(verdict(), QStringLiteral("Counts up"));
    controls->turnBy(NodeId("1.0"), -300);
    bus.advance(5);
    controls->turnBy(NodeId("1.0"), -300);
    bus.advance(5);
    EXPECT_EQ(verdict(), QStringLiteral("Counts down"));
    click("otherWay");
    EXPECT_EQ(wanted.value("1.0"_ring, Parameter::direction), 4);
}

TEST_F(WizardPages, WhatIsOldTellsNoDirection)
{
    wizard.setEncoder(&fraba());
    fraba().tell(Parameter::startUpMode, 1);
    bus.advance(5);
    next();
    next();
    controls->turnBy(NodeId("1.0"), 100);
    bus.advance(5);
    EXPECT_EQ(verdict(), QStringLiteral("Counts up"));
    bus.setRunning(false);
    bus.advance(5);
    EXPECT_EQ(verdict(), QStringLiteral("Not up to date"));
    EXPECT_TRUE(
        sentence("directionProblem").startsWith(QStringLiteral("The bus does not run. Shown is how it was")));
    EXPECT_EQ(find<QLabel>("directionPosition")->foregroundRole(), QPalette::PlaceholderText);
    controls->turnBy(NodeId("1.0"), -3000);
    bus.setRunning(true);
    bus.advance(20);
    EXPECT_EQ(verdict(), QStringLiteral("Does not move yet")) << "nobody has seen that move";
    EXPECT_EQ(find<QLabel>("directionPosition")->foregroundRole(), QPalette::WindowText);
}

TEST_F(WizardPages, TheRawWordIsWatchedWhereTheCodingIsNotKnown)
{
    wizard.setEncoder(&baumer());
    next();
    next();
    EXPECT_TRUE(sentence("directionProblem").contains(QStringLiteral("not known")));
    bus.advance(100); // turns clockwise
    EXPECT_EQ(verdict(), QStringLiteral("Counts up"));
}

TEST_F(WizardPages, BadInputIsNamedAtItsPlaceAndHoldsThePage)
{
    wizard.setEncoder(&baumer());
    next();
    next();
    next();
    for (const char *bad : {"20000", "abc", "-1", "0"}) {
        type("revolutions", bad);
        EXPECT_TRUE(sentence("badInput").contains(QStringLiteral("from 1 to 4096"))) << bad;
        EXPECT_FALSE(isEnabled("wizardNext"));
    }
    type("revolutions", "2");
    EXPECT_EQ(sentence("badInput"), QString());
    EXPECT_TRUE(isEnabled("wizardNext"));
}

TEST_F(WizardPages, NeitherWhatIsHalfTypedNorWhatIsRefusedIsWanted)
{
    wizard.setEncoder(&baumer());
    next();
    next();
    next();
    type("steps", "99999999");
    EXPECT_FALSE(wanted.value("2.0"_ring, Parameter::steps));
    leaveField();
    EXPECT_FALSE(wanted.value("2.0"_ring, Parameter::steps));
    EXPECT_FALSE(isEnabled("wizardNext"));
    type("steps", "400");
    EXPECT_FALSE(wanted.value("2.0"_ring, Parameter::steps));
    leaveField();
    EXPECT_EQ(wanted.value("2.0"_ring, Parameter::steps), 400);
}

TEST_F(WizardPages, EscInAFieldGivesTheValueBefore)
{
    wanted.set("2.0"_ring, Parameter::steps, 100);
    wizard.setEncoder(&baumer());
    next();
    next();
    next();
    type("steps", "99999999");
    auto *field = find<QLineEdit>("steps");
    QTest::keyClick(field, Qt::Key_Escape);
    EXPECT_EQ(field->text(), QStringLiteral("100"));
    EXPECT_TRUE(isEnabled("wizardNext"));
    leaveField();
    EXPECT_EQ(wanted.value("2.0"_ring, Parameter::steps), 100);
}

TEST_F(WizardPages, CancelRestoresWhatWasWantedBefore)
{
    wanted.set("2.0"_ring, Parameter::steps, 100);
    wizard.setEncoder(&baumer());
    next();
    next();
    next();
    type("steps", "400");
    leaveField();
    type("revolutions", "2");
    leaveField();
    wanted.set("2.0"_ring, Parameter::offset, 7); // in the parameter panel beside it
    click("wizardCancel");
    EXPECT_EQ(wanted.values("2.0"_ring), (ParameterValues{{Parameter::steps, 100}, {Parameter::offset, 7}}));
}

TEST_F(WizardPages, AMeasuringRangeThatJumpsIsSaid)
{
    for (const auto &[parameter, value] :
         {std::pair(Parameter::steps, 200), {Parameter::revolutions, 1}, {Parameter::coding, 3}})
        baumer().tell(parameter, value);
    wizard.setEncoder(&baumer());
    next();
    next();
    next();
    type("measuring-range", "5");
    leaveField();
    EXPECT_TRUE(sentence("scaleWarning").contains(QStringLiteral("jump")));
    EXPECT_TRUE(text("scaleText").contains(QStringLiteral("total range 1000 steps")));
    type("measuring-range", "8");
    leaveField();
    EXPECT_EQ(sentence("scaleWarning"), QString());
}

TEST_F(WizardPages, TheCalculatorFillsStepsAndRevolutions)
{
    wizard.setEncoder(&fraba());
    next();
    next();
    next();
    click("gearUse"); // 10 mm per turn, 0.01 mm per step
    EXPECT_EQ(wanted.value("1.0"_ring, Parameter::steps), 1000);
    EXPECT_EQ(wanted.value("1.0"_ring, Parameter::revolutions), 1);
    EXPECT_EQ(find<QLineEdit>("steps")->text(), QStringLiteral("1000"));
}

TEST_F(WizardPages, WhatTheCalculatorCannotReadGivesNoResult)
{
    wizard.setEncoder(&fraba());
    next();
    next();
    next();
    QDoubleSpinBox &travel = *find<QWidget>("gearUse")->parentWidget()->findChild<QDoubleSpinBox *>();
    travel.setFocus();
    travel.selectAll();
    QTest::keyClicks(&travel, QStringLiteral("2,000"));
    QTest::keyClick(&travel, Qt::Key_Tab);
    EXPECT_FALSE(isEnabled("gearUse"));
    EXPECT_TRUE(text("gearAnswer").contains(QStringLiteral("\"2,000\" may mean")))
        << text("gearAnswer").toStdString();
    type("steps", "255");
    next();
    click("wizardBack");
    EXPECT_EQ(travel.text(), QStringLiteral("2,000"));
    EXPECT_FALSE(isEnabled("gearUse"));
    travel.setFocus();
    travel.selectAll();
    QTest::keyClicks(&travel, QStringLiteral("2"));
    QTest::keyClick(&travel, Qt::Key_U, Qt::AltModifier);
    EXPECT_TRUE(QTest::qWaitFor([&] { return wanted.value("1.0"_ring, Parameter::steps) == 200; }))
        << "as typed, without leaving the field";
}

TEST_F(WizardPages, ValuesTheEncoderHasAreNotWrittenUnlessAskedFor)
{
    wizard.setEncoder(&fraba());
    next();
    click("readAll");
    bus.advance(2000);
    next();
    next();
    type("steps", "8192");
    next();
    EXPECT_TRUE(sentence("reviewProblem").contains(QStringLiteral("nothing to write")));
    EXPECT_FALSE(isEnabled("wizardNext"));
    click("writeAll");
    EXPECT_TRUE(isEnabled("wizardNext"));
    auto *words = find<QTableView>("plannedWords");
    test::ModelTester tester(*words->model());
    EXPECT_EQ(words->model()->index(0, 1).data(), QStringLiteral("02002000"));
    EXPECT_EQ(out(), 0u);
}

// The job first sends 00000000 if OUT holds another word.
// What is told below the tables, and the choice of how to go on, are not to be scrolled to.
TEST_F(WizardPages, InTheSmallestWindowTheWholeReviewIsInSight)
{
    wizard.resize(smallestWizard);
    wizard.setEncoder(&fraba());
    next();
    next();
    next();
    type("steps", "255");
    leaveField();
    next();
    QCoreApplication::processEvents();
    const auto *page = find<QTableView>("changes")->parentWidget();
    EXPECT_LE(page->height(), page->parentWidget()->height());
    const auto *changes = find<QTableView>("changes");
    EXPECT_GE(changes->viewport()->height(), changes->verticalHeader()->length());
}

TEST_F(WizardPages, TheDialMakesRoomForTheValuesInTheSmallestWindow)
{
    wizard.resize(smallestWizard);
    wizard.setEncoder(&fraba());
    next();
    next();
    next();
    QCoreApplication::processEvents();
    const auto *page = find<QCheckBox>("initialisePreset")->parentWidget();
    EXPECT_LE(page->height(), page->parentWidget()->height());
}

TEST_F(WizardPages, TheWordThatClearsOutIsReviewedToo)
{
    bus.channel("2.0"_ring)->stage(0x8000'0000);
    ASSERT_TRUE(bus.channel("2.0"_ring)->write());
    bus.advance(20);
    ASSERT_EQ(out("2.0"_ring), 0x8000'0000u);
    wizard.setEncoder(&baumer());
    next();
    next();
    next();
    type("steps", "4096");
    next();
    const QAbstractItemModel &words = *find<QTableView>("plannedWords")->model();
    EXPECT_EQ(words.index(0, 1).data(), QStringLiteral("00000000"));
    EXPECT_EQ(words.index(1, 1).data(), QStringLiteral("02001000"));
}

TEST_F(WizardPages, ThePositionIsNotSetWhileTheModeIsUnknown)
{
    wizard.setEncoder(&fraba());
    next();
    next();
    next();
    type("preset", "0");
    next();
    EXPECT_TRUE(sentence("reviewProblem").contains(QStringLiteral("cam mode")));
    EXPECT_FALSE(isEnabled("wizardNext"));
}

class WizardPagesInMode : public WizardPages, public testing::WithParamInterface<Mode>
{};

// In cam mode the word that sets the position sets a cam; in velocity mode it works as in position mode.
TEST_P(WizardPagesInMode, ThePositionIsSetOutsideCamModeOnly)
{
    const bool inCamMode = GetParam() == Mode::cam;
    for (const SwitchMode &job : {SwitchMode{Mode::position}, SwitchMode{GetParam(), inCamMode ? 1U : 0U}}) {
        ASSERT_TRUE(fraba().start(job));
        bus.advance(2000);
    }
    ASSERT_EQ(fraba().latest().mode, GetParam());
    wizard.setEncoder(&fraba());
    next();
    next();
    next();
    type("preset", "0");
    next();
    EXPECT_EQ(sentence("reviewProblem").contains(QStringLiteral("is in cam mode")), inCamMode);
    EXPECT_EQ(isEnabled("wizardNext"), !inCamMode);
}

INSTANTIATE_TEST_SUITE_P(, WizardPagesInMode, testing::Values(Mode::cam, Mode::velocity));

// A FRABA carries out 40000000 only once per programmed preset.
TEST_F(WizardPages, APresetThatIsUsedUpIsProgrammedAgainWhereNoneIsGiven)
{
    wizard.setEncoder(&fraba());
    next();
    click("isPositionMode");
    bus.advance(5);
    ASSERT_TRUE(fraba().start(SetPreset{.value = 1'000}));
    bus.advance(2000);
    ASSERT_EQ(fraba().latest().position, 1'000);
    controls->turnBy(NodeId("1.0"), 77);
    bus.advance(20);
    ASSERT_EQ(fraba().latest().position, 1'077);
    next();
    next();
    click("initialisePreset");
    next();
    EXPECT_EQ(sentence("reviewProblem"), QString());
    EXPECT_EQ(pictureOfReview().position, 1'077);
    EXPECT_EQ(pictureOfReview().then->position, 1'000);
    controls->turnBy(NodeId("1.0"), 3);
    bus.advance(66);
    EXPECT_EQ(pictureOfReview().position, 1'080);
    click("byItself");
    next();
    bus.advance(2000);
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_EQ(fraba().latest().position, 1'000);
}

// Setting the position replaces the zero offset: writing one as well would cost an EEPROM write for nothing.
TEST_F(WizardPages, TheZeroOffsetIsLeftOutWhereThePositionIsSet)
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
    type("zero-offset", "30");
    type("preset", "10");
    leaveField();
    const auto leftOut =
        QStringLiteral("Setting the position makes a new zero offset: the wanted one, 30, is left out.");
    EXPECT_EQ(sentence("scaleWarning"), leftOut);
    next();
    EXPECT_TRUE(text("reviewNotes").contains(leftOut)) << text("reviewNotes").toStdString();
    const QAbstractItemModel &changes = *find<QTableView>("changes")->model();
    for (int row = 0; row < changes.rowCount(); ++row)
        EXPECT_NE(changes.index(row, 0).data(), QStringLiteral("Zero offset"));
    const int before = fraba().eepromWrites();
    click("byItself");
    next();
    bus.advance(4000);
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_TRUE(text("leftIn").startsWith(QStringLiteral("Verified: read back")))
        << text("leftIn").toStdString();
    EXPECT_EQ(fraba().latest().position, 10);
    EXPECT_EQ(fraba().eepromWrites() - before, 3) << "steps, preset, and the zero offset that it makes";
    EXPECT_EQ(wanted.value("1.0"_ring, Parameter::zeroOffset), 30) << "still wanted";
    next();
    const QString report = find<QPlainTextEdit>("account")->toPlainText();
    EXPECT_TRUE(report.contains(leftOut)) << report.toStdString();
    EXPECT_TRUE(report.contains(QRegularExpression(QStringLiteral("Position set to: +10\n"))));
}

TEST_F(WizardPages, TheReportSaysThatThePositionIsYetToBeSet)
{
    wizard.setEncoder(&fraba());
    next();
    click("isPositionMode");
    bus.advance(5);
    next();
    next();
    type("preset", "10");
    leaveField();
    next();
    next();
    click("wizardCancel");
    bus.advance(100);
    ASSERT_FALSE(wizard.isBusy());
    next();
    const QString report = find<QPlainTextEdit>("account")->toPlainText();
    EXPECT_TRUE(report.contains(QRegularExpression(QStringLiteral("Position to be set: +10\n"))))
        << report.toStdString();
}

// What a button does changes from page to page, and what is said beside it from row to row.
TEST_F(WizardPages, TheButtonsStayWhereTheyAre)
{
    const auto left = [this](const char *button) {
        QCoreApplication::processEvents();
        return find<QWidget>(button)->mapTo(&wizard, QPoint()).x();
    };
    wizard.setEncoder(&fraba());
    const int back = left("wizardBack");
    next();
    auto *known = find<QTableView>("known");
    const int tell = left("tellValue");
    for (int row = 0; row < known->model()->rowCount(); ++row) {
        known->selectRow(row);
        EXPECT_EQ(left("tellValue"), tell) << row;
    }
    next();
    next();
    type("steps", "255");
    leaveField();
    next();
    ASSERT_EQ(wizard.page(), ParameterWizard::review);
    EXPECT_EQ(left("wizardBack"), back);
}

TEST_F(WizardPages, TheCalculatorsButtonStaysWhereItIs)
{
    wizard.resize(450, 476);
    wizard.setEncoder(&fraba());
    next();
    next();
    next();
    const auto *answer = find<QLabel>("gearAnswer");
    const auto *take = find<QWidget>("gearUse");
    const auto topWithLines = [&](int lines) {
        for (int i = 0; i < 10; ++i) // each layout tells the one around it
            QCoreApplication::processEvents();
        EXPECT_EQ(answer->height(), lines * answer->fontMetrics().lineSpacing());
        return take->mapTo(&wizard, QPoint()).y();
    };
    const int before = topWithLines(2);
    const auto fields = take->parentWidget()->findChildren<QDoubleSpinBox *>();
    fields.first()->setValue(777.7777); // mm per turn
    fields.last()->setValue(0.3);       // mm per step
    EXPECT_EQ(topWithLines(3), before) << answer->text().toStdString();
}

// A position has no read-out of its own.
TEST_F(WizardPages, APositionThatWasSetAloneIsNotSaidToBeReadBack)
{
    wizard.setEncoder(&fraba());
    next();
    click("readAll");
    bus.advance(3000);
    click("isPositionMode");
    bus.advance(5);
    next();
    next();
    click("initialisePreset");
    next();
    click("byItself");
    next();
    bus.advance(3000);
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_TRUE(
        text("leftIn").startsWith(QStringLiteral("Verified: the encoder shows the position that was set.")))
        << text("leftIn").toStdString();
}

TEST_F(WizardPages, AZeroOffsetShiftsThePositionAndTheReviewSaysWhereTo)
{
    wizard.setEncoder(&fraba());
    next();
    click("readAll");
    bus.advance(3000);
    click("isPositionMode");
    bus.advance(5);
    next();
    next();
    type("zero-offset", "30");
    leaveField();
    const auto shift = QStringLiteral("This shifts the position: now 12345, then 12375.");
    EXPECT_EQ(sentence("scaleWarning"), shift);
    next();
    EXPECT_TRUE(text("reviewNotes").contains(shift)) << text("reviewNotes").toStdString();
    click("byItself");
    next();
    bus.advance(2000);
    EXPECT_EQ(fraba().latest().position, 12'375);
}

TEST_F(WizardPages, EachSessionBeginsByHandAndWithoutSettingThePosition)
{
    wizard.setEncoder(&fraba());
    next();
    click("isPositionMode");
    bus.advance(5);
    next();
    next();
    type("preset", "10");
    next();
    click("byItself");
    next();
    bus.advance(3000);
    ASSERT_FALSE(wizard.isBusy());
    next();
    next(); // closes it
    ASSERT_EQ(wizard.page(), ParameterWizard::device);
    next();
    next();
    next();
    EXPECT_EQ(find<QLineEdit>("preset")->text(), QStringLiteral("10")) << "it is still wanted";
    EXPECT_FALSE(find<QAbstractButton>("initialisePreset")->isChecked());
    type("steps", "255");
    next();
    EXPECT_TRUE(find<QAbstractButton>("byHand")->isChecked());
    const QAbstractItemModel &words = *find<QTableView>("plannedWords")->model();
    for (int row = 0; row < words.rowCount(); ++row)
        EXPECT_NE(words.index(row, 1).data(), QStringLiteral("40000000"));
}

TEST_F(WizardPages, ThePositionIsSetOnlyIfTheBoxShowsIt)
{
    const auto isTicked = [this] { return find<QAbstractButton>("initialisePreset")->isChecked(); };
    wizard.setEncoder(&fraba());
    next();
    next();
    next();
    type("preset", "5");
    EXPECT_TRUE(isTicked()) << "while it is typed";
    click("initialisePreset");
    EXPECT_FALSE(isTicked());
    next();
    click("wizardBack");
    type("preset", "6");
    EXPECT_FALSE(isTicked());
    next();
    click("wizardBack");
    EXPECT_FALSE(isTicked()) << "as the user has said";
}

TEST_F(WizardPages, EachHandshakeBeginsByHand)
{
    beginHandshakeOfBaumer();
    bus.advance(600);
    click("runByItself");
    for (int i = 0; i < 100 && wizard.isBusy(); ++i)
        bus.advance(60);
    ASSERT_FALSE(wizard.isBusy());
    click("wizardBack");
    ASSERT_EQ(wizard.page(), ParameterWizard::review);
    EXPECT_TRUE(find<QAbstractButton>("byHand")->isChecked());
}

// IN is 00000000 then, which is also what an encoder in operation at position 0 shows.
TEST_F(WizardPages, AnEncoderWithoutPowerIsNotSaidToBeAtZero)
{
    beginHandshakeOfBaumer();
    stepByHand(1);
    bus.advance(600);
    const auto answerOfFirst = [this] {
        return find<QTableView>("steps")->model()->index(0, StepTable::in).data().toString();
    };
    const QString confirmed = answerOfFirst();
    ASSERT_NE(confirmed, QString());
    controls->powerCycle(NodeId("2.0"));
    bus.advance(3000);
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_EQ(answerOfFirst(), confirmed);
    next();
    const QString report = find<QPlainTextEdit>("account")->toPlainText();
    EXPECT_FALSE(report.contains(QRegularExpression(QStringLiteral("Position after: \\+?0\n"))))
        << report.toStdString();
}

// The offset of a Baumer encoder can neither be read nor guessed.
TEST_F(WizardPages, WithoutTheOffsetTheReviewDrawsOnlyNow)
{
    baumer().tell(Parameter::steps, 8'192);
    baumer().tell(Parameter::revolutions, 1);
    baumer().tell(Parameter::coding, 3);
    baumer().tell(Parameter::measuringRange, 4'096);
    wizard.setEncoder(&baumer());
    wanted.set("2.0"_ring, Parameter::preset, 500);
    next();
    next();
    next();
    click("initialisePreset");
    next();
    bus.advance(66);
    EXPECT_TRUE(pictureOfReview().position);
    EXPECT_EQ(pictureOfReview().then, DialState::Then());
    EXPECT_TRUE(pictureOfReview().note.contains(QStringLiteral("Offset")))
        << pictureOfReview().note.toStdString();
    baumer().tell(Parameter::offset, 0);
    bus.advance(66);
    EXPECT_EQ(pictureOfReview().then->position, 500);
}

// It may be a FRABA in cam mode.
TEST_F(WizardPages, TheModeOfAnUnnamedK3CanBeTold)
{
    ASSERT_TRUE(bus.name("2.0"_ring, {}));
    bus.advance(5);
    ASSERT_TRUE(baumer().device().isGeneric());
    wizard.setEncoder(&baumer());
    next();
    EXPECT_TRUE(find<QWidget>("isPositionMode")->isVisible());
    next();
    next();
    type("preset", "0");
    next();
    EXPECT_TRUE(sentence("reviewProblem").contains(QStringLiteral("cam mode")));
    EXPECT_FALSE(isEnabled("wizardNext"));
    for (int page = ParameterWizard::review; page > ParameterWizard::known; --page)
        click("wizardBack");
    click("isPositionMode");
    bus.advance(5);
    for (int page = ParameterWizard::known; page < ParameterWizard::review; ++page)
        next();
    EXPECT_TRUE(isEnabled("wizardNext"));
    click("byItself");
    next();
    bus.advance(3000);
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_EQ(out("2.0"_ring), 0u);
    EXPECT_EQ(baumer().known(Parameter::preset)->value, 0);
}

TEST_F(WizardPages, NobodyAsksForTheModeOfAnEncoderThatHasNone)
{
    wizard.setEncoder(&baumer());
    next();
    EXPECT_FALSE(find<QWidget>("isPositionMode")->isVisible());
}

TEST_F(WizardPages, TheReportIsSavedAsTextAndAsHtml)
{
    beginHandshakeOfBaumer();
    stepByHand();
    next();
    const QTemporaryDir folder;
    auto *page = wizard.findChild<AccountView *>();
    const QString path = folder.filePath(QStringLiteral("report"));
    ASSERT_TRUE(page->saveTo(path + QStringLiteral(".txt")));
    ASSERT_TRUE(page->saveTo(path + QStringLiteral(".html")));
    EXPECT_FALSE(page->saveTo(folder.filePath(QStringLiteral("missing/report.txt"))));
    test::OldFile old;
    EXPECT_FALSE(old.saveWithoutRoom([&](const QString &name) { return page->saveTo(name); }));
    EXPECT_TRUE(old.isThere());
    QFile text(path + QStringLiteral(".txt"));
    QFile html(path + QStringLiteral(".html"));
    ASSERT_TRUE(text.open(QIODevice::ReadOnly));
    ASSERT_TRUE(html.open(QIODevice::ReadOnly));
    for (const QString &report : {QString::fromUtf8(text.readAll()), QString::fromUtf8(html.readAll())})
        for (const char *part : {"2.0", "Baumer GXP6W K3", "2026", "02001000", "(confirmed)", "EEPROM writes",
                                 "Position before", "cannot be read"})
            EXPECT_TRUE(report.contains(QString::fromLatin1(part))) << part << report.toStdString();
}

// Baumer manual: the offset is added to the preset.
TEST_F(WizardPages, TheReportDoesNotTakeThePresetForThePosition)
{
    for (const auto &[parameter, value] : {std::pair{Parameter::coding, 3},
                                           {Parameter::steps, 8'192},
                                           {Parameter::revolutions, 1},
                                           {Parameter::measuringRange, 4'096}})
        baumer().tell(parameter, value);
    controls->setSpeed(NodeId("2.0"), 0);
    wizard.setEncoder(&baumer());
    wanted.set("2.0"_ring, Parameter::preset, 1000);
    wanted.set("2.0"_ring, Parameter::offset, 55);
    next();
    next();
    next();
    click("initialisePreset");
    next();
    click("byItself");
    next();
    bus.advance(4000);
    ASSERT_FALSE(wizard.isBusy());
    next();
    const QString report = find<QPlainTextEdit>("account")->toPlainText();
    const auto has = [&](const QString &fact) { return report.contains(QRegularExpression(fact)); };
    EXPECT_TRUE(has(QStringLiteral("Position set by the preset: +%1\n").arg(QLocale().toString(1000))))
        << report.toStdString();
    EXPECT_TRUE(has(QStringLiteral("Position after: +%1\n").arg(QLocale().toString(1055))))
        << report.toStdString();
    EXPECT_FALSE(report.contains(QStringLiteral("Position set to")));
}

// It acts once, and the simulated encoder has used its preset up.
TEST_F(WizardPages, APresetThatIsThereAndWrittenAgainHasItsReason)
{
    wizard.setEncoder(&fraba());
    next();
    click("readAll");
    bus.advance(3000);
    click("isPositionMode");
    bus.advance(5);
    next();
    next();
    ASSERT_EQ(fraba().known(Parameter::presetFlag)->value, 0);
    type("steps", "255");
    type("preset", "0");
    leaveField();
    next();
    const QAbstractItemModel &changes = *find<QTableView>("changes")->model();
    EXPECT_EQ(changes.index(1, 0).data(), QStringLiteral("Preset"));
    EXPECT_EQ(changes.index(1, 3).data(), QStringLiteral("already there, written if used up"));
    EXPECT_TRUE(text("reviewNotes").contains(QStringLiteral("the one in the encoder is used up")))
        << text("reviewNotes").toStdString();
    click("writeAll");
    EXPECT_EQ(changes.index(changes.rowCount() - 1, 3).data(), QStringLiteral("written"));
    EXPECT_FALSE(text("reviewNotes").contains(QStringLiteral("used up")));
}

} // namespace
} // namespace codewheel
