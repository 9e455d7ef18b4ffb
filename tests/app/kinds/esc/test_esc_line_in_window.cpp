// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/esc/esc_line_at_work.h"
#include "jobs/write_plan.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "widgets/dial/code_disc.h"
#include "widgets/dial/dial_panel.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/role_label.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/parameters/value_input.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/parameters/write_review.h"
#include "widgets/structure/structure_model.h"
#include "widgets/structure/structure_view.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QAbstractItemModel>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QModelIndex>
#include <QPushButton>
#include <QStatusBar>
#include <QTableView>
#include <QTest>
#include <QTextBrowser>
#include <QTreeView>

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

const Place standing = placeOnLine({5}); // at 1235h = 4661
const Place turning = placeOnLine({3});

class EscLineInWindow : public test::WindowTest
{
protected:
    EscLineInWindow() { advance(200); }

    QTreeView &tree() { return *window().findChild<QTreeView *>(QStringLiteral("structure")); }
    const StructureModel &model() { return *static_cast<const StructureModel *>(tree().model()); }
    QString cell(Place number, StructureModel::Column column)
    {
        return model().indexOf(number).siblingAtColumn(column).data().toString();
    }
    void choose(Place number)
    {
        const QModelIndex row = model().indexOf(number);
        ASSERT_TRUE(row.isValid());
        tree().scrollTo(row);
        QTest::mouseClick(tree().viewport(), Qt::LeftButton, {}, tree().visualRect(row).center());
        advance(50);
    }
    EscLineSession &line() { return *shown->line().session(); }
    SimulatedEscLine &simulated() { return *shown->line().training(); }
    EncoderSession &encoder(Place number) { return *line().encoder(number); }
    bool isSaidInStatusLine(const QString &text)
    {
        for (const QLabel *label : window().statusBar()->findChildren<QLabel *>())
            if (label->isVisibleTo(window().statusBar()) && label->text().contains(text))
                return true;
        return false;
    }
};

// It takes requests.
TEST_F(EscLineInWindow, ItsParametersAreNotOfferedAsWordsOfAPlc)
{
    const auto offersWords = [this] {
        const auto *menu = window().findChild<QMenu *>(QStringLiteral("moreMenu"));
        return std::ranges::any_of(menu->actions(), [](const QAction *action) {
            return action->isVisible() && action->text() == QStringLiteral("Copy as &two words of a PLC");
        });
    };
    choose(test::fraba);
    EXPECT_TRUE(offersWords());
    choose(standing);
    EXPECT_FALSE(offersWords());
}

TEST_F(EscLineInWindow, StandsBesideTheRingInTheTree)
{
    ASSERT_EQ(model().rowCount(), 2);
    const QModelIndex line = model().indexOf(firstLine);
    EXPECT_EQ(line.row(), 1);
    EXPECT_TRUE(line.data().toString().startsWith(QStringLiteral("Line")));
    EXPECT_EQ(line.siblingAtColumn(StructureModel::stateColumn).data().toString(), QStringLiteral("open"));
    EXPECT_EQ(model().rowCount(line), 3);
    EXPECT_TRUE(tree().isExpanded(line));
    EXPECT_TRUE(cell(standing, StructureModel::deviceColumn).startsWith(QStringLiteral("esc:05  Kübler")));
    EXPECT_EQ(cell(standing, StructureModel::stateColumn), QStringLiteral("ok"));
    EXPECT_EQ(cell(standing, StructureModel::positionColumn), QLocale().toString(0x1235));
    EXPECT_EQ(cell(placeOnLine({0x12}), StructureModel::codeColumn), QStringLiteral("12h (18)"));
    EXPECT_TRUE(isSaidInStatusLine(QStringLiteral("3 of 3 answer")));
}

TEST_F(EscLineInWindow, PositionsOfBothBusesRunInTheTree)
{
    const QString before = cell(turning, StructureModel::positionColumn);
    advance(500);
    EXPECT_NE(cell(turning, StructureModel::positionColumn), before);
    EXPECT_FALSE(cell(test::fraba, StructureModel::positionColumn).isEmpty());
}

TEST_F(EscLineInWindow, ASilentEncoderIsShownAsSuchAndTheOthersGoOn)
{
    simulated().withEncoder({5}, [](SimulatedEscEncoder &encoder) { encoder.condition().mute = true; });
    advance(2000);
    EXPECT_EQ(cell(standing, StructureModel::stateColumn), QStringLiteral("silent"));
    EXPECT_EQ(cell(turning, StructureModel::stateColumn), QStringLiteral("ok"));
    EXPECT_EQ(cell(standing, StructureModel::positionColumn), QLocale().toString(0x1235)) << "the last one";
    EXPECT_TRUE(isSaidInStatusLine(QStringLiteral("2 of 3 answer")));
}

TEST_F(EscLineInWindow, AlarmsAndWarningsAreSeenInTheTree)
{
    simulated().withEncoder({3},
                            [](SimulatedEscEncoder &encoder) { encoder.condition().batteryFlat = true; });
    ASSERT_TRUE(encoder(standing).start(
        WriteParameters{.values = {{Parameter::upperLimit, 1000}}, .previous = {}})); // it is above that
    advance(4000);
    EXPECT_EQ(cell(turning, StructureModel::stateColumn), QStringLiteral("alarm"));
    EXPECT_TRUE(
        model().indexOf(turning).data(Qt::ToolTipRole).toString().contains(QStringLiteral("battery")));
    EXPECT_EQ(cell(standing, StructureModel::stateColumn), QStringLiteral("warning"));
}

TEST_F(EscLineInWindow, ThePanelsShowAnEncoderOfTheLine)
{
    choose(standing);
    const auto &parameters = *window().findChild<ParameterPanel *>();
    auto *table = parameters.findChild<ParameterTable *>();
    ASSERT_TRUE(table->isVisible());
    EXPECT_GT(table->model()->rowCount(), 10);
    EXPECT_TRUE(actions().wizard->isEnabled());
    auto *device = window().findChild<QDockWidget *>(QStringLiteral("deviceDock"));
    device->show();
    device->raise();
    advance(50);
    const auto *page = device->findChild<QTextBrowser *>(QStringLiteral("devicePage"));
    EXPECT_TRUE(page->toPlainText().contains(QStringLiteral("T/R+"))) << "its pins";
    actions().wizard->trigger();
    EXPECT_EQ(window().findChild<ParameterWizard *>()->encoder(), &encoder(standing));
}

TEST_F(EscLineInWindow, WhatIsOfWordsAloneIsNotForItAndTheWindowSaysWhy)
{
    choose(standing);
    actions().openMonitor->trigger();
    advance(50);
    EXPECT_TRUE(monitors().cards().empty()) << "with 5 chosen nobody may write to another one";
    const auto *why = monitors().findChild<EmptyState *>();
    bool isSaidThere = false;
    for (const auto *label : why->findChildren<QLabel *>())
        isSaidThere = isSaidThere || label->text().contains(QStringLiteral("esc:05 has no words"));
    EXPECT_TRUE(isSaidThere);
    EXPECT_FALSE(actions().zeroOut->isEnabled());
    EXPECT_FALSE(actions().cams->isEnabled());
    EXPECT_TRUE(actions().cams->toolTip().contains(QStringLiteral("no cams")));
    for (const char *dock : {"traceDock", "sequenceDock"}) {
        auto *panel = window().findChild<QDockWidget *>(QLatin1String(dock));
        panel->raise();
        advance(5);
        bool isSaid = false;
        for (const auto *state : panel->findChildren<EmptyState *>())
            for (const auto *label : state->findChildren<QLabel *>())
                isSaid =
                    isSaid || (state->isVisible() && label->text().contains(QStringLiteral("serial line")));
        EXPECT_TRUE(isSaid) << dock;
    }
}

TEST_F(EscLineInWindow, ValuesAreReadAndTheDialTurns)
{
    choose(turning);
    for (auto *button : window().findChild<ParameterPanel *>()->findChildren<QPushButton *>())
        if (button->text() == QStringLiteral("&Read from encoder"))
            QTest::mouseClick(button, Qt::LeftButton);
    advance(3000);
    ASSERT_TRUE(encoder(turning).known(Parameter::steps));
    EXPECT_EQ(encoder(turning).known(Parameter::steps)->value, 8192);
    EXPECT_EQ(encoder(turning).known(Parameter::measuringRange)->value, 33'554'432);
}

TEST_F(EscLineInWindow, ThePanelTellsBitsAndWhatIsHexadecimal)
{
    choose(standing);
    auto &panel = *window().findChild<ParameterPanel *>();
    for (auto *button : panel.findChildren<QPushButton *>())
        if (button->text() == QStringLiteral("&Read from encoder"))
            QTest::mouseClick(button, Qt::LeftButton);
    advance(4000);
    const QAbstractItemModel &values = *panel.findChild<ParameterTable *>()->model();
    const auto known = [&values](Parameter parameter) {
        for (int row = 0; row < values.rowCount(); ++row)
            if (values.index(row, 0).data().toString() == parameterName(parameter))
                return values.index(row, 1).data().toString();
        return QString();
    };
    EXPECT_EQ(known(Parameter::warnings), QStringLiteral("8000h (standstill)"));
    EXPECT_EQ(known(Parameter::alarms), QStringLiteral("0000h (none)"));
    EXPECT_TRUE(known(Parameter::operatingParameters).contains(QStringLiteral("h (")));
    EXPECT_EQ(known(Parameter::scalingFactor), QStringLiteral("20000000h (1)"));
    EXPECT_TRUE(known(Parameter::serialNumber).endsWith(QStringLiteral("h)")))
        << known(Parameter::serialNumber).toStdString();
}

TEST_F(EscLineInWindow, WarningBytesAreSwappedForOneEncoderAndTheRawDigitsStay)
{
    choose(standing);
    ASSERT_TRUE(encoder(standing).start(ReadParameters{{Parameter::warnings}}));
    advance(1000);
    ASSERT_TRUE(lineActions().swapWarningBytes->isEnabled());
    ASSERT_FALSE(lineActions().swapWarningBytes->isChecked());
    lineActions().swapWarningBytes->trigger();
    advance(2000);
    EXPECT_EQ(encoder(standing).latest().warnings, 0x0080);
    const QAbstractItemModel &values = *window().findChild<ParameterTable *>()->model();
    QStringList shownValues;
    for (int row = 0; row < values.rowCount(); ++row)
        shownValues << values.index(row, 1).data().toString();
    EXPECT_EQ(shownValues.filter(QStringLiteral("8000h, bytes swapped 0080h")).size(), 1);

    choose(turning);
    EXPECT_FALSE(lineActions().swapWarningBytes->isChecked());
    EXPECT_NE(encoder(turning).latest().warnings, 0x0080);
    choose(standing);
    EXPECT_TRUE(lineActions().swapWarningBytes->isChecked());
    choose(test::fraba);
    EXPECT_FALSE(lineActions().swapWarningBytes->isEnabled());
}

// The steps bring along the scaling factor, in the format the line is set to: 3600 / 8192 with 24 fraction
// bits.
TEST_F(EscLineInWindow, TheReviewShowsTheRequestsThatAreSent)
{
    choose(standing);
    line().setFractionBits(24);
    ASSERT_TRUE(encoder(standing).start(ReadParameters{encoder(standing).device().readableValues()}));
    advance(3000);
    window().findChild<WantedValues *>()->set(standing, Parameter::steps, 3600);
    auto &panel = *window().findChild<ParameterPanel *>();
    for (auto *button : panel.findChildren<QPushButton *>())
        if (button->text() == QStringLiteral("&Write…"))
            QTest::mouseClick(button, Qt::LeftButton);
    advance(50);
    const QAbstractItemModel *review = nullptr;
    for (const auto *table : panel.findChildren<QTableView *>())
        if (table->accessibleName() == QStringLiteral("What will be written"))
            review = table->model();
    ASSERT_NE(review, nullptr);
    ASSERT_EQ(review->rowCount(), 2);
    EXPECT_EQ(review->headerData(3, Qt::Horizontal).toString(), QStringLiteral("Request"));
    EXPECT_EQ(review->index(0, 2).data().toString(), QLocale().toString(3600));
    EXPECT_EQ(review->index(1, 2).data().toString(), QStringLiteral("00708000h (0.439453125)"));
    QStringList shownRequests;
    for (int row = 0; row < 2; ++row)
        shownRequests.append(review->index(row, 3).data().toString());
    EXPECT_EQ(shownRequests.back(), QStringLiteral("05GF00708000"));

    QStringList sent;
    QObject::connect(&line(), &EscLineSession::passed, &panel, [&sent](const esc::EscLineRow &row) {
        if (row.kind == esc::EscLineRow::Kind::sent && row.bytes.contains("05G"))
            sent.append(QString::fromLatin1(row.bytes.mid(1).trimmed()));
    });
    QTest::mouseClick(panel.findChild<QPushButton *>(QStringLiteral("confirmWrite")), Qt::LeftButton);
    advance(5000);
    EXPECT_EQ(sent, shownRequests);
}

TEST_F(EscLineInWindow, TheReviewSaysWhatCannotBeWrittenAndWhy)
{
    choose(standing);
    auto &wanted = *window().findChild<WantedValues *>();
    wanted.set(standing, Parameter::revolutions, 16);
    wanted.set(standing, Parameter::measuringRange, 200'000);
    auto &panel = *window().findChild<ParameterPanel *>();
    for (auto *button : panel.findChildren<QPushButton *>())
        if (button->text() == QStringLiteral("&Write…"))
            QTest::mouseClick(button, Qt::LeftButton);
    advance(50);
    QStringList said;
    for (const auto *message : panel.findChildren<InlineMessage *>())
        if (message->isVisibleTo(&panel))
            said << message->sentence();
    EXPECT_EQ(said.filter(QStringLiteral("200000 is out of range")).size(), 1)
        << said.join(u'\n').toStdString();
    EXPECT_FALSE(panel.findChild<QPushButton *>(QStringLiteral("confirmWrite"))->isEnabled());
    for (const auto *label : panel.findChildren<QLabel *>())
        EXPECT_FALSE(label->text().contains(QStringLiteral("There is nothing to write")));
}

TEST_F(EscLineInWindow, AnAddressThatAnotherEncoderHasIsToldWhileItIsTyped)
{
    choose(standing);
    auto &panel = *window().findChild<ParameterPanel *>();
    auto &table = *panel.findChild<ParameterTable *>();
    panel.showParameter(Parameter::lineAddress);
    const auto saysTaken = [&] {
        QStringList said;
        for (const auto *label : panel.findChildren<QLabel *>())
            if (label->isVisibleTo(&panel))
                said << label->text();
        return !said.filter(QStringLiteral("Address 03h (3) is taken")).isEmpty();
    };
    const auto type = [&](const QString &text) {
        table.edit(table.currentIndex().siblingAtColumn(ParameterModel::wantedColumn));
        auto *field = qobject_cast<ValueInput *>(QApplication::focusWidget());
        ASSERT_NE(field, nullptr);
        field->selectAll();
        QTest::keyClicks(field, text);
    };
    const auto accept = [] {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QCoreApplication::processEvents(); // the field is left then
    };
    type(QStringLiteral("3"));
    EXPECT_TRUE(saysTaken()) << "before it is accepted";
    accept();
    EXPECT_TRUE(saysTaken()) << "as long as it is wanted";
    for (auto *button : panel.findChildren<QPushButton *>())
        if (button->text() == QStringLiteral("&Write…"))
            QTest::mouseClick(button, Qt::LeftButton);
    advance(50);
    EXPECT_TRUE(saysTaken());
    EXPECT_FALSE(panel.findChild<QPushButton *>(QStringLiteral("confirmWrite"))->isEnabled());
    QTest::keyClick(panel.findChild<WriteReview *>(), Qt::Key_Escape);
    type(QStringLiteral("4"));
    accept();
    EXPECT_FALSE(saysTaken());
}

// The encoder goes on counting 8192 steps per turn (manual, GS).
TEST_F(EscLineInWindow, StepsThatAreWrittenWithScalingOffAreSaidNotToAct)
{
    choose(turning);
    auto &panel = *window().findChild<ParameterPanel *>();
    const auto press = [&](const QString &text) {
        for (auto *button : panel.findChildren<QPushButton *>())
            if (button->text() == text)
                QTest::mouseClick(button, Qt::LeftButton);
    };
    const auto says = [&](const QString &text) {
        return std::ranges::any_of(panel.findChildren<QLabel *>(), [&](const QLabel *label) {
            return label->isVisibleTo(&panel) && label->text().contains(text);
        });
    };
    const auto *dial = window().findChild<CodeDisc *>();
    const auto rpm = [&] { return dial->state().rpm.value_or(0); };
    press(QStringLiteral("&Read from encoder"));
    advance(5000);
    const double before = rpm();
    EXPECT_NE(before, 0);

    window().findChild<WantedValues *>()->set(turning, Parameter::steps, 1000);
    press(QStringLiteral("&Write…"));
    advance(50);
    EXPECT_TRUE(says(QStringLiteral("Scaling is off")));
    std::vector<Message> messages;
    QObject::connect(&line(), &EscLineSession::messaged, &panel,
                     [&](const Message &message) { messages.push_back(message); });
    QTest::mouseClick(panel.findChild<QPushButton *>(QStringLiteral("confirmWrite")), Qt::LeftButton);
    advance(6000);
    ASSERT_EQ(encoder(turning).known(Parameter::steps)->value, 1000);
    EXPECT_TRUE(says(QStringLiteral("Steps, Scaling factor written and read back. Scaling is off")));
    EXPECT_EQ(std::ranges::count(messages, MessageId::writtenUnscaled, &Message::id), 1);
    EXPECT_EQ(std::ranges::count(messages, MessageId::parametersWritten, &Message::id), 0);
    EXPECT_NEAR(rpm(), before, 0.5) << "the shaft turns as before";

    ASSERT_TRUE(encoder(turning).start(WriteParameters{.values = {{Parameter::scaling, 1}}, .previous = {}}));
    advance(5000);
    EXPECT_NEAR(rpm(), before, 0.5);
}

// A factor that the user gives is not replaced by a computed one, even if it is there already.
TEST_F(EscLineInWindow, AGivenFactorIsInTheReview)
{
    choose(standing);
    ASSERT_TRUE(encoder(standing).start(ReadParameters{encoder(standing).device().readableValues()}));
    advance(3000);
    const auto known = encoder(standing).known(Parameter::scalingFactor);
    ASSERT_TRUE(known);
    const WritePlan plan = planWrite(
        encoder(standing), {.wanted = {{Parameter::steps, 1000}, {Parameter::scalingFactor, known->value}}});
    ASSERT_EQ(plan.rows.size(), 2u);
    EXPECT_EQ(plan.rows[1].wanted, (ParameterValue{Parameter::scalingFactor, known->value}));
    EXPECT_EQ(plan.rows[1].step->line, "05GF20000000");
}

// Manual, GR: "Number of revolutions is 4096". Wanted revolutions are written again with the steps.
TEST_F(EscLineInWindow, RevolutionsThatAreWantedGoAlongWithTheSteps)
{
    choose(standing);
    ASSERT_TRUE(encoder(standing).start(ReadParameters{encoder(standing).device().readableValues()}));
    advance(3000);
    const auto known = encoder(standing).known(Parameter::revolutions);
    ASSERT_TRUE(known);
    const WritePlan plan = planWrite(
        encoder(standing), {.wanted = {{Parameter::steps, 1000}, {Parameter::revolutions, known->value}}});
    ASSERT_EQ(plan.rows.size(), 3u);
    EXPECT_EQ(plan.rows[1].wanted, (ParameterValue{Parameter::revolutions, known->value}));
    EXPECT_EQ(std::ranges::count(plan.notes, ValueNote::Id::revolutionsSetAlong, &ValueNote::id), 0);
}

TEST_F(EscLineInWindow, WatchAndOperateAreEachBussOwn)
{
    const auto modeOf = [this](BusId bus) {
        return model().indexOf(bus).siblingAtColumn(StructureModel::positionColumn).data().toString();
    };
    choose(standing);
    actions().watch->trigger();
    advance(100);
    EXPECT_FALSE(line().isOperating());
    EXPECT_TRUE(bus().isOperating());
    EXPECT_TRUE(actions().watch->isChecked());
    EXPECT_EQ(modeOf(firstLine), QStringLiteral("Watch"));
    EXPECT_EQ(modeOf(firstBus), QStringLiteral("Operate"));
    choose(test::fraba);
    EXPECT_TRUE(actions().operate->isChecked()) << "of the chosen bus";
    actions().watch->trigger();
    advance(100);
    EXPECT_FALSE(bus().isOperating());
    choose(standing);
    actions().operate->trigger();
    advance(100);
    EXPECT_TRUE(line().isOperating());
    EXPECT_FALSE(bus().isOperating());
}

TEST_F(EscLineInWindow, AlarmStopEndsWhatIsOnItsWayOnTheLine)
{
    ASSERT_TRUE(encoder(turning).start(ReadParameters{encoder(turning).device().readableValues()}));
    advance(33);
    ASSERT_TRUE(encoder(turning).runningJob());
    QTest::keyClick(&window(), Qt::Key_F12, Qt::ControlModifier);
    advance(200);
    EXPECT_FALSE(encoder(turning).runningJob());
}

TEST_F(EscLineInWindow, QuittingAsksForAJobOnTheLine)
{
    const WriteParameters job{.values = {{Parameter::upperLimit, 1000}}, .previous = {}};
    ASSERT_TRUE(encoder(standing).start(job, Pace::byHand));
    advance(500);
    ASSERT_TRUE(encoder(standing).runningJob());
    actions().quit->trigger();
    advance(500);
    EXPECT_FALSE(encoder(standing).runningJob()) << "nothing was taken: it ended by itself";
    EXPECT_FALSE(window().isVisible());
}

TEST_F(EscLineInWindow, OfAnotherAddressItStaysChosen)
{
    choose(standing);
    ASSERT_TRUE(
        encoder(standing).start(WriteParameters{.values = {{Parameter::lineAddress, 7}}, .previous = {}}));
    advance(4000);
    const Place now = placeOnLine({7});
    ASSERT_NE(line().encoder(now), nullptr);
    EXPECT_EQ(window().findChild<StructureView *>()->current(), now);
    EXPECT_FALSE(model().indexOf(standing).isValid());
    EXPECT_EQ(cell(now, StructureModel::stateColumn), QStringLiteral("ok"));
}

// Its new address is among what is wanted, as in the parameter panel.
TEST_F(EscLineInWindow, WrittenAsWantedItStaysChosenUnderItsNewAddress)
{
    choose(standing);
    for (const std::uint8_t wanted : {std::uint8_t{7}, std::uint8_t{9}}) {
        const auto before = window().findChild<StructureView *>()->current();
        ASSERT_TRUE(before);
        window().findChild<WantedValues *>()->set(*before, Parameter::lineAddress, wanted);
        ASSERT_TRUE(encoder(*before).start(
            WriteParameters{.values = {{Parameter::lineAddress, wanted}}, .previous = {}}));
        advance(4000);
        EXPECT_EQ(window().findChild<StructureView *>()->current(), placeOnLine({wanted}));
    }
}

TEST_F(EscLineInWindow, WhatAJobHasSetIsNotSaidAnyLongerAfterAWriteByHand)
{
    choose(standing);
    auto &panel = *window().findChild<ParameterPanel *>();
    const auto *said = panel.findChild<InlineMessage *>(QStringLiteral("panelMessage"));
    ASSERT_NE(said, nullptr);
    ASSERT_TRUE(encoder(standing).start(SetPreset{5'000}));
    advance(4000);
    EXPECT_TRUE(said->sentence().contains(QStringLiteral("Position: 5000")))
        << said->sentence().toStdString();
    line().send({.to = {5}, .command = esc::Command::writePreset, .data = 6'000});
    advance(1000);
    EXPECT_EQ(encoder(standing).latest().position, 6'000);
    EXPECT_TRUE(said->isHidden()) << said->sentence().toStdString();
}

// Only the first press of a held key is meant.
TEST_F(EscLineInWindow, EnterHeldInTheFieldOfThePositionSetsNothing)
{
    choose(standing);
    const auto before = encoder(standing).latest().position;
    auto &panel = *window().findChild<ParameterPanel *>();
    for (QAction *action : panel.findChildren<QAction *>())
        if (action->text() == QStringLiteral("&Set the position…"))
            action->trigger();
    auto *field = panel.findChild<ValueInput *>(QStringLiteral("toldValue"));
    ASSERT_NE(field, nullptr);
    QTest::keyClicks(field, QStringLiteral("6000"));
    QTest::keyPress(field, Qt::Key_Return);
    advance(50);
    const auto *set = panel.findChild<QPushButton *>(QStringLiteral("confirmPreset"));
    ASSERT_TRUE(set->isVisible());
    QTest::qWait(QApplication::doubleClickInterval() + 50);
    for (int repeats = 0; repeats < 10; ++repeats) {
        QKeyEvent repeat(QEvent::KeyPress, Qt::Key_Return, {}, QStringLiteral("\r"), true);
        QApplication::sendEvent(QApplication::focusWidget(), &repeat);
        advance(1'000);
    }
    EXPECT_TRUE(set->isVisible());
    EXPECT_EQ(encoder(standing).latest().position, before);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    advance(4'000);
    EXPECT_EQ(encoder(standing).latest().position, 6'000);
}

TEST_F(EscLineInWindow, TheButtonsOfThePanelAreInTheSamePlaceForEachEncoder)
{
    const auto top = [this] {
        const auto *write = window().findChild<QPushButton *>(QStringLiteral("writeParameters"));
        return write->mapTo(&window(), QPoint()).y();
    };
    choose(standing);
    const int ofLine = top();
    choose(test::fraba);
    EXPECT_EQ(top(), ofLine);
    choose(test::baumer);
    EXPECT_EQ(top(), ofLine) << "it says in two lines that it cannot be read";
}

// The wizard writes them in one job and sets the position in another.
TEST_F(EscLineInWindow, ThePanelTellsAllThatTheWizardDid)
{
    const auto message = [this] {
        return window()
            .findChild<ParameterPanel *>()
            ->findChild<InlineMessage *>(QStringLiteral("panelMessage"))
            ->sentence();
    };
    const auto click = [this](const char *button) {
        const auto all =
            window().findChild<ParameterWizard *>()->findChildren<QAbstractButton *>(QLatin1String(button));
        ASSERT_FALSE(all.empty()) << button;
        ASSERT_TRUE(all.front()->isVisible() && all.front()->isEnabled()) << button;
        all.front()->click();
        advance(50);
    };
    choose(standing);
    window().findChild<WantedValues *>()->set(standing, Parameter::upperLimit, 0x2000);
    actions().wizard->trigger();
    click("wizardNext");
    click("readAll");
    advance(4000);
    click("wizardNext");
    click("wizardNext");
    click("initialisePreset");
    auto *position = window().findChild<QLineEdit *>(QStringLiteral("positionToSet"));
    QTest::keyClicks(position, QStringLiteral("1000"));
    click("wizardNext");
    click("byItself");
    click("wizardNext");
    advance(5000);
    ASSERT_FALSE(window().findChild<ParameterWizard *>()->isBusy());
    EXPECT_TRUE(message().contains(parameterName(Parameter::upperLimit))) << message().toStdString();
    EXPECT_TRUE(message().contains(QStringLiteral("EEPROM writes: 2."))) << message().toStdString();
    EXPECT_TRUE(message().contains(QStringLiteral("Position: %1.").arg(QLocale().toString(1000))))
        << message().toStdString();
}

TEST_F(EscLineInWindow, ItsMessagesStandWithThePlaces)
{
    simulated().withEncoder({5}, [](SimulatedEscEncoder &encoder) { encoder.condition().mute = true; });
    advance(3000);
    bool isTold = false;
    for (int row = 0; row < shown->messages().rowCount(); ++row)
        isTold = isTold || shown->messages().index(row, MessageModel::placeColumn).data().toString() ==
                               QStringLiteral("esc:05");
    EXPECT_TRUE(isTold);
}

TEST_F(EscLineInWindow, TheLineWorksWhileTheRingIsNotConnected)
{
    ringActions().disconnectBus->trigger();
    advance(100);
    ASSERT_FALSE(bus().isOpen());
    choose(standing);
    EXPECT_TRUE(actions().alarmStop->isEnabled());
    EXPECT_TRUE(actions().operate->isEnabled());
    actions().wizard->trigger();
    EXPECT_EQ(window().findChild<ParameterWizard *>()->encoder(), &encoder(standing));
    ringActions().connectBus->trigger();
    advance(100);
    EXPECT_EQ(window().findChild<StructureView *>()->current(), standing) << "it stays chosen";
}

TEST_F(EscLineInWindow, WhenTheLineGoesItsEncodersGoFromEveryView)
{
    choose(standing);
    shown->line().close();
    advance(100);
    EXPECT_EQ(model().rowCount(), 1);
    EXPECT_EQ(window().findChild<StructureView *>()->current(), test::fraba);
    shown->line().openTraining();
    advance(200);
    EXPECT_EQ(model().rowCount(), 2);
    EXPECT_EQ(cell(standing, StructureModel::stateColumn), QStringLiteral("ok"));
}

} // namespace
} // namespace codewheel
