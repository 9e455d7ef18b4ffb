// SPDX-License-Identifier: GPL-3.0-or-later
// The parameter panel on the training bus, in virtual time, with mouse and keys.
#include "bus/buses.h"
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/app/question.h"
#include "tests/support/model_tester.h"
#include "tests/support/places.h"
#include "tests/widgets/training_bus_session.h"
#include "vocabulary/refusal_text.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/look/role_label.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/parameters/value_input.h"
#include "widgets/parameters/write_review.h"
#include "widgets/project/project_document.h"

#include <QAbstractButton>
#include <QAbstractItemModel>
#include <QAccessible>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QCoreApplication>
#include <QDate>
#include <QDateTime>
#include <QEvent>
#include <QFontMetrics>
#include <QHeaderView>
#include <QLabel>
#include <QLatin1Char>
#include <QMenu>
#include <QModelIndex>
#include <QPoint>
#include <QPointer>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QTime>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class Parameters : public testing::Test
{
protected:
    Parameters()
    {
        EXPECT_TRUE(bus.open(RingSession::Start::operating));
        bus.encoder(fraba)->tell(Parameter::startUpMode, 1); // position mode
        bus.advance(10);
        panel.resize(290, 480);
        panel.show();
        panel.setEncoder(bus.encoder(fraba));
    }

    QAbstractItemModel &model() { return *table().model(); }
    ParameterTable &table() { return *panel.findChild<ParameterTable *>(); }
    QString textAt(Parameter parameter, int column)
    {
        return indexOf(parameter, column).data(Qt::AccessibleTextRole).toString();
    }
    QModelIndex indexOf(Parameter parameter, int column)
    {
        for (int row = 0; row < model().rowCount(); ++row)
            if (model().index(row, ParameterModel::nameColumn).data().toString() == parameterName(parameter))
                return model().index(row, column);
        return {};
    }
    // One event closes a field, another deletes it.
    static void settle()
    {
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    void clickWanted(Parameter parameter)
    {
        const QModelIndex cell = indexOf(parameter, ParameterModel::wantedColumn);
        table().scrollTo(cell);
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, table().visualRect(cell).center());
    }
    void want(Parameter parameter, const QString &text)
    {
        clickWanted(parameter);
        auto *field = panel.findChild<ValueInput *>();
        ASSERT_NE(field, nullptr);
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        settle();
    }
    QAbstractButton *button(const QString &text)
    {
        for (auto *found : panel.findChildren<QAbstractButton *>())
            if (found->isVisible() && plainLabel(found->text()) == text)
                return found;
        return nullptr;
    }
    void click(const QString &text)
    {
        QAbstractButton *found = button(text);
        ASSERT_NE(found, nullptr) << text.toStdString();
        ASSERT_TRUE(found->isEnabled()) << text.toStdString();
        QTest::mouseClick(found, Qt::LeftButton);
    }
    // At most 5 s of bus time.
    void finishJob(Place number = fraba)
    {
        for (int i = 0; i < 500 && bus.encoder(number)->runningJob(); ++i)
            bus.advance(10);
        ASSERT_FALSE(bus.encoder(number)->runningJob());
    }
    QString message() { return panel.findChild<InlineMessage *>(QStringLiteral("panelMessage"))->sentence(); }

    const Catalog catalog = Catalog::builtIn();
    TrainingBus training = makeTrainingBus(catalog);
    RingSession bus{std::move(training.link), catalog, QDateTime(QDate(2026, 3, 2), QTime(14, 2))};
    ProjectDocument project;
    WantedValues wanted{project};
    Buses buses;
    ParameterPanel panel{buses, wanted};
};

TEST_F(Parameters, WithoutAnEncoderItSaysWhatBelongsHere)
{
    panel.setEncoder(nullptr);
    EXPECT_FALSE(table().isVisible());
    EXPECT_EQ(button(QStringLiteral("Write…")), nullptr);
}

TEST_F(Parameters, AnEncoderThatOnlyTellsItsPositionSaysSo)
{
    panel.setEncoder(bus.encoder("3.0"_ring));
    EXPECT_FALSE(table().isVisible());
    const auto texts = [this] {
        QStringList shown;
        for (const QLabel *label : panel.findChildren<QLabel *>())
            if (label->isVisible() && !label->text().isEmpty())
                shown += label->text();
        return shown;
    };
    EXPECT_EQ(texts(),
              (QStringList{QStringLiteral("3.0 has no parameters here"),
                           QStringLiteral("The FRABA OCD-IB K1 has no OUT word. It only sends its position: "
                                          "nothing can be read from it or written to it.")}));
    panel.setEncoder(bus.encoder(fraba));
    EXPECT_TRUE(table().isVisible());
    panel.setEncoder(nullptr);
    EXPECT_TRUE(texts().contains(QStringLiteral("No encoder is chosen")));
}

TEST_F(Parameters, UnknownIsShownAsUnknownAndNeverAsADefault)
{
    const test::ModelTester tester(model());
    EXPECT_EQ(textAt(Parameter::steps, ParameterModel::knownColumn), QStringLiteral("unknown not read yet"));
    EXPECT_EQ(textAt(Parameter::steps, ParameterModel::wantedColumn), QStringLiteral("unchanged"));
    const QModelIndex readOnly = indexOf(Parameter::serialNumber, ParameterModel::wantedColumn);
    EXPECT_EQ(readOnly.data(Qt::AccessibleTextRole), QStringLiteral("read only"));
    EXPECT_EQ(readOnly.data(ParameterModel::detailRole).toString(), QString()) << "the heading says so";
    const QString tip =
        indexOf(Parameter::steps, ParameterModel::nameColumn).data(Qt::ToolTipRole).toString();
    EXPECT_TRUE(tip.contains(QStringLiteral("Factory setting: 8192"))) << tip.toStdString();
}

// Words sent elsewhere are confirmed, but not read back.
TEST_F(Parameters, WhatASequenceWroteIsNotSaidToBeReadBack)
{
    bus.encoder(fraba)->tell(Parameter::multiTurnAndStepsMinusOne, 2);
    ASSERT_TRUE(bus.encoder(fraba)->start(SendWords{.words = {0x0600'0003, 0x8000'0000, 0x0000'0000}}));
    bus.advance(100);
    EXPECT_TRUE(message().startsWith(QStringLiteral("Direction written, confirmed and active.")))
        << message().toStdString();
}

TEST_F(Parameters, TheRegistersOfTheBusChipAreFoldedAwayUntilOpened)
{
    const test::ModelTester tester(model());
    const QString closed = QStringLiteral("Registers of the bus chip, closed");
    const int rows = model().rowCount();
    const auto head = [this] { // the last row apart from the registers
        for (int row = model().rowCount() - 1; row >= 0; --row)
            if (model()
                    .index(row, 0)
                    .data(Qt::AccessibleTextRole)
                    .toString()
                    .startsWith(QStringLiteral("Registers")))
                return model().index(row, 0);
        return QModelIndex();
    };
    ASSERT_EQ(head().row(), rows - 1);
    EXPECT_EQ(head().data(Qt::AccessibleTextRole).toString(), closed);
    table().scrollTo(head());
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, table().visualRect(head()).center());
    EXPECT_EQ(model().rowCount(), rows + 16);
    click(QStringLiteral("Read from encoder"));
    finishJob();
    EXPECT_TRUE(textAt(Parameter::of(u"opc-register-0"), ParameterModel::knownColumn)
                    .startsWith(QStringLiteral("0237h")))
        << textAt(Parameter::of(u"opc-register-0"), ParameterModel::knownColumn).toStdString();
    table().setFocus();
    table().setCurrentIndex(head());
    QTest::keyClick(&table(), Qt::Key_Return);
    EXPECT_EQ(model().rowCount(), rows);
    EXPECT_EQ(head().data(Qt::AccessibleTextRole).toString(), closed);
}

TEST_F(Parameters, WithoutOpeningThemTheRegistersAreNotRead)
{
    click(QStringLiteral("Read from encoder"));
    finishJob();
    EXPECT_TRUE(bus.encoder(fraba)->known(Parameter::temperature));
    EXPECT_FALSE(bus.encoder(fraba)->known(Parameter::of(u"opc-register-0")));
}

TEST_F(Parameters, AllColumnsFitTheNarrowDock)
{
    panel.resize(panel.minimumSizeHint().width(), 300);
    settle();
    EXPECT_EQ(table().horizontalScrollBar()->value(), 0);
    EXPECT_EQ(table().horizontalHeader()->length(), table().viewport()->width());
}

TEST_F(Parameters, AJobThatEndsBadlyAfterOthersTellsWhatTheyHaveDone)
{
    Outcome written;
    written.eepromWrites = 1;
    written.written = {{Parameter::steps, 255}};
    DoneJobs before;
    before.add({}, written);
    EncoderSession &encoder = *bus.encoder(fraba);
    const auto job = encoder.start(SetPreset{}, Pace::byHand);
    ASSERT_TRUE(job);
    panel.takeFollowing({&encoder, *job, before});
    encoder.cancel(OnCancel::restorePrevious);
    finishJob();
    EXPECT_TRUE(message().contains(
        QStringLiteral("Done before that: Steps written, confirmed and active. EEPROM writes: 1.")))
        << message().toStdString();
}

TEST_F(Parameters, AFieldOfTheTableIsAsWideAsItsTexts)
{
    for (const Parameter parameter : {Parameter::direction, Parameter::zeroOffset}) {
        clickWanted(parameter);
        const QWidget *field = table().indexWidget(table().currentIndex());
        ASSERT_NE(field, nullptr);
        EXPECT_GE(field->width(), field->minimumSizeHint().width());
        EXPECT_GE(field->x(), table().columnViewportPosition(ParameterModel::knownColumn));
        QTest::keyClick(table().viewport(), Qt::Key_Escape);
        settle();
    }
}

TEST_F(Parameters, AValueIsSmallRatherThanBrokenWithinAWord)
{
    const QModelIndex cell = indexOf(Parameter::steps, ParameterModel::knownColumn);
    const int usual = table().rowHeight(cell.row());
    const int room = QFontMetrics(textFont(TextSize::small)).horizontalAdvance(cell.data().toString()) + 1;
    table().horizontalHeader()->setSectionResizeMode(ParameterModel::knownColumn, QHeaderView::Fixed);
    table().setColumnWidth(ParameterModel::knownColumn, room + 2 * grid::unit);
    settle();
    EXPECT_EQ(table().rowHeight(cell.row()), usual);
}

TEST_F(Parameters, AKnownValueTooLongForItsColumnHasTheRoomOfTheWantedOneIfThereIsNone)
{
    const auto span = [this](Parameter parameter) {
        const QModelIndex known = indexOf(parameter, ParameterModel::knownColumn);
        return table().columnSpan(known.row(), known.column());
    };
    EXPECT_EQ(span(Parameter::startUpMode), 2) << "1 (position, as K3)";
    EXPECT_EQ(span(Parameter::serialNumber), 1) << "it stands below its heading";
    EXPECT_EQ(span(Parameter::steps), 1);
    panel.resize(900, 480);
    settle();
    EXPECT_EQ(span(Parameter::startUpMode), 1);
}

TEST_F(Parameters, ReadsOnlyWhenAskedAndSaysHowItKnows)
{
    const test::ModelTester tester(model());
    EXPECT_TRUE(devicesWithOut(bus).empty());
    click(QStringLiteral("Read from encoder"));
    finishJob();
    EXPECT_TRUE(
        textAt(Parameter::steps, ParameterModel::knownColumn).startsWith(QStringLiteral("8192 read 14:02")))
        << textAt(Parameter::steps, ParameterModel::knownColumn).toStdString();
    EXPECT_TRUE(message().startsWith(QStringLiteral("Values read:"))) << message().toStdString();
}

TEST_F(Parameters, ARefusalGoesWhenSendingIsAllowed)
{
    const auto &message = *panel.findChild<InlineMessage *>(QStringLiteral("panelMessage"));
    bus.setOperate(false);
    bus.advance(2);
    QTest::mouseClick(button(QStringLiteral("Read from encoder")), Qt::LeftButton);
    EXPECT_TRUE(message.isVisible());
    bus.setOperate(true);
    bus.advance(2);
    EXPECT_FALSE(message.isVisible());
}

TEST_F(Parameters, AnEncoderWithoutReadOutSaysSoInsteadOfOfferingIt)
{
    panel.setEncoder(bus.encoder(baumer));
    QAbstractButton *read = button(QStringLiteral("Read from encoder"));
    ASSERT_NE(read, nullptr);
    EXPECT_FALSE(read->isEnabled());
    EXPECT_TRUE(read->accessibleDescription().contains(QStringLiteral("has no read-out")));
}

TEST_F(Parameters, TypingIsCheckedAtTheFieldAndBadInputStaysThere)
{
    clickWanted(Parameter::revolutions);
    QPointer<ValueInput> field = panel.findChild<ValueInput *>();
    ASSERT_NE(field, nullptr);
    QTest::keyClicks(field, QStringLiteral("4097"));
    EXPECT_TRUE(message().contains(QStringLiteral("out of range"))) << message().toStdString();
    QTest::keyClick(field, Qt::Key_Return);
    settle();
    ASSERT_TRUE(field && field->isVisible());
    EXPECT_EQ(wanted.value(fraba, Parameter::revolutions), std::nullopt);
    click(QStringLiteral("Write…"));
    EXPECT_FALSE(panel.findChild<WriteReview *>()->isVisible());
    ASSERT_TRUE(field && field->isVisible());
    QTest::keyClick(field, Qt::Key_Backspace);
    EXPECT_EQ(message(), QString());
    QTest::keyClick(field, Qt::Key_Return);
    settle();
    EXPECT_EQ(wanted.value(fraba, Parameter::revolutions), 409);
}

TEST_F(Parameters, EscapeGivesBadInputUp)
{
    clickWanted(Parameter::steps);
    auto *field = panel.findChild<ValueInput *>();
    ASSERT_NE(field, nullptr);
    QTest::keyClicks(field, QStringLiteral("none"));
    EXPECT_NE(message(), QString());
    QTest::keyClick(field, Qt::Key_Escape);
    settle();
    EXPECT_EQ(message(), QString());
    EXPECT_EQ(wanted.value(fraba, Parameter::steps), std::nullopt);
}

TEST_F(Parameters, AFieldLeftByReturnOrEscapeIsClosedOnce)
{
    static QStringList warnings;
    const QtMessageHandler before = qInstallMessageHandler(
        [](QtMsgType, const QMessageLogContext &, const QString &text) { warnings << text; });
    panel.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&panel));
    want(Parameter::steps, QStringLiteral("255"));
    clickWanted(Parameter::revolutions);
    QTest::keyClick(panel.findChild<ValueInput *>(), Qt::Key_1);
    QTest::keyClick(panel.findChild<ValueInput *>(), Qt::Key_Escape);
    settle();
    qInstallMessageHandler(before);
    EXPECT_TRUE(warnings.filter(QStringLiteral("does not belong")).isEmpty())
        << warnings.join(u'\n').toStdString();
    EXPECT_EQ(wanted.values(fraba), (ParameterValues{{Parameter::steps, 255}}));
}

TEST_F(Parameters, WhatWasTypedForAnotherEncoderIsToldWithItsPlace)
{
    clickWanted(Parameter::steps);
    QTest::keyClicks(panel.findChild<ValueInput *>(), QStringLiteral("77"));
    panel.setEncoder(bus.encoder(baumer));
    EXPECT_EQ(message(), QStringLiteral("What was being typed for encoder 1.0 was not taken: Steps 77."));
}

TEST_F(Parameters, AWantedValueHasItsUnitLikeTheKnownOneBesideIt)
{
    want(Parameter::preset, QStringLiteral("5"));
    EXPECT_EQ(indexOf(Parameter::preset, ParameterModel::wantedColumn).data(), QStringLiteral("5 steps"));
}

TEST_F(Parameters, KeysAloneEnterOneValueAfterTheOther)
{
    table().setFocus();
    QTest::keyClick(&table(), Qt::Key_Return);
    auto *field = panel.findChild<ValueInput *>();
    ASSERT_NE(field, nullptr);
    QTest::keyClicks(field, QStringLiteral("FFh"));
    QTest::keyClick(field, Qt::Key_Tab);
    settle();
    field = panel.findChild<ValueInput *>();
    ASSERT_NE(field, nullptr);
    QTest::keyClicks(field, QStringLiteral("1"));
    QTest::keyClick(field, Qt::Key_Return);
    settle();
    EXPECT_EQ(wanted.values(fraba), (ParameterValues{{Parameter::steps, 255}, {Parameter::revolutions, 1}}));
}

TEST_F(Parameters, CopiesTheHandshakeOfTheSelectedRowsAsWordsOfAPlc)
{
    const auto copied = [this](Qt::KeyboardModifiers modifiers = Qt::ControlModifier | Qt::ShiftModifier) {
        QApplication::clipboard()->clear();
        QTest::keyClick(&table(), Qt::Key_C, modifiers);
        return QApplication::clipboard()->text();
    };
    panel.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&panel));
    table().setFocus();
    table().setCurrentIndex(indexOf(Parameter::revolutions, ParameterModel::wantedColumn));
    EXPECT_EQ(copied(), QString());
    const auto &says = *panel.findChild<InlineMessage *>(QStringLiteral("panelMessage"));
    EXPECT_TRUE(says.isVisible()) << "neither wanted nor known";
    bus.encoder(fraba)->tell(Parameter::multiTurnAndStepsMinusOne, 2);
    bus.encoder(fraba)->tell(Parameter::revolutions, 1);
    const QString revolutions = QStringLiteral("16#0400 16#0001\n16#8000 16#0000\n16#0000 16#0000\n");
    EXPECT_EQ(copied(), revolutions) << "known";
    EXPECT_FALSE(says.isVisible());
    want(Parameter::steps, QStringLiteral("255"));
    QTest::mouseClick(table().viewport(), Qt::LeftButton, Qt::ControlModifier,
                      table().visualRect(indexOf(Parameter::revolutions, 2)).center());
    EXPECT_EQ(copied(), QStringLiteral("16#0200 16#00FF\n") + revolutions) << "wanted and known";
    EXPECT_EQ(bus.channel(fraba)->out(), 0U) << "nothing is sent";
}

TEST_F(Parameters, DeleteLeavesAllSelectedParametersAlone)
{
    want(Parameter::steps, QStringLiteral("255"));
    want(Parameter::revolutions, QStringLiteral("1"));
    table().selectAll();
    QTest::keyClick(&table(), Qt::Key_Delete);
    EXPECT_TRUE(wanted.values(fraba).empty());
}

TEST_F(Parameters, ShowsOldNewAndTheExactWordBeforeItWrites)
{
    const test::ModelTester tester(model());
    click(QStringLiteral("Read from encoder"));
    finishJob();
    want(Parameter::steps, QStringLiteral("255"));
    want(Parameter::revolutions, QStringLiteral("1"));
    EXPECT_EQ(textAt(Parameter::steps, ParameterModel::wantedColumn), QStringLiteral("255 differs"));
    EXPECT_EQ(textAt(Parameter::revolutions, ParameterModel::wantedColumn), QStringLiteral("1 the same"));
    EXPECT_EQ(panel.findChild<RoleLabel *>()->word(), QStringLiteral("1 value differs"));

    click(QStringLiteral("Write…"));
    auto *review = panel.findChild<WriteReview *>()->findChild<ReviewTable *>();
    const test::ModelTester reviewTester(*review);
    ASSERT_EQ(review->rowCount(), 1);
    EXPECT_EQ(review->index(0, 1).data().toString(), QStringLiteral("8192"));
    EXPECT_EQ(review->index(0, 2).data().toString(), QStringLiteral("255"));
    EXPECT_EQ(review->index(0, 3).data().toString(), QStringLiteral("020000FF"));
    EXPECT_TRUE(devicesWithOut(bus).empty());

    click(QStringLiteral("Write this value"));
    finishJob();
    EXPECT_TRUE(
        message().startsWith(QStringLiteral("Steps written, active and read back. EEPROM writes: 1.")))
        << message().toStdString();
    EXPECT_EQ(bus.encoder(fraba)->eepromWrites(), 1);
    EXPECT_TRUE(textAt(Parameter::steps, ParameterModel::knownColumn).startsWith(QStringLiteral("255 read")));
    EXPECT_EQ(textAt(Parameter::steps, ParameterModel::wantedColumn), QStringLiteral("255 the same"));

    click(QStringLiteral("Write…"));
    EXPECT_EQ(review->rowCount(), 0);
    QTest::mouseClick(panel.findChild<WriteReview *>()->findChild<QCheckBox *>(), Qt::LeftButton, {},
                      QPoint(8, panel.findChild<WriteReview *>()->findChild<QCheckBox *>()->height() / 2));
    EXPECT_EQ(review->rowCount(), 2);
    click(QStringLiteral("Cancel"));
    EXPECT_TRUE(table().isVisible());
    EXPECT_EQ(bus.encoder(fraba)->eepromWrites(), 1);
}

TEST_F(Parameters, TheReviewSaysWhereAZeroOffsetShiftsThePosition)
{
    click(QStringLiteral("Read from encoder"));
    finishJob();
    want(Parameter::zeroOffset, QStringLiteral("30"));
    click(QStringLiteral("Write…"));
    const auto labels = panel.findChild<WriteReview *>()->findChildren<QLabel *>();
    EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel *label) {
        return label->isVisible() &&
               label->text().contains(QStringLiteral("This shifts the position: now 12345, then 12375."));
    }));
}

TEST_F(Parameters, TheReviewSaysThatAnotherDirectionShiftsThePosition)
{
    wanted.set(fraba, Parameter::direction, 4);
    settle();
    click(QStringLiteral("Write…"));
    const auto labels = panel.findChild<WriteReview *>()->findChildren<QLabel *>();
    EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel *label) {
        return label->isVisible() &&
               label->text().contains(QStringLiteral("This shifts the position, by how much is not known."));
    }));
}

TEST_F(Parameters, AValueIsToldAndTakenAsWanted)
{
    panel.setEncoder(bus.encoder(baumer));
    table().setCurrentIndex(indexOf(Parameter::steps, ParameterModel::wantedColumn));
    QMenu *menu = panel.findChild<QMenu *>(QStringLiteral("moreMenu"));
    menu->actions().at(0)->trigger();
    auto *field = panel.findChild<ValueInput *>(QStringLiteral("toldValue"));
    ASSERT_NE(field, nullptr);
    QTest::keyClicks(field, QStringLiteral("4096"));
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_TRUE(bus.encoder(baumer)->known(Parameter::steps));
    EXPECT_EQ(bus.encoder(baumer)->known(Parameter::steps)->evidence, Evidence::told);
    EXPECT_TRUE(
        textAt(Parameter::steps, ParameterModel::knownColumn).startsWith(QStringLiteral("4096 by hand")));
    menu->actions().at(2)->trigger();
    EXPECT_EQ(wanted.values(baumer), (ParameterValues{{Parameter::steps, 4096}}));
    menu->actions().at(3)->trigger();
    EXPECT_TRUE(wanted.values(baumer).empty());
}

TEST_F(Parameters, RunWithWhatItHasTellsWhatIsValidThen)
{
    click(QStringLiteral("Read from encoder"));
    finishJob();
    training.controls->setFault(TrainingFault::slowConfirmation, fraba.node, 1);
    want(Parameter::steps, QStringLiteral("255"));
    want(Parameter::revolutions, QStringLiteral("2"));
    click(QStringLiteral("Write…"));
    click(QStringLiteral("Write these 2 values"));
    ParameterValues confirmed;
    QObject::connect(bus.encoder(fraba), &EncoderSession::progressed, &panel,
                     [&](const Progress &progress) { confirmed = progress.confirmed; });
    for (int i = 0; i < 3000 && confirmed.empty(); ++i)
        bus.advance(1);
    click(QStringLiteral("Cancel"));
    click(QStringLiteral("Run with what it has"));
    finishJob();
    EXPECT_TRUE(message().startsWith(QStringLiteral("The job was cancelled. Valid now: Steps = 255.")))
        << message().toStdString();
    EXPECT_TRUE(message().contains(QStringLiteral("The encoder is in operation.")))
        << message().toStdString();
}

TEST_F(Parameters, CancelAsksHowToLeaveAnEncoderThatHasTakenSomething)
{
    click(QStringLiteral("Read from encoder"));
    finishJob();
    training.controls->setFault(TrainingFault::slowConfirmation, fraba.node, 1);
    want(Parameter::steps, QStringLiteral("255"));
    want(Parameter::revolutions, QStringLiteral("2"));
    click(QStringLiteral("Write…"));
    click(QStringLiteral("Write these 2 values"));
    ParameterValues confirmed;
    QObject::connect(bus.encoder(fraba), &EncoderSession::progressed, &panel,
                     [&](const Progress &progress) { confirmed = progress.confirmed; });
    for (int i = 0; i < 3000 && confirmed.empty(); ++i)
        bus.advance(1);
    ASSERT_EQ(confirmed, (ParameterValues{{Parameter::steps, 255}}));
    click(QStringLiteral("Cancel"));
    ASSERT_TRUE(bus.encoder(fraba)->runningJob());
    QAbstractButton *restore = button(QStringLiteral("Restore earlier values"));
    ASSERT_NE(restore, nullptr);
    settle();
    EXPECT_GE(restore->height(), restore->sizeHint().height()); // not squeezed by the table
    EXPECT_TRUE(restore->isEnabled());
    EXPECT_TRUE(button(QStringLiteral("Go on with the handshake"))->hasFocus()) << "it costs nothing";
    click(QStringLiteral("Leave in parameterization"));
    finishJob();
    EXPECT_EQ(bus.encoder(fraba)->latest().state, EncoderState::parameterization);
    EXPECT_EQ(message(),
              QStringLiteral("The job was cancelled. The encoder is in parameterization: it gives no "
                             "position until run is sent."));

    {
        const test::Question question([](QWidget &box) { QTest::keyClick(&box, Qt::Key_Return); });
        click(QStringLiteral("Send run"));
        EXPECT_TRUE(question.text().startsWith(QStringLiteral("Send run to 1.0?")));
        EXPECT_TRUE(question.text().contains(QStringLiteral("what it has taken, from here: Steps = 255")))
            << question.text().toStdString();
        EXPECT_TRUE(question.text().contains(QStringLiteral("it can jump")));
    }
    EXPECT_FALSE(bus.encoder(fraba)->runningJob()) << "the default is Cancel";
    const test::Question question = test::Question::answeredBy(QStringLiteral("Send run"));
    click(QStringLiteral("Send run"));
    finishJob();
    EXPECT_EQ(bus.encoder(fraba)->latest().state, EncoderState::operation);
}

TEST_F(Parameters, WhatCannotBeRestoredIsNotOffered)
{
    panel.setEncoder(bus.encoder(baumer));
    training.controls->setFault(TrainingFault::slowConfirmation, baumer.node, 1);
    want(Parameter::steps, QStringLiteral("255"));
    want(Parameter::revolutions, QStringLiteral("2"));
    click(QStringLiteral("Write…"));
    click(QStringLiteral("Write these 2 values"));
    bool hasTaken = false;
    QObject::connect(bus.encoder(baumer), &EncoderSession::progressed, &panel,
                     [&](const Progress &progress) { hasTaken = !progress.confirmed.empty(); });
    for (int i = 0; i < 3000 && !hasTaken; ++i)
        bus.advance(1);
    ASSERT_TRUE(hasTaken);
    click(QStringLiteral("Cancel"));
    ASSERT_NE(button(QStringLiteral("Restore earlier values")), nullptr);
    EXPECT_FALSE(button(QStringLiteral("Restore earlier values"))->isEnabled());
    EXPECT_FALSE(table().isVisible()) << "the question has its room";
    click(QStringLiteral("Go on with the handshake"));
    EXPECT_TRUE(table().isVisible());
    click(QStringLiteral("Cancel"));
    EXPECT_FALSE(table().isVisible());
    training.controls->setFault(TrainingFault::slowConfirmation, baumer.node, 0);
    finishJob(baumer);
    EXPECT_TRUE(table().isVisible()) << "there is nothing left to cancel";
    EXPECT_TRUE(message().startsWith(QStringLiteral("Steps, Revolutions written, confirmed and active.")))
        << message().toStdString();
}

TEST_F(Parameters, ARefusalStandsInThePanelAndNothingIsSent)
{
    want(Parameter::steps, QStringLiteral("255"));
    bus.setOperate(false);
    bus.advance(2);
    click(QStringLiteral("Write…"));
    click(QStringLiteral("Write this value"));
    EXPECT_TRUE(message().contains(QStringLiteral("Switch to Operate first"))) << message().toStdString();
    bus.advance(10);
    EXPECT_TRUE(devicesWithOut(bus).empty());
}

TEST_F(Parameters, TheReviewFollowsWhatComesToBeKnown)
{
    panel.setEncoder(bus.encoder(baumer));
    want(Parameter::steps, QStringLiteral("255"));
    click(QStringLiteral("Write…"));
    const auto *review = panel.findChild<WriteReview *>()->findChild<ReviewTable *>();
    ASSERT_EQ(review->rowCount(), 1);
    bus.encoder(baumer)->tell(Parameter::steps, 255);
    EXPECT_EQ(review->rowCount(), 0);
    EXPECT_FALSE(panel.findChild<QPushButton *>(QStringLiteral("confirmWrite"))->isEnabled());
}

TEST_F(Parameters, AnErrorOfTheEncoderStandsInThePanelWithAWayBack)
{
    panel.setEncoder(bus.encoder(baumer));
    want(Parameter::steps, QStringLiteral("33554431")); // in range, but finer than the encoder's steps
    click(QStringLiteral("Write…"));
    click(QStringLiteral("Write this value"));
    finishJob(baumer);
    EXPECT_TRUE(message().startsWith(QStringLiteral("Error 1: the encoder refused")))
        << message().toStdString();
    EXPECT_NE(button(QStringLiteral("Send run")), nullptr);
}

// By a loss of power here; it might be another master as well.
TEST_F(Parameters, AnEncoderThatIsBackInOperationIsNotSaidToBeInParameterization)
{
    ASSERT_TRUE(bus.encoder(fraba)->start(SendWords{.words = {0x0200'00FF}}));
    finishJob();
    ASSERT_TRUE(message().contains(QStringLiteral("The encoder is in parameterization")))
        << message().toStdString();
    ASSERT_NE(button(QStringLiteral("Send run")), nullptr);
    bus.channel(fraba)->stage(0);
    ASSERT_TRUE(bus.channel(fraba)->write());
    bus.advance(50);
    training.controls->powerCycle(fraba.node);
    bus.advance(5'000);
    ASSERT_EQ(bus.encoder(fraba)->latest().state, EncoderState::operation);
    EXPECT_FALSE(message().contains(QStringLiteral("parameterization"))) << message().toStdString();
    EXPECT_EQ(button(QStringLiteral("Send run")), nullptr);
}

TEST_F(Parameters, AConnectionThatEndsTakesItsEncoderAway)
{
    ASSERT_TRUE(bus.open(RingSession::Start::watching));
    EXPECT_EQ(model().rowCount(), 0);
    EXPECT_FALSE(table().isVisible());
}

TEST_F(Parameters, TheWizardIsAsked)
{
    const QSignalSpy asked(&panel, &ParameterPanel::wizardRequested);
    click(QStringLiteral("Wizard…"));
    EXPECT_EQ(asked.size(), 1);
}

TEST_F(Parameters, EveryControlHasANameAndATip)
{
    int checked = 0;
    for (auto *control : panel.findChildren<QAbstractButton *>()) {
        if (!control->isVisible() || control->inherits("QTableCornerButton"))
            continue;
        ++checked;
        const QString name = QAccessible::queryAccessibleInterface(control)->text(QAccessible::Name);
        EXPECT_FALSE(name.isEmpty());
        EXPECT_FALSE(control->toolTip().isEmpty()) << name.toStdString();
    }
    EXPECT_GE(checked, 4);
}

// The tree and the manual write it in hexadecimal.
TEST(ValueInput, AnAddressOfTwoDigitsSaysWhichNumberItIs)
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription *device = catalog.find(QStringLiteral("kuebler-esc-rs485"));
    ASSERT_NE(device, nullptr);
    ValueInput input(*device->find(Parameter::lineAddress));
    input.setValue(18);
    EXPECT_EQ(input.text(), QStringLiteral("12h"));
    for (const auto &[text, value] : {std::pair("12h", 18), std::pair("0Ch", 12), std::pair("0x0C", 12),
                                      std::pair("9", 9), std::pair("07", 7)}) {
        input.setText(QLatin1String(text));
        ASSERT_TRUE(input.value()) << text;
        EXPECT_EQ(*input.value(), value) << text;
    }
    input.setText(QStringLiteral("32")); // in no way
    ASSERT_FALSE(input.value());
    EXPECT_EQ(input.value().error().id, RefusalId::valueOutOfRange);
    input.setText(QStringLiteral("12"));
    ASSERT_FALSE(input.value());
    EXPECT_TRUE(refusalText(input.value().error()).contains(QStringLiteral("Write 12h or 0Ch.")))
        << refusalText(input.value().error()).toStdString();
}

// 20210007h tells whether the encoder counts steps minus 1.
TEST_F(Parameters, WhyStepsWrittenByHandStayUnknownIsSaid)
{
    ASSERT_TRUE(
        bus.encoder(fraba)->start(SendWords{.words = {0x0200'00FF, 0x0400'0001, 0x8000'0000, 0x0000'0000}}));
    bus.advance(100);
    ASSERT_FALSE(bus.encoder(fraba)->known(Parameter::steps));
    const auto tip = [this](Parameter parameter) {
        return indexOf(parameter, ParameterModel::knownColumn).data(Qt::ToolTipRole).toString();
    };
    EXPECT_TRUE(tip(Parameter::steps).contains(QStringLiteral("whether the encoder counts steps minus 1")))
        << tip(Parameter::steps).toStdString();
    EXPECT_FALSE(tip(Parameter::direction).contains(QStringLiteral("minus 1")));
    bus.encoder(fraba)->tell(Parameter::multiTurnAndStepsMinusOne, 2);
    EXPECT_FALSE(tip(Parameter::steps).contains(QStringLiteral("minus 1")));
}

TEST_F(Parameters, TheStateItWasLeftInIsToldOnlyAsLongAsItIsSeen)
{
    click(QStringLiteral("Read from encoder"));
    finishJob();
    const QString inOperation = QStringLiteral("The encoder is in operation.");
    ASSERT_TRUE(message().contains(inOperation)) << message().toStdString();
    bus.setRunning(false);
    bus.advance(10);
    EXPECT_FALSE(message().contains(inOperation)) << message().toStdString();
    EXPECT_TRUE(message().contains(QStringLiteral("Done before that: Values read")))
        << message().toStdString();
    bus.setRunning(true);
    bus.advance(50);
    EXPECT_TRUE(message().contains(inOperation)) << message().toStdString();
}

TEST_F(Parameters, WhatAnEncoderHasThatIsNotSeenIsNotKnown)
{
    click(QStringLiteral("Read from encoder"));
    finishJob();
    want(Parameter::steps, QStringLiteral("8192"));
    const auto notes = [this] {
        QString all;
        for (const QLabel *label : panel.findChild<WriteReview *>()->findChildren<QLabel *>())
            all += label->text();
        return all;
    };
    const QString isKnown = QStringLiteral("The encoder is known to have all wanted values.");
    click(QStringLiteral("Write…"));
    EXPECT_TRUE(notes().contains(isKnown)) << notes().toStdString();
    click(QStringLiteral("Cancel"));
    bus.setRunning(false);
    bus.advance(10);
    click(QStringLiteral("Write…"));
    EXPECT_FALSE(notes().contains(isKnown)) << notes().toStdString();
    EXPECT_TRUE(notes().contains(QStringLiteral("Whether it has them now is not known")))
        << notes().toStdString();
}

TEST_F(Parameters, NumbersAndNamesAreNotBrokenWithinAWordInTheNarrowDock)
{
    bus.encoder(fraba)->tell(Parameter::zeroOffset, 33'554'431);
    panel.resize(panel.minimumSizeHint().width(), 480);
    settle();
    const QFontMetrics small(textFont(TextSize::small));
    const auto expectWholeWords = [&](const QTableView &view, const QModelIndex &cell) {
        for (const QString &word : cell.data().toString().split(u' '))
            EXPECT_GE(view.columnWidth(cell.column()) - 2 * grid::unit, small.horizontalAdvance(word))
                << word.toStdString();
    };
    expectWholeWords(table(), indexOf(Parameter::zeroOffset, ParameterModel::knownColumn));
    want(Parameter::revolutions, QStringLiteral("2"));
    click(QStringLiteral("Write…"));
    settle();
    const auto &review = *panel.findChild<WriteReview *>()->findChild<QTableView *>();
    for (int column = 0; column < review.model()->columnCount(); ++column)
        expectWholeWords(review, review.model()->index(0, column));
    EXPECT_EQ(review.horizontalHeader()->length(), review.viewport()->width());
}

} // namespace
} // namespace codewheel
