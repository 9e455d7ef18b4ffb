// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/question.h"
#include "tests/support/model_tester.h"
#include "tests/support/old_file.h"
#include "tests/support/places.h"
#include "tests/widgets/transfer/transfer_test.h"
#include "vocabulary/refusal_text.h"
#include "widgets/job/account_view.h"
#include "widgets/look/inline_message.h"
#include "widgets/transfer/transfer_page.h"

#include <QAbstractItemModel>
#include <QClipboard>
#include <QCoreApplication>
#include <QFile>
#include <QGuiApplication>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QVariant>
#include <QWidget>

#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;
using test::onLoop;
using What = TransferChoice::What;

TEST(AccountViewTest, AnAccountWithoutRoomLeavesTheOldOne)
{
    AccountView view;
    Report report;
    report.title = QString(100, u'x');
    view.show(report, QStringLiteral("account"));
    test::OldFile old;
    EXPECT_FALSE(old.saveWithoutRoom([&](const QString &path) { return view.saveTo(path); }));
    EXPECT_TRUE(old.isThere());
    EXPECT_TRUE(view.findChild<InlineMessage *>()->sentence().endsWith(
        QLatin1String("was not saved: File too large. Choose another place.")));
}

class TransferPageTest : public test::TransferTest
{
protected:
    TransferPageTest()
    {
        QObject::connect(&page, &TransferPage::messaged, &page,
                         [this](const Message &message) { messages << messageText(message); });
        want(fraba, {{Parameter::steps, 255}});
        want(baumer, {{Parameter::steps, 4096}, {Parameter::coding, 6}});
        show(page);
        page.choose(What::write, fraba);
    }
    QAbstractItemModel &model() { return *find<QTableView>("transferTable")->model(); }
    QString cell(int row, int column) { return model().index(row, column).data().toString(); }
    int rowOf(const char *place)
    {
        for (int row = 0; row < model().rowCount(); ++row)
            if (cell(row, 0) == QLatin1String(place))
                return row;
        return -1;
    }
    // Presses Space on the check box of the encoder.
    void toggle(const char *place)
    {
        auto *table = find<QTableView>("transferTable");
        table->setCurrentIndex(model().index(rowOf(place), 0));
        table->setFocus();
        QTest::keyClick(table, Qt::Key_Space);
    }
    void write()
    {
        click("transferBegin");
        advanceWhileBusy(page);
    }

    std::vector<ValuesBefore> befores;
    QStringList messages;
    TransferPage page{session.buses, session.catalog, project, [this](Place) { return befores; }};
};

TEST_F(TransferPageTest, ShowsWhatDiffersEncoderByEncoder)
{
    const test::ModelTester tester(model());
    EXPECT_EQ(cell(0, 0), QStringLiteral("1.0"));
    EXPECT_EQ(cell(0, 1), QStringLiteral("FRABA OCD-IB K3"));
    EXPECT_EQ(cell(1, 1), QStringLiteral("Steps"));
    EXPECT_EQ(cell(1, 2), QStringLiteral("unknown"));
    EXPECT_EQ(cell(1, 3), QStringLiteral("255"));
    EXPECT_EQ(cell(1, 4), QStringLiteral("020000FF"));
    EXPECT_EQ(cell(1, 5), QStringLiteral("1"));
    EXPECT_EQ(text("transferSummary"), QStringLiteral("Encoders chosen: 2. EEPROM writes: at most 3."));
    page.choose(What::store, {});
    page.choose(What::clone, fraba);
    page.choose(What::write, fraba);
}

// Nobody tells the page: it follows its encoders.
TEST_F(TransferPageTest, WhatIsKnownSaysHowAndLooksOldWhileTheBusDoesNotRun)
{
    const auto toolTip = [&](int row) { return model().index(row, 2).data(Qt::ToolTipRole).toString(); };
    EXPECT_TRUE(toolTip(1).startsWith(QStringLiteral("Not known")));
    session.encoder(fraba).tell(Parameter::steps, 512);
    session.bus.advance(5);
    EXPECT_TRUE(QTest::qWaitFor([&] { return cell(1, 2) == QStringLiteral("512 (by hand)"); }));
    EXPECT_TRUE(toolTip(1).startsWith(QStringLiteral("Set manually"))) << toolTip(1).toStdString();
    EXPECT_TRUE(toolTip(1).contains(QLatin1Char('\n'))) << "and when";
    EXPECT_FALSE(model().index(1, 2).data(Qt::ForegroundRole).isValid());

    session.bus.setRunning(false);
    session.bus.advance(5);
    const QString why = QStringLiteral("Not up to date: The bus does not run. Last seen: ");
    EXPECT_TRUE(QTest::qWaitFor([&] { return cell(1, 1).startsWith(why); })) << cell(1, 1).toStdString();
    EXPECT_EQ(cell(2, 2), QStringLiteral("512 (by hand)"));
    EXPECT_TRUE(model().index(2, 2).data(Qt::ForegroundRole).isValid());
    page.choose(What::store, {});
    EXPECT_TRUE(cell(1, 1).startsWith(why)) << cell(1, 1).toStdString();
}

TEST_F(TransferPageTest, WritesToTheChosenEncodersOnlyAndAccountsForIt)
{
    toggle("1.0");
    EXPECT_EQ(text("transferSummary"), QStringLiteral("Encoders chosen: 1. EEPROM writes: at most 2."));
    write();
    EXPECT_EQ(session.encoder(baumer).known(Parameter::steps)->value, 4096);
    EXPECT_FALSE(session.encoder(fraba).known(Parameter::steps));
    EXPECT_EQ(messages,
              QStringList{QStringLiteral(
                  "Transferred to 1 encoders: 2 values written, 0 already there, 2 EEPROM writes.")});
    EXPECT_EQ(text("transferResult"), messages.front());
    EXPECT_TRUE(account().contains(QStringLiteral("Written, confirmed by the handshake")));
    click("transferBack");
    EXPECT_EQ(model().index(rowOf("2.0"), 0).data(Qt::CheckStateRole), QVariant()); // nothing to write
}

TEST_F(TransferPageTest, NoneAndAllAreOneClick)
{
    click("chooseNone");
    EXPECT_FALSE(isEnabled("transferBegin"));
    click("chooseAll");
    EXPECT_TRUE(isEnabled("transferBegin"));
}

TEST_F(TransferPageTest, InWatchTheTableSaysWhyNothingCanBeWritten)
{
    session.bus.setOperate(false);
    session.bus.advance(5);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !isEnabled("transferBegin"); }));
    EXPECT_EQ(cell(2, 1), QStringLiteral("Nothing was sent to 1.0: the program only watches. Switch to "
                                         "Operate first."));
}

TEST_F(TransferPageTest, StoringReadsAndPutsItIntoTheProjectAsOneStepOfUndo)
{
    page.choose(What::store, {});
    click("chooseNone");
    toggle("1.0");
    write();
    const ProjectDevice stored = project.device(fraba);
    EXPECT_FALSE(stored.stored.empty());
    EXPECT_EQ(stored.stored.front().evidence, Evidence::read);
    EXPECT_TRUE(project.device(onLoop).stored.empty());
    EXPECT_EQ(messages.size(), 1);
    project.undoStack().undo();
    EXPECT_TRUE(project.device(fraba).stored.empty());
    EXPECT_FALSE(project.device(fraba).wanted.empty());
}

TEST_F(TransferPageTest, CloneGivesTheKnownValuesToEncodersOfTheSameKind)
{
    session.encoder(fraba).tell(Parameter::steps, 100);
    page.choose(What::clone, fraba);
    EXPECT_EQ(rowOf("1.0"), -1);
    EXPECT_TRUE(cell(rowOf("2.0") + 1, 1).contains(QStringLiteral("Steps")));
    EXPECT_EQ(model().index(rowOf("2.0"), 0).data(Qt::CheckStateRole), QVariant()); // another kind
    write();
    EXPECT_EQ(session.encoder(onLoop).known(Parameter::steps)->value, 100);
}

TEST_F(TransferPageTest, RestoringWritesWhatWasThereBefore)
{
    page.choose(What::restore, baumer);
    EXPECT_EQ(text("transferSummary"), QStringLiteral("There is nothing to restore."));
    befores = {{baumer, session.bus.dateTime({}), {}, {{Parameter::steps, 8192}}}};
    page.choose(What::restore, baumer);
    EXPECT_EQ(cell(1, 3), QStringLiteral("8192"));
    write();
    EXPECT_EQ(session.encoder(baumer).known(Parameter::steps)->value, 8192);
    EXPECT_EQ(messages.back(), QStringLiteral("Values of 1 Mar 2026 14:02:00 were restored: 1."));
}

TEST_F(TransferPageTest, CancelInTheMiddleAsksHowToLeaveTheEncoder)
{
    toggle("1.0");
    click("transferBegin");
    session.bus.advance(8); // the first value is being taken
    ASSERT_TRUE(page.isBusy());
    {
        const auto question = test::Question::answeredBy(QStringLiteral("Run with what it has"));
        click("cancelJob");
        EXPECT_TRUE(question.wasAsked());
    }
    advanceWhileBusy(page);
    EXPECT_EQ(session.encoder(baumer).latest().state, EncoderState::operation);
    EXPECT_TRUE(account().contains(QStringLiteral("Not done")));
}

// An unanswered question lapses when the encoder is done; the others stay cancelled.
TEST_F(TransferPageTest, AfterCancelNoOtherEncoderIsBegunWhateverBecomesOfTheQuestion)
{
    want(onLoop, {{Parameter::steps, 100}});
    session.bus.advance(1);
    page.choose(What::write, {});
    click("transferBegin");
    for (int i = 0; i < 2000 && session.encoder(fraba).latest().state != EncoderState::parameterization; ++i)
        session.bus.advance(1);
    {
        const test::Question question([this](QWidget &dialog) {
            for (int i = 0; i < 5000 && dialog.isVisible(); ++i)
                session.bus.advance(1);
            EXPECT_FALSE(dialog.isVisible());
        });
        click("cancelJob");
        EXPECT_TRUE(question.wasAsked());
    }
    EXPECT_FALSE(page.isBusy());
    advanceWhileBusy(page);
    EXPECT_TRUE(session.encoder(fraba).known(Parameter::steps));
    EXPECT_FALSE(session.encoder(baumer).known(Parameter::steps));
    EXPECT_FALSE(session.encoder(onLoop).known(Parameter::steps));
}

TEST_F(TransferPageTest, GoingOnAfterCancelFinishesTheEncoderAndBeginsNoOther)
{
    click("transferBegin");
    for (int i = 0; i < 2000 && session.encoder(fraba).latest().state != EncoderState::parameterization; ++i)
        session.bus.advance(1);
    {
        const auto question = test::Question::answeredBy(QStringLiteral("Go on"));
        click("cancelJob");
        EXPECT_TRUE(question.wasAsked());
    }
    EXPECT_TRUE(page.isBusy());
    EXPECT_TRUE(text("jobProgress").contains(QStringLiteral("No other is started.")));
    advanceWhileBusy(page);
    EXPECT_EQ(session.encoder(fraba).known(Parameter::steps)->value, 255);
    EXPECT_FALSE(session.encoder(baumer).known(Parameter::steps));
}

// The frame is up to one refresh old: the first word is in OUT, but the window has not heard of it.
TEST_F(TransferPageTest, WhetherTheEncoderHasTakenSomethingIsNotDecidedByAnOldFrame)
{
    toggle("1.0");
    bool cancelled = false;
    QObject::connect(&session.encoder(baumer), &EncoderSession::progressed, &page, [&] {
        if (!std::exchange(cancelled, true))
            click("cancelJob");
    });
    click("transferBegin");
    {
        const auto question = test::Question::answeredBy(QStringLiteral("Run with what it has"));
        for (int i = 0; i < 500 && page.isBusy(); ++i) {
            session.bus.advance(1);
            QCoreApplication::processEvents();
        }
        EXPECT_TRUE(question.wasAsked());
    }
    ASSERT_TRUE(cancelled);
    EXPECT_EQ(session.encoder(baumer).latest().state, EncoderState::operation);
}

TEST_F(TransferPageTest, AnEncoderLeftInParameterizationIsAccountedForWithWhatItHasTaken)
{
    toggle("1.0");
    click("transferBegin");
    for (int i = 0; i < 100 && session.encoder(baumer).latest().state != EncoderState::parameterization; ++i)
        session.bus.advance(1);
    {
        const auto question = test::Question::answeredBy(QStringLiteral("Leave in parameterization"));
        click("cancelJob");
        EXPECT_TRUE(question.wasAsked());
    }
    advanceWhileBusy(page);
    EXPECT_EQ(session.encoder(baumer).latest().state, EncoderState::parameterization);
    EXPECT_TRUE(account().contains(QStringLiteral("Accepted, but not valid until run is sent")))
        << account().toStdString();
    EXPECT_TRUE(account().contains(QStringLiteral("Not done")));
}

// One more encoder in front: the numbers of all others have changed.
TEST_F(TransferPageTest, NeitherWritesToNorStoresOfAnEncoderThatIsNotTheProjectsOne)
{
    Project shifted = project.project();
    for (ProjectDevice &device : shifted.devices)
        device.participant.number = nextSegment(device.participant.number);
    ProjectDevice front = shifted.devices[2]; // K1
    front.participant.number = NodeId("1.0");
    shifted.devices.insert(shifted.devices.begin(), front);
    project.setProject(shifted, {});
    page.choose(What::write, {});
    EXPECT_EQ(
        cell(rowOf("2.0") + 2, 1),
        QStringLiteral("2.0: configured is FRABA OCD-IB K3 (its number is 1.0 now), found was Baumer GXP6W "
                       "K3. Compare, and take over what is right."));
    EXPECT_FALSE(isEnabled("transferBegin"));
    page.choose(What::store, {});
    EXPECT_FALSE(isEnabled("transferBegin"));
    EXPECT_NE(rowOf("2.0"), -1);
}

TEST_F(TransferPageTest, AWornEepromIsAskedAboutBeforeAnythingIsWritten)
{
    session.encoder(fraba).setEepromCount({.writes = 250});
    click("chooseNone");
    click("chooseAll");
    EXPECT_FALSE(isEnabled("transferBegin"));
    click("writeNevertheless");
    EXPECT_TRUE(isEnabled("transferBegin"));

    session.encoder(fraba).setEepromCount({.writes = 600});
    click("chooseNone");
    click("chooseAll");
    EXPECT_FALSE(isEnabled("transferBegin"));
    type("typedPlace", "1.0");
    EXPECT_TRUE(isEnabled("transferBegin"));
    toggle("1.0");
    EXPECT_FALSE(find<QLineEdit>("typedPlace")->isVisible());
    EXPECT_TRUE(isEnabled("transferBegin"));
}

TEST_F(TransferPageTest, TheAccountIsCopiedAndSaved)
{
    write();
    click("copyAccount");
    EXPECT_EQ(QGuiApplication::clipboard()->text(), account());
}

} // namespace
} // namespace codewheel
