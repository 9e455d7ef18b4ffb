// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/model_tester.h"
#include "tests/widgets/rod_bus.h"
#include "tests/widgets/wizard/wizard_test.h"
#include "widgets/dial/rod_view.h"

#include <QDoubleSpinBox>
#include <QHeaderView>

// The wizard with a TR LA-66: words from chapters 3 and 4 of its manual.
namespace codewheel {
namespace {

using test::rodPlace;

class WizardRod : public test::WizardTest
{
protected:
    WizardRod()
        : WizardTest(test::makeRodBus)
    {}

    EncoderSession &rod() { return *bus.encoder(rodPlace); }

    void toValues()
    {
        wizard.setEncoder(&rod());
        next();
        click("readAll");
        bus.advance(2000);
        next();
        next();
    }
    void typeNumber(const char *field, double number)
    {
        auto *box = find<QDoubleSpinBox>(field);
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, box->textFromValue(number));
        QTest::keyClick(box, Qt::Key_Return);
    }
    QStringList plannedWords() const
    {
        const QAbstractItemModel &model = *find<QTableView>("plannedWords")->model();
        QStringList words;
        for (int row = 0; row < model.rowCount(); ++row)
            words.append(model.index(row, 1).data().toString());
        return words;
    }
    // 500 mm at 0.1 mm, the position set to 1000.
    void toReview()
    {
        toValues();
        typeNumber("rodLength", 500);
        typeNumber("rodResolution", 0.1);
        click("rodUse");
        click("initialisePreset");
        type("positionToSet", "1000");
        next();
    }

    const QStringList measuringLength{QStringLiteral("42001388"), QStringLiteral("C2001388"),
                                      QStringLiteral("42001388"), QStringLiteral("02000000"),
                                      QStringLiteral("82000000"), QStringLiteral("02000000")};
    const QStringList normal{QStringLiteral("00000000")};
    const QStringList setPosition{QStringLiteral("460003E8"), QStringLiteral("C60003E8"),
                                  QStringLiteral("460003E8")};
};

TEST_F(WizardRod, TheDirectionCheckIsDoneWithTheMagnet)
{
    wizard.setEncoder(&rod());
    next();
    click("readAll");
    bus.advance(2000);
    next();
    controls->moveMagnetTo(rodPlace.node, 100);
    bus.advance(50);
    click("checkAgain");
    controls->moveMagnetTo(rodPlace.node, 101);
    bus.advance(50);
    const auto *verdict = find<QWidget>("verdict")->findChild<QLabel *>();
    ASSERT_NE(verdict, nullptr);
    EXPECT_TRUE(isEnabled("otherWay"));
    click("otherWay");
    EXPECT_EQ(wanted.value(rodPlace, Parameter::direction), 1);
    EXPECT_EQ(out(rodPlace), 0u) << "looking sends nothing";
}

TEST_F(WizardRod, TheCalculatorFillsTheMeasuringLengthAndTellsTheRod)
{
    toValues();
    typeNumber("rodLength", 500);
    EXPECT_TRUE(text("rodAnswer").contains(QStringLiteral("C350h"))) << text("rodAnswer").toStdString();
    typeNumber("rodResolution", 0.1);
    EXPECT_TRUE(text("rodAnswer").contains(QStringLiteral("1388h"))) << text("rodAnswer").toStdString();
    click("rodUse");
    EXPECT_EQ(wanted.value(rodPlace, Parameter::measuringLength), 5000);
    EXPECT_EQ(find<QLineEdit>("measuring-length")->text(), QStringLiteral("5000"));
    ASSERT_TRUE(rod().known(Parameter::rodLength));
    EXPECT_EQ(rod().known(Parameter::rodLength)->value, 500'000);
    EXPECT_EQ(wanted.value(rodPlace, Parameter::rodLength), std::nullopt) << "never written";
    EXPECT_TRUE(text("scaleText").contains(QStringLiteral("0.100 mm per step")))
        << text("scaleText").toStdString();
}

TEST_F(WizardRod, WhatTheCalculatorCannotReadGivesNoResult)
{
    toValues();
    typeNumber("rodLength", 500);
    auto *length = find<QDoubleSpinBox>("rodLength");
    length->selectAll();
    QTest::keyClicks(length, QStringLiteral("2,000"));
    QTest::keyClick(length, Qt::Key_Tab);
    EXPECT_FALSE(isEnabled("rodUse"));
    EXPECT_TRUE(text("rodAnswer").contains(QStringLiteral("\"2,000\" may mean")))
        << text("rodAnswer").toStdString();
    typeNumber("rodLength", 2000);
    EXPECT_TRUE(isEnabled("rodUse"));
}

TEST_F(WizardRod, APositionToSetNeedsAValue)
{
    toValues();
    EXPECT_FALSE(find<QLineEdit>("positionToSet")->isEnabled());
    click("initialisePreset");
    EXPECT_FALSE(isEnabled("wizardNext"));
    EXPECT_NE(sentence("badInput"), QString());
    type("positionToSet", "16777216");
    EXPECT_TRUE(sentence("badInput").contains(QLocale().toString(16'777'215)));
    type("positionToSet", "0xFFFFFF");
    EXPECT_EQ(sentence("badInput"), QString());
    EXPECT_TRUE(isEnabled("wizardNext"));
}

TEST_F(WizardRod, TheReviewHasTheWordsAndTheEepromWrites)
{
    toReview();
    EXPECT_EQ(plannedWords(), measuringLength + normal + setPosition + normal);
    EXPECT_TRUE(text("eepromWrites").contains(QStringLiteral("2."))) << text("eepromWrites").toStdString();
    EXPECT_EQ(out(rodPlace), 0u);
}

TEST_F(WizardRod, InANarrowReviewLongValuesLeaveRoomForWhatHappens)
{
    wanted.set(rodPlace, Parameter::direction, 1);
    toValues();
    next();
    auto *table = find<QTableView>("changes");
    table->setFixedWidth(340);
    QCoreApplication::processEvents();
    const QAbstractItemModel &model = *table->model();
    ASSERT_EQ(model.rowCount(), 1);
    const QHeaderView &header = *table->horizontalHeader();
    for (int column = 0; column < model.columnCount(); ++column)
        for (const QString &word : model.index(0, column).data().toString().split(u' '))
            EXPECT_GE(header.sectionSize(column), table->fontMetrics().horizontalAdvance(word)) << column;
    EXPECT_LE(header.length(), table->viewport()->width());
    EXPECT_GE(table->rowHeight(0), 2 * table->fontMetrics().height()) << "on two lines at least";
}

TEST_F(WizardRod, ByHandItGoesServiceByServiceToTheEnd)
{
    toReview();
    click("byHand");
    next();
    const int steps = static_cast<int>((measuringLength + normal + setPosition + normal).size());
    EXPECT_EQ(stepByHand(2), 2);
    EXPECT_EQ(states().size(), steps) << "the position is yet to be set, by a second job";
    EXPECT_EQ(out(rodPlace), 0xC2001388);
    const int values = 2 + stepByHand();
    EXPECT_EQ(values, static_cast<int>((measuringLength + normal).size()));
    EXPECT_TRUE(wizard.isBusy()) << "the position is still to be set";
    EXPECT_EQ(values + stepByHand(), steps);
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_TRUE(text("leftIn").startsWith(QStringLiteral("Verified"))) << text("leftIn").toStdString();
    EXPECT_EQ(rod().known(Parameter::measuringLength)->value, 5000);
    EXPECT_EQ(rod().latest().position, 1000);
    EXPECT_EQ(rod().eepromWrites(), 2);
    auto *table = find<QTableView>("steps");
    test::ModelTester tester(*table->model());
    ASSERT_EQ(table->model()->rowCount(), steps);
    for (int row = 0; row < steps; ++row)
        EXPECT_EQ(table->model()->index(row, 3).data(), QStringLiteral("done")) << row;
    next();
    EXPECT_TRUE(find<QPlainTextEdit>("account")->toPlainText().contains(QStringLiteral("Position set to:")));
    EXPECT_TRUE(find<QPlainTextEdit>("account")->toPlainText().contains(QStringLiteral("C60003E8")));
}

TEST_F(WizardRod, RunningByItselfItDoesTheSame)
{
    toReview();
    click("byItself");
    next();
    bus.advance(500); // the values
    bus.advance(500); // the position
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_EQ(rod().latest().position, 1000);
    EXPECT_EQ(out(rodPlace), 0u);
}

TEST_F(WizardRod, CancelledBeforeTheFirstStepNothingHasFailed)
{
    toReview();
    click("byHand");
    next();
    bus.advance(60);
    click("wizardCancel");
    bus.advance(500);
    EXPECT_EQ(states(), QStringList{QStringLiteral("done")});
}

TEST_F(WizardRod, CancelledInTheMiddleItIsLeftWithWhatItHas)
{
    toReview();
    click("byHand");
    next();
    stepByHand(4); // the measuring length is written
    const auto question = test::Question::answeredBy(QStringLiteral("Leave it with what it has"));
    click("wizardCancel");
    bus.advance(500);
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_EQ(out(rodPlace), 0u);
    EXPECT_EQ(rod().latest().state, EncoderState::operation);
    EXPECT_EQ(rod().known(Parameter::measuringLength)->value, 5000);
    EXPECT_NE(rod().latest().position, 1000) << "the second job was not begun";
}

TEST_F(WizardRod, TheReviewWarnsWhereThePositionCannotBeSet)
{
    toReview();
    EXPECT_EQ(sentence("reviewProblem"), QString());
    click("wizardBack");
    controls->setFault(TrainingFault::magnetLost, rodPlace.node, 1);
    bus.advance(100);
    next();
    EXPECT_TRUE(sentence("reviewProblem").contains(QStringLiteral("the position is not set")));
}

TEST_F(WizardRod, TheReviewDrawsThenInTheScaleOfThen)
{
    toReview();
    const RodState &rod = find<RodView>("")->state();
    ASSERT_TRUE(rod.then);
    ASSERT_TRUE(rod.then->scale);
    EXPECT_DOUBLE_EQ(rod.then->scale->millimetres(*rod.then->position), 100);
    EXPECT_NEAR(magnetPlaceThen(rod).value_or(-1), 0.2, 0.001);
}

TEST_F(WizardRod, CancelSpeaksOfNoRunAndSaysWhatItShows)
{
    controls->moveMagnetTo(rodPlace.node, 100);
    toReview();
    click("byHand");
    next();
    stepByHand(7); // it has the measuring length, and is in normal running
    bus.advance(600);
    ASSERT_TRUE(rod().showsPosition()) << static_cast<int>(rod().latest().state) << ' ' << rod().latest().in;
    const auto question = test::Question::answeredBy(QStringLiteral("Go on"));
    click("wizardCancel");
    EXPECT_FALSE(question.text().contains(QStringLiteral("run"))) << question.text().toStdString();
    EXPECT_TRUE(question.text().contains(
        QStringLiteral("It shows %1 now.").arg(QLocale().toString(qlonglong{*rod().latest().position}))))
        << question.text().toStdString();
}

} // namespace
} // namespace codewheel
