// SPDX-License-Identifier: GPL-3.0-or-later
// A ring behind a gateway in the window: its connection, its registers, and what keeps it safe.
#include "app/window/buses/plant.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "kinds/interbus/plan/gateway_plan.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "report/live_encoders.h"
#include "tests/app/kinds/interbus/gateway_test.h"
#include "tests/app/question.h"
#include "widgets/connect/check_list.h"
#include "widgets/connect/connect_page.h"
#include "widgets/job/known_before_bar.h"
#include "widgets/kinds/interbus/gateway/gateway_panel.h"
#include "widgets/kinds/interbus/gateway/link_figures_model.h"
#include "widgets/kinds/interbus/gateway/registers_page.h"
#include "widgets/kinds/interbus/master/ring_comparison.h"
#include "widgets/kinds/interbus/training/training_panel.h"
#include "widgets/look/fonts.h"
#include "widgets/look/inline_message.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/structure/structure_view.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <QTableView>
#include <QTest>
#include <QTreeView>

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <optional>

namespace codewheel {
namespace {

using test::fraba;
class GatewayInWindowTest : public test::GatewayTest
{
protected:
    static constexpr int watchdogRegister = 4'096;

    // In Operate, with a word in OUT, when the watchdog of the gateway trips.
    void operateAndTrip()
    {
        choose(QStringLiteral("gateway.hall"));
        setting<QSpinBox>("watchdog").setValue(watchdogRegister);
        connectChosen();
        bus().setOperate(true);
        advance(20);
        send(fraba, 0x0200'00FF);
        bank->tripped = watchdogRegister;
    }
    // In Operate, with a confirmed parameter word in OUT.
    void beginParameterization()
    {
        connectGateway();
        bus().setOperate(true);
        advance(20);
        setIn(0, 0xC200'00FE);
        send(fraba, 0x0200'00FE);
        advance(200);
    }
};
using test::RegisterBankPort;

class UnreachablePort : public RegisterBankPort
{
public:
    using RegisterBankPort::RegisterBankPort;
    Result<void> open() override
    {
        return refuse(RefusalKind::link, RefusalId::hostNotFound, {QStringLiteral("gateway.hall")});
    }
};

class ClosingPort : public RegisterBankPort
{
public:
    using RegisterBankPort::RegisterBankPort;
    Noticed noticed() const override
    {
        return {.renewals = 41, .closedAfterEach = 40, .keepsNone = true, .closesAfterEach = true};
    }
};

TEST_F(GatewayInWindowTest, ConnectsInWatchAndWritesNothing)
{
    connectGateway();
    ASSERT_TRUE(bus().isOpen());
    EXPECT_FALSE(bus().isOperating());
    EXPECT_FALSE(bus().isSimulated());
    EXPECT_EQ(in(fraba), 1'234u);
    EXPECT_EQ(bank->writes, 0);
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked->host, QStringLiteral("gateway.hall"));
    EXPECT_EQ(ringPlan(shown->project().project(), firstBus).link.kind, QStringLiteral("modbus-tcp"));
}

// The user says that it is the same encoder; the mode is asked for anew.
TEST_F(GatewayInWindowTest, WhatWasKnownBeforeADisconnectionIsAskedForOnce)
{
    connectGateway();
    bus().encoder(fraba)->tell(Parameter::steps, 8'192);
    bus().encoder(fraba)->tell(Parameter::startUpMode, 1);
    ringActions().disconnectBus->trigger();
    advance(5);
    ringActions().connectBus->trigger();
    advance(20);
    ASSERT_TRUE(bus().isOpen());
    EXPECT_FALSE(bus().encoder(fraba)->known(Parameter::steps));
    ASSERT_TRUE(bus().encoder(fraba)->knownBefore());
    window().findChild<StructureView *>()->choose(fraba);
    auto *dock = window().findChild<QDockWidget *>(QStringLiteral("parametersDock"));
    dock->show();
    dock->raise();
    advance(50);
    auto *panel = window().findChild<ParameterPanel *>();
    auto *bar = panel->findChild<KnownBeforeBar *>();
    ASSERT_TRUE(panel->isVisible());
    ASSERT_TRUE(bar->isVisible());
    EXPECT_TRUE(bar->sentence().contains(QStringLiteral("Steps = 8192"))) << bar->sentence().toStdString();
    const auto whyNothingToRestore = [this] { return actions().restoreValues->toolTip(); };
    EXPECT_TRUE(whyNothingToRestore().contains(QStringLiteral("Say first whether")))
        << whyNothingToRestore().toStdString();
    click(button(*bar, QStringLiteral("The same")));
    advance(5);
    EXPECT_FALSE(bar->isVisible());
    EXPECT_TRUE(whyNothingToRestore().contains(QStringLiteral("no values from before")))
        << whyNothingToRestore().toStdString();
    EXPECT_EQ(bus().encoder(fraba)->known(Parameter::steps)->value, 8'192);
    EXPECT_FALSE(bus().encoder(fraba)->known(Parameter::startUpMode));
    EXPECT_EQ(bank->writes, 0);
}

// Before anything was exchanged, too.
TEST_F(GatewayInWindowTest, IsCalledAGatewayInTheBusStructure)
{
    connectGateway();
    const auto &tree = *window().findChild<QTreeView *>(QStringLiteral("structure"));
    EXPECT_EQ(tree.model()->index(0, 0).data().toString(), QStringLiteral("Ring (gateway)"));
}

TEST_F(GatewayInWindowTest, TheFrabaPresetIsShownWithTheReasonWhyItCannotBeSent)
{
    connectGateway();
    window().findChild<StructureView *>()->choose(fraba);
    auto *preset = window().findChild<QAction *>(QStringLiteral("frabaPreset"));
    EXPECT_TRUE(preset->isVisible());
    EXPECT_FALSE(preset->isEnabled());
    EXPECT_TRUE(preset->toolTip().contains(QStringLiteral("one cycle only")))
        << preset->toolTip().toStdString();
    window().findChild<StructureView *>()->choose(test::baumer);
    EXPECT_FALSE(preset->isVisible());
}

TEST_F(GatewayInWindowTest, ThePageSaysConnectedOnlyWhileItIs)
{
    connectGateway();
    EXPECT_TRUE(told(connection()).startsWith(QStringLiteral("Connected.")))
        << told(connection()).toStdString();
    ringActions().disconnectBus->trigger();
    advance(20);
    ASSERT_TRUE(connection().isVisible());
    EXPECT_EQ(told(connection()), QString());
}

// A gateway has no ID cycle: what it has is what it was told.
TEST_F(GatewayInWindowTest, NothingIsComparedWhereNobodySaysWhatIsThere)
{
    connectGateway();
    window().showComparison();
    advance(40);
    const auto &page = *window().findChild<RingComparison *>();
    EXPECT_TRUE(std::ranges::any_of(page.findChildren<QLabel *>(), [](const QLabel *label) {
        return label->text().startsWith(QStringLiteral("There is nothing to compare"));
    }));
    for (const QPushButton *button : page.findChildren<QPushButton *>())
        EXPECT_FALSE(button->isVisible() && button->isEnabled() &&
                     button->text().contains(QStringLiteral("project")))
            << button->text().toStdString();
}

TEST_F(GatewayInWindowTest, NorIsItInTheReport)
{
    connectGateway();
    ReportInput input;
    input.project = shown->project().project();
    addConnected(input, shown->buses());
    EXPECT_FALSE(input.connected.contains(firstBus));
}

TEST_F(GatewayInWindowTest, WordsGoOutInOperateOnly)
{
    connectGateway();
    bus().channel(fraba)->stage(0x0200'00FF);
    EXPECT_FALSE(bus().channel(fraba)->write());
    advance(20);
    EXPECT_EQ(bank->writes, 0);
    bus().setOperate(true);
    advance(20);
    send(fraba, 0x0200'00FF);
    EXPECT_EQ(outThere(0), 0x0200'00FFu);
}

TEST_F(GatewayInWindowTest, ARingThatNobodyHasPlannedIsConnectedOnItsPage)
{
    shown->project().setProject(Project(), {});
    ringActions().connectBus->trigger();
    advance(50);
    EXPECT_TRUE(connection().isVisible());
    EXPECT_FALSE(bus().isOpen());
    click(button(connection(), QStringLiteral("Connect")));
    advance(50);
    EXPECT_TRUE(bus().isOpen()) << "the training bus is chosen there";
}

// What is there may move the machine: no zeros are shown that nobody has seen.
TEST_F(GatewayInWindowTest, OutThatIsNotReadBackIsADashUntilItIsWritten)
{
    choose(QStringLiteral("gateway.hall"));
    for (auto *readBack : connection().findChildren<QComboBox *>(QStringLiteral("read-back")))
        readBack->setCurrentIndex(readBack->findData(QStringLiteral("off")));
    click(button(connection(), QStringLiteral("Connect")));
    advance(20);
    ASSERT_FALSE(asked->readsBack);
    actions().monitors->trigger();
    advance(50);
    const auto shownOut = [this] {
        for (const auto *field : window().findChildren<QLineEdit *>())
            if (field->isVisible() && field->accessibleName().startsWith(QStringLiteral("OUT 1.0")))
                return field->text();
        return QString();
    };
    EXPECT_EQ(shownOut(), QStringLiteral("–"));
    bus().channel(fraba)->stage(0x0200'00FF);
    EXPECT_EQ(shownOut(), QStringLiteral("020000FF")) << "what is typed";
    bus().channel(fraba)->unstage();
    EXPECT_EQ(shownOut(), QStringLiteral("–"));
    bus().setOperate(true);
    advance(50);
    EXPECT_EQ(shownOut(), QStringLiteral("–")) << "nobody has asked for a word there";
    send(fraba, 0x0200'00FF);
    EXPECT_EQ(shownOut(), QStringLiteral("020000FF"));
}

TEST_F(GatewayInWindowTest, AlarmStopWritesZerosAndSaysThatTheyArrived)
{
    connectGateway();
    bus().setOperate(true);
    advance(20);
    send(fraba, 0x0200'00FF);
    actions().alarmStop->trigger();
    advance(20);
    EXPECT_EQ(outThere(0), 0u);
    shown->messages().catchUp();
    bool isSaid = false;
    for (int i = 0; i < shown->messages().rowCount(); ++i)
        for (int column = 0; column < shown->messages().columnCount(); ++column)
            isSaid |= shown->messages().index(i, column).data().toString().contains(
                QStringLiteral("zeros of the ALARM STOP have arrived"));
    EXPECT_TRUE(isSaid);
}

TEST_F(GatewayInWindowTest, ATrippedWatchdogIsAcknowledgedByWhoeverSaysSo)
{
    operateAndTrip();
    const int writes = bank->writes;
    advance(5'000);
    ASSERT_TRUE(bus().isOpen()) << "it still shows IN";
    EXPECT_FALSE(bus().isOperating());
    EXPECT_TRUE(banner().sentence().contains(QStringLiteral("watchdog")))
        << banner().sentence().toStdString();
    EXPECT_TRUE(treeTexts().contains(QStringLiteral("outputs blocked"))) << treeTexts().toStdString();
    EXPECT_EQ(bank->writes, writes);
    press("acknowledgeWatchdog");
    advance(100);
    EXPECT_EQ(bank->holding[watchdogRegister], 1);
    EXPECT_EQ(bank->writes, writes + 1) << "and nothing else";
    EXPECT_FALSE(bus().isOperating());
    EXPECT_FALSE(treeTexts().contains(QStringLiteral("outputs blocked")));
}

// What it asks about need not be so any more when the link is back.
TEST_F(GatewayInWindowTest, TheQuestionAboutRunEndsWithTheLink)
{
    connectGateway();
    setIn(0, 0xC200'00FF);
    bus().setOperate(true);
    advance(200);
    const test::Question question([this](QWidget &box) {
        bank->busyUntil = std::chrono::hours(1);
        advance(5'000);
        EXPECT_EQ(bus().state(), BusState::lost);
        EXPECT_FALSE(box.isVisible());
    });
    press("sendRun");
    EXPECT_TRUE(question.wasAsked());
}

TEST_F(GatewayInWindowTest, AnAlarmStopWaitsForTheWatchdogToBeAcknowledged)
{
    operateAndTrip();
    actions().alarmStop->trigger();
    advance(3'000);
    EXPECT_EQ(outThere(0), 0x0200'00FFu);
    EXPECT_TRUE(banner().sentence().contains(QStringLiteral("zeros"))) << banner().sentence().toStdString();
    press("acknowledgeWatchdog");
    advance(2'000);
    EXPECT_EQ(outThere(0), 0u);
    EXPECT_FALSE(banner().sentence().contains(QStringLiteral("zeros"))) << banner().sentence().toStdString();
}

TEST_F(GatewayInWindowTest, ARingThatItsGatewaySaysHasFailedIsNotShownAsLive)
{
    constexpr int status = 8'192;
    bank->input[status] = 0x20;
    choose(QStringLiteral("gateway.hall"));
    setting<QSpinBox>("status").setValue(status);
    setting<QSpinBox>("run-bit").setValue(5);
    setting<QLineEdit>("fault-bits").setText(QStringLiteral("2+3"));
    connectChosen();
    ASSERT_TRUE(bus().isOpen());
    EXPECT_FALSE(banner().isVisible()) << banner().sentence().toStdString();
    EXPECT_TRUE(bus().encoder(fraba)->freshness().isLive());
    bus().encoder(fraba)->tell(Parameter::steps, 8'192);

    bank->input[status] = 0x04;
    advance(3'000);
    EXPECT_TRUE(banner().sentence().contains(QStringLiteral("its ring has failed")))
        << banner().sentence().toStdString();
    EXPECT_FALSE(bus().encoder(fraba)->freshness().isLive());
    EXPECT_TRUE(treeTexts().contains(QStringLiteral("FRABA OCD-IB K3|cut off"))) << treeTexts().toStdString();

    bank->input[status] = 0x20;
    advance(3'000);
    EXPECT_FALSE(banner().isVisible()) << banner().sentence().toStdString();
    EXPECT_TRUE(bus().encoder(fraba)->freshness().isLive());
    EXPECT_TRUE(bus().encoder(fraba)->knownBefore()) << "other encoders may be there now";
    EXPECT_FALSE(bus().encoder(fraba)->known(Parameter::steps));
}

// Whoever disconnects or quits gives them up, and is asked; the usual answer is not to.
TEST_F(GatewayInWindowTest, ZerosThatHaveNotArrivedAreNotGivenUpUnasked)
{
    connectGateway();
    bus().setOperate(true);
    advance(20);
    send(fraba, 0x0200'00FF);
    bank->busyUntil = std::chrono::hours(1);
    advance(5'000);
    ASSERT_EQ(bus().state(), BusState::lost);
    actions().alarmStop->trigger();
    advance(1'500);
    {
        const test::Question question = test::Question::answeredBy(QStringLiteral("Keep trying"));
        ringActions().disconnectBus->trigger();
        EXPECT_TRUE(question.text().contains(QStringLiteral("zeros of the ALARM STOP have arrived")));
    }
    advance(20);
    EXPECT_EQ(bus().state(), BusState::lost);
    EXPECT_NE(outThere(0), 0u);
    const test::Question question = test::Question::answeredBy(QStringLiteral("Give up, and go on"));
    ringActions().disconnectBus->trigger();
    advance(20);
    EXPECT_EQ(bus().state(), BusState::closed);
}

// A click that was meant for the question before hits nothing, and what was last seen is not said to be so.
TEST_F(GatewayInWindowTest, AQuestionThatChangesWithTheLinkTakesNoHastyAnswer)
{
    beginParameterization();
    std::optional<test::Question> second;
    const test::Question first([&](QWidget &) {
        bank->busyUntil = std::chrono::hours(1);
        advance(5'000);
        EXPECT_EQ(bus().state(), BusState::lost);
        second.emplace([](QWidget &box) {
            QPushButton &leave = button(box, QStringLiteral("Leave as they are"));
            const QPushButton &run = button(box, QStringLiteral("Send run, then 00000000"));
            QTest::mouseClick(&leave, Qt::LeftButton);
            EXPECT_TRUE(box.isVisible()) << "nobody has read it yet";
            EXPECT_TRUE(QTest::qWaitFor([&] { return leave.isEnabled(); }));
            EXPECT_FALSE(run.isEnabled());
            EXPECT_TRUE(run.toolTip().contains(QStringLiteral("the link is lost")))
                << run.toolTip().toStdString();
            EXPECT_FALSE(button(box, QStringLiteral("Set to 00000000")).isEnabled());
            click(leave);
        });
    });
    ringActions().disconnectBus->trigger();
    ASSERT_TRUE(second);
    const QString text = second->text();
    EXPECT_TRUE(text.startsWith(QStringLiteral("The link is lost."))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("Nothing can be sent now"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("OUT 1.0 was 020000FE when last seen"))) << text.toStdString();
    advance(20);
    EXPECT_EQ(bus().state(), BusState::closed);
}

TEST_F(GatewayInWindowTest, AfterAlarmStopZerosAreNotOfferedForWhatIsZero)
{
    beginParameterization();
    std::optional<test::Question> second;
    const test::Question first([&](QWidget &) {
        actions().alarmStop->trigger();
        advance(500);
        second.emplace([](QWidget &box) {
            const QPushButton &zeros = button(box, QStringLiteral("Set to 00000000"));
            const QPushButton &leave = button(box, QStringLiteral("Leave as they are"));
            EXPECT_TRUE(QTest::qWaitFor([&] { return leave.isEnabled(); }));
            EXPECT_FALSE(zeros.isEnabled());
            EXPECT_EQ(zeros.toolTip(), QStringLiteral("OUT is 00000000 already"));
            QTest::keyClick(&box, Qt::Key_Escape);
        });
    });
    ringActions().disconnectBus->trigger();
    ASSERT_TRUE(second && second->wasAsked());
    EXPECT_TRUE(bus().isOpen());
}

TEST_F(GatewayInWindowTest, WhatWasEnteredForTheTrainingRingIsNotSaidOfARealOne)
{
    ASSERT_FALSE(bus().isOpen());
    ringActions().connectBus->trigger(); // the training ring again
    advance(20);
    ASSERT_TRUE(bus().encoder(fraba)->known(Parameter::steps));
    ringActions().disconnectBus->trigger();
    connectGateway();
    ASSERT_TRUE(bus().isOpen());
    EXPECT_FALSE(bus().encoder(fraba)->known(Parameter::steps));
}

TEST_F(GatewayInWindowTest, ARefusalIsShownWhereItWasAskedFor)
{
    struct Silent final : RegisterBankPort
    {
        using RegisterBankPort::RegisterBankPort;
        Result<void> open() override
        {
            return refuse(RefusalKind::link, RefusalId::hostNotFound, {QStringLiteral("gateway.hall")});
        }
    };
    ring().setPorts([this](const GatewaySettings &) { return std::make_unique<Silent>(bank); });
    connectGateway();
    EXPECT_FALSE(bus().isOpen());
    EXPECT_TRUE(told(connection()).contains(QStringLiteral("no host \"gateway.hall\"")))
        << told(connection()).toStdString();
}

TEST_F(GatewayInWindowTest, WithoutAHostNothingIsConnectedOrTested)
{
    choose({});
    click(button(connection(), QStringLiteral("Connect")));
    EXPECT_EQ(told(connection()), QStringLiteral("Enter the name or address of the gateway."));
    click(button(connection(), QStringLiteral("Test")));
    EXPECT_FALSE(asked);
}

TEST_F(GatewayInWindowTest, KeepingOpensNothingAndCanBeUndone)
{
    choose(QStringLiteral("gateway.hall"));
    click(button(connection(), QStringLiteral("Keep in project")));
    EXPECT_FALSE(asked);
    ASSERT_TRUE(plannedGateway(shown->project().project(), firstBus));
    shown->project().undoStack().undo();
    EXPECT_FALSE(plannedGateway(shown->project().project(), firstBus));
}

TEST_F(GatewayInWindowTest, TheTestSaysStepByStepWhatAnswers)
{
    bank->holdingEnd = 0; // OUT cannot be read back
    choose(QStringLiteral("gateway.hall"));
    click(button(connection(), QStringLiteral("Test")));
    const auto &test = button(connection(), QStringLiteral("Cancel test"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return test.text().remove(u'&') == QStringLiteral("Test"); }));
    const QString steps = connection().steps().text();
    EXPECT_TRUE(steps.contains(QStringLiteral("Unit 1 answers"))) << steps.toStdString();
    EXPECT_TRUE(steps.contains(QStringLiteral("position 1234"))) << steps.toStdString();
    EXPECT_TRUE(steps.contains(QStringLiteral("exception 2"))) << steps.toStdString();
    EXPECT_FALSE(bus().isOpen());
    EXPECT_EQ(bank->writes, 0);
}

TEST_F(GatewayInWindowTest, AGatewayThatClosesTheConnectionAfterEachAnswerIsToldSo)
{
    ring().setPorts([this](const GatewaySettings &) { return std::make_unique<ClosingPort>(bank); });
    choose(QStringLiteral("gateway.hall"));
    click(button(connection(), QStringLiteral("Test")));
    const auto &test = button(connection(), QStringLiteral("Cancel test"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return test.text().remove(u'&') == QStringLiteral("Test"); }));
    const QString steps = connection().steps().text();
    EXPECT_TRUE(steps.contains(QStringLiteral("closes the connection after each answer")))
        << steps.toStdString();
    EXPECT_TRUE(steps.contains(QStringLiteral("42"))) << steps.toStdString();

    connectChosen();
    advance(500);
    const QAbstractItemModel &figures = *window().findChild<LinkFiguresModel *>();
    std::map<QString, QString> shownThere;
    for (int row = 0; row < figures.rowCount(); ++row)
        shownThere[figures.headerData(row, Qt::Vertical).toString()] =
            figures.index(row, 0).data().toString();
    EXPECT_EQ(shownThere[QStringLiteral("Connections")], QStringLiteral("42"));
    EXPECT_EQ(shownThere[QStringLiteral("Closed after each answer")], QStringLiteral("40"));
    const auto &table = *window().findChild<GatewayPanel *>()->findChild<QTableView *>();
    const int figure = QFontMetrics(numberFont()).horizontalAdvance(QStringLiteral("1234567"));
    EXPECT_GE(table.viewport()->width(), figure);
    EXPECT_LE(table.verticalHeader()->sizeHint().width(), table.verticalHeader()->width())
        << "no title is cut off";
}

TEST_F(GatewayInWindowTest, TheCountOfAnotherEncoderIsInDoubtAtOnce)
{
    connectGateway();
    bus().setOperate(true);
    advance(20);
    bus().encoder(fraba)->tell(Parameter::startUpMode, 1);
    setIn(0, 0xC200'00FF);
    send(fraba, 0x0200'00FF);
    advance(200);
    setIn(0, 1'234);
    send(fraba, 0x8000'0000);
    advance(200);
    send(fraba, 0);
    advance(2'000);
    ASSERT_EQ(bus().encoder(fraba)->eepromCount().writes, 1);
    bus().encoder(fraba)->tell(Parameter::steps, 256);
    ringActions().disconnectBus->trigger();
    advance(500);
    ASSERT_FALSE(bus().isOpen());
    ringActions().connectBus->trigger();
    advance(500);
    ASSERT_TRUE(bus().isOpen());
    ASSERT_TRUE(bus().encoder(fraba)->knownBefore());
    window().findChild<StructureView *>()->choose(fraba);
    auto *dock = window().findChild<QDockWidget *>(QStringLiteral("parametersDock"));
    dock->show();
    dock->raise();
    advance(50);
    auto *bar = window().findChild<ParameterPanel *>()->findChild<KnownBeforeBar *>();
    click(button(*bar, QStringLiteral("Another one")));
    advance(50);
    const auto labels = window().findChildren<QLabel *>();
    EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel *label) {
        return label->text().contains(QStringLiteral("0-1 writes by Codewheel"));
    }));
}

TEST_F(GatewayInWindowTest, TheWordOrderIsSetOnceAndHoldsBothWays)
{
    setIn(0, 0x04D2'0000); // 1234 with its low word first
    connectGateway();
    EXPECT_EQ(in(fraba), 0x04D2'0000u);
    ringActions().registers->trigger();
    advance(20);
    click(button(registers(), QStringLiteral("Set low word first")));
    advance(20);
    ASSERT_TRUE(bus().isOpen());
    EXPECT_FALSE(bus().isOperating());
    EXPECT_EQ(in(fraba), 1'234u);
    bus().setOperate(true);
    advance(20);
    send(fraba, 0x0200'00FF);
    EXPECT_EQ(outThere(0), 0x00FF'0200u);
}

TEST_F(GatewayInWindowTest, EachDeviceShowsItsRegistersAndReadings)
{
    connectGateway();
    ringActions().registers->trigger();
    advance(20);
    const auto &rows = *registers().findChild<QTableView *>(QStringLiteral("registers"))->model();
    EXPECT_EQ(rows.rowCount(), static_cast<int>(bus().structure().size()));
    EXPECT_EQ(rows.index(1, 1).data().toString(), QStringLiteral("2\u20133"));
    EXPECT_EQ(rows.index(0, 3).data().toString(), QStringLiteral("000004D2"));
    EXPECT_EQ(rows.index(0, 4).data().toString(), QStringLiteral("04D20000"));
}

TEST_F(GatewayInWindowTest, ADeviceCanBeReadWithoutConnecting)
{
    choose(QStringLiteral("gateway.hall"));
    click(button(connection(), QStringLiteral("Keep in project")));
    ringActions().registers->trigger();
    const auto &rows = *registers().findChild<QTableView *>(QStringLiteral("registers"))->model();
    EXPECT_EQ(rows.index(0, 3).data().toString(), QStringLiteral("\u2013"));
    click(button(registers(), QStringLiteral("Read now")));
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return rows.index(0, 3).data().toString() == QStringLiteral("000004D2"); }));
    EXPECT_FALSE(bus().isOpen());
}

TEST_F(GatewayInWindowTest, TheRegistersOpenAtTheChosenDevice)
{
    connectGateway();
    window().findChild<StructureView *>()->choose(test::baumer);
    ringActions().registers->trigger();
    EXPECT_EQ(registers().findChild<QTableView *>()->currentIndex().siblingAtColumn(0).data().toString(),
              QStringLiteral("2.0"));
}

TEST_F(GatewayInWindowTest, SomebodyElsesWordIsSaidAndEndsOperate)
{
    connectGateway();
    bus().setOperate(true);
    advance(20);
    bank->holding[2] = 0x8000;
    advance(100);
    EXPECT_FALSE(bus().isOperating());
    EXPECT_EQ(out(test::baumer), 0x8000'0000u);
    EXPECT_EQ(outThere(1), 0x8000'0000u);
}

TEST_F(GatewayInWindowTest, ARealRingHasNoTrainingPanel)
{
    connectGateway();
    EXPECT_TRUE(isSaidToBeReal());
    EXPECT_FALSE(ring().turning());
}

// Its twin would look as if it were the ring.
TEST_F(GatewayInWindowTest, ARingPlannedBehindAGatewayHasNoTrainingPanelBeforeItIsConnected)
{
    EXPECT_FALSE(isSaidToBeReal());
    choose(QStringLiteral("gateway.hall"));
    click(button(connection(), QStringLiteral("Keep in project")));
    EXPECT_FALSE(bus().isOpen());
    EXPECT_TRUE(isSaidToBeReal());
}

// Simulated devices stand for real ones from then on, so nobody does it by one click.
TEST_F(GatewayInWindowTest, ATrainingRingThatRunsIsReplacedOnlyAfterAsking)
{
    ringActions().connectBus->trigger();
    advance(50);
    ASSERT_TRUE(bus().isSimulated() && bus().isOperating());
    choose(QStringLiteral("gateway.hall"));
    click(button(connection(), QStringLiteral("Connect")));
    advance(50);
    EXPECT_TRUE(bus().isSimulated() && bus().isOperating());
    EXPECT_TRUE(told(connection()).startsWith(QStringLiteral("This bus is connected to simulated encoders.")))
        << told(connection()).toStdString();
    EXPECT_EQ(ringPlan(shown->project().project(), firstBus).link.kind, QStringLiteral("training"));
    click(button(connection(), QStringLiteral("Disconnect and connect")));
    advance(50);
    EXPECT_FALSE(bus().isSimulated());
    EXPECT_EQ(told(connection()), QStringLiteral("Connected. Close this page (Esc) to see the encoders."));
}

TEST_F(GatewayInWindowTest, WhatATestFoundIsForgottenWithOtherSettings)
{
    ring().setPorts([this](const GatewaySettings &) { return std::make_unique<UnreachablePort>(bank); });
    choose(QStringLiteral("gateway.hall"));
    click(button(connection(), QStringLiteral("Test")));
    EXPECT_FALSE(connection().findChild<QLineEdit *>(QStringLiteral("host"))->isEnabled());
    ASSERT_TRUE(QTest::qWaitFor([this] { return !connection().isTesting(); }));
    EXPECT_TRUE(connection().steps().text().contains(QStringLiteral("Further steps: Not tested")))
        << connection().steps().text().toStdString();
    EXPECT_FALSE(connection().steps().text().contains(QStringLiteral("Word of :")));
    auto *host = connection().findChild<QLineEdit *>(QStringLiteral("host"));
    host->setFocus();
    QTest::keyClicks(host, QStringLiteral("2"));
    EXPECT_EQ(connection().steps().count(), 0);
}

} // namespace
} // namespace codewheel
