// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/plan/esc_line_plan.h"
#include "tests/app/kinds/esc/esc_line_at_port_test.h"
#include "tests/support/plans.h"
#include "tests/support/port_holder.h"
#include "tests/support/without_rights.h"
#include "widgets/connect/check_list.h"
#include "widgets/kinds/esc/line/esc_line_search.h"
#include "widgets/kinds/esc/line/esc_line_terminal.h"
#include "widgets/look/inline_message.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/structure/structure_view.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QTest>
#include <QWidget>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <vector>

namespace codewheel {
namespace {

const Place at3 = placeOnLine({3});
const Place at5 = placeOnLine({5});
const Place at7 = placeOnLine({7});

class EscLineAtPort : public test::EscLineAtPortTest
{
protected:
    // In Operate, as the parameter panel writes it.
    void write(Place number, Parameter parameter, std::int64_t value)
    {
        window().findChild<StructureView *>()->choose(number);
        operate();
        ASSERT_TRUE(comes([&] { return line().isOperating(); }));
        window().findChild<WantedValues *>()->set(number, parameter, value);
        advance(50);
        auto &panel = *window().findChild<ParameterPanel *>();
        click(panel, QStringLiteral("Write…"));
        auto *confirm = panel.findChild<QPushButton *>(QStringLiteral("confirmWrite"));
        ASSERT_TRUE(confirm->isVisibleTo(&panel));
        QTest::mouseClick(confirm, Qt::LeftButton);
    }
    EscLineTerminal &terminal() { return *window().findChild<EscLineTerminal *>(); }
    // As typed at the terminal.
    void ask(const QString &request)
    {
        lineActions().terminal->trigger();
        advance(50);
        QWidget *field = QApplication::focusWidget();
        ASSERT_TRUE(terminal().isAncestorOf(field));
        QTest::keyClicks(field, request);
        QTest::keyClick(field, Qt::Key_Escape); // closes the list of commands
        QTest::keyClick(field, Qt::Key_Return);
    }
    bool isExplained(const QString &meaning)
    {
        for (auto *table : terminal().findChildren<QTableView *>())
            for (int row = 0; row < table->model()->rowCount(); ++row)
                for (int column = 0; column < table->model()->columnCount(); ++column)
                    if (table->model()->index(row, column).data().toString() == meaning)
                        return true;
        return false;
    }
};

TEST_F(EscLineAtPort, IsTestedStepByStepAndThenFree)
{
    plan({test::plannedEncoder(at3, QStringLiteral("Slide")), test::plannedEncoder(at5, {})});
    const QString port = startPeer(QStringLiteral("--addresses 03"));
    typePort(port);
    click(connection(), QStringLiteral("Test"));
    EXPECT_TRUE(connection().isTesting());
    ASSERT_TRUE(comes([&] { return !connection().isTesting(); }));
    const QStringList steps = connection().steps().text().split(u'\n');
    ASSERT_EQ(steps.size(), 5) << connection().steps().text().toStdString();
    EXPECT_TRUE(steps[0].contains(port));
    EXPECT_TRUE(steps[3].contains(QStringLiteral("03h (3)"))) << steps[3].toStdString();
    EXPECT_TRUE(steps[3].contains(QStringLiteral("It answers after"))) << steps[3].toStdString();
    EXPECT_TRUE(steps[4].contains(QStringLiteral("Nothing came."))) << steps[4].toStdString();
    EXPECT_NE(shown->line().training(), nullptr) << "a test connects nothing";
    connectNow();
    EXPECT_TRUE(answers(at3));
}

TEST_F(EscLineAtPort, APortThatIsMissingIsToldWithACommandToCopy)
{
    plan({test::plannedEncoder(at3, QStringLiteral("Slide"))});
    connectPort(QStringLiteral("/dev/ttyNowhere"));
    const auto messages = connection().findChildren<InlineMessage *>();
    const auto told = std::ranges::find_if(
        messages, [](const InlineMessage *message) { return message->command().contains(u"by-id"); });
    ASSERT_NE(told, messages.end());
    click(connection(), QStringLiteral("Copy command"));
    EXPECT_EQ(QGuiApplication::clipboard()->text(), QStringLiteral("ls -l /dev/serial/by-id"));
}

TEST_F(EscLineAtPort, APortThatAnotherProgramHasIsToldWithTheCommandThatEndsIt)
{
    plan({test::plannedEncoder(at3, QStringLiteral("Slide"))});
    const QString port = startPeer(QStringLiteral("--addresses 03"));
    PortHolder holder(QStringLiteral(CODEWHEEL_PYTHON), port);
    connectPort(port);
    const QString process = QString::number(holder.id());
    EXPECT_TRUE(said().contains(port + QStringLiteral(" is in use by the program python")))
        << said().toStdString();
    EXPECT_TRUE(said().contains(QStringLiteral("(process %1)").arg(process))) << said().toStdString();
    click(connection(), QStringLiteral("Copy command"));
    EXPECT_EQ(QGuiApplication::clipboard()->text(), QStringLiteral("kill ") + process);
    holder.end();
    connectNow();
    EXPECT_TRUE(answers(at3));
}

TEST_F(EscLineAtPort, APortThatTheUserMayNotUseIsToldWithTheCommandThatGivesTheRights)
{
    plan({test::plannedEncoder(at3, QStringLiteral("Slide"))});
    const QString port = startPeer(QStringLiteral("--addresses 03"));
    ASSERT_EQ(::chmod(QFile::encodeName(port).constData(), 0), 0);
    {
        const WithoutRights without;
        connectPort(port);
    }
    EXPECT_TRUE(said().contains(QStringLiteral("You may not use %1, and no group").arg(port)))
        << said().toStdString();
    click(connection(), QStringLiteral("Copy command"));
    EXPECT_EQ(QGuiApplication::clipboard()->text(), QStringLiteral("sudo setfacl -m u:$USER:rw ") + port);
    ASSERT_EQ(::chmod(QFile::encodeName(port).constData(), 0600), 0);
    connectNow();
    EXPECT_TRUE(answers(at3));
}

TEST_F(EscLineAtPort, GoesToOperateOnlyWhenItWasAgreedToWriteToARealLine)
{
    plan({test::plannedEncoder(at3, QStringLiteral("Slide"))});
    const QString port = startPeer(QStringLiteral("--addresses 03"));
    connectPort(port);
    ASSERT_TRUE(answers(at3));
    window().findChild<StructureView *>()->choose(at3);
    actions().operate->trigger();
    ASSERT_NE(operateQuestion(), nullptr);
    EXPECT_EQ(operateQuestion()->text(),
              QStringLiteral("This serial line is real. Shall the program write to it?"));
    EXPECT_TRUE(actions().watch->isChecked());
    QTest::keyClick(operateQuestion(), Qt::Key_Return);
    advance(100);
    EXPECT_FALSE(line().isOperating());
    operate();
    ASSERT_TRUE(comes([&] { return line().isOperating(); }));

    actions().watch->trigger();
    ASSERT_TRUE(comes([&] { return !line().isOperating(); }));
    actions().operate->trigger();
    EXPECT_EQ(operateQuestion(), nullptr) << "once in a connection";
    ASSERT_TRUE(comes([&] { return line().isOperating(); }));

    lineActions().disconnectBus->trigger();
    connectPort(port);
    ASSERT_TRUE(answers(at3));
    actions().operate->trigger();
    EXPECT_NE(operateQuestion(), nullptr);
    lineActions().disconnectBus->trigger();
    advance(100);
    EXPECT_TRUE(operateQuestion() == nullptr || !operateQuestion()->isVisible())
        << "it goes with the line it is about";
}

TEST_F(EscLineAtPort, AnEncoderOfAnotherAddressIsFoundThereByTheProject)
{
    plan({test::plannedEncoder(at3, QStringLiteral("Slide"))});
    const QString port = startPeer(QStringLiteral("--addresses 03"));
    connectPort(port);
    ASSERT_TRUE(answers(at3));
    write(at3, Parameter::lineAddress, 7);
    ASSERT_TRUE(comes([&] { return line().encoder(at7) != nullptr && !line().encoder(at7)->runningJob(); }));
    ASSERT_EQ(encodersOnLine(project()).size(), 1u);
    EXPECT_EQ(encodersOnLine(project())[0].place(), at7);
    EXPECT_EQ(encodersOnLine(project())[0].station, QStringLiteral("Slide"));
    EXPECT_EQ(shown->project().undoStack().undoText(), QStringLiteral("Address of esc:03 to esc:07"));

    connectPort(port);
    EXPECT_EQ(line().places(), std::vector{at7});
    EXPECT_TRUE(answers(at7));
}

TEST_F(EscLineAtPort, ALedgerThatCannotBeUsedIsToldWhenThePortIsOpened)
{
    QFile ledger(folder.filePath(QStringLiteral("eeprom-writes.sqlite")));
    ASSERT_TRUE(ledger.open(QIODevice::WriteOnly) && ledger.write("something else") > 0);
    ledger.close();
    std::vector<MessageCode> told;
    const QObject listener; // ends with this test, before the line
    QObject::connect(&shown->line(), &EscLineAtWork::messaged, &listener,
                     [&](const Message &message) { told.push_back(message.id); });
    plan({test::plannedEncoder(at3)});
    connectPort(startPeer(QStringLiteral("--addresses 03")));
    EXPECT_EQ(std::ranges::count(told, MessageId::notKept), 1);
}

TEST_F(EscLineAtPort, TheTerminalExplainsFactorsInTheFormatOfTheProject)
{
    plan({test::plannedEncoder(at3)});
    Project planned = project();
    changeLine(planned, [](EscLinePlan &line) { line.settings.fractionBits = 28; });
    shown->project().setProject(planned, {});
    connectPort(startPeer(QStringLiteral("--addresses 03")));
    ask(QStringLiteral("03F"));
    EXPECT_TRUE(comes([&] { return isExplained(QStringLiteral("20000000h = 2, outside 0.00001 to 1.0")); }));
}

TEST_F(EscLineAtPort, SwappedWarningBytesAreKeptWithTheEncoder)
{
    plan({test::plannedEncoder(at3), test::plannedEncoder(at5)});
    const QString port = startPeer(QStringLiteral("--addresses 03,05 --warnings 0098"));
    connectPort(port);
    ASSERT_TRUE(answers(at3) && answers(at5));
    window().findChild<StructureView *>()->choose(at3);
    lineActions().swapWarningBytes->trigger();
    EXPECT_TRUE(encodersOnLine(project())[0].its<EscEncoderSettings>().swapsWarningBytes);
    EXPECT_FALSE(encodersOnLine(project())[1].its<EscEncoderSettings>().swapsWarningBytes);
    const auto warnings = [this](Place number) { return line().encoder(number)->latest().warnings; };
    EXPECT_TRUE(comes([&] { return warnings(at3) == 0x9800 && warnings(at5) == 0x0098; }));
    // What is typed is sent once, and on a busy computer its answer may come late: so the polled ones are
    // shown too.
    for (auto *box : terminal().findChildren<QCheckBox *>())
        if (box->text() == QLatin1String("Hide automatic requests"))
            box->setChecked(false);
    ask(QStringLiteral("03E"));
    EXPECT_TRUE(comes([&] {
        return isExplained(
            QStringLiteral("0098h, bytes swapped 9800h: standstill, lower limit switch on, turning CCW"));
    }));

    shown->project().undoStack().undo();
    EXPECT_FALSE(lineActions().swapWarningBytes->isChecked());
    EXPECT_TRUE(comes([&] { return warnings(at3) == 0x0098; }));
    shown->project().undoStack().redo();
    connectPort(port);
    ASSERT_TRUE(answers(at3));
    EXPECT_TRUE(comes([&] { return warnings(at3) == 0x9800; }));
}

TEST_F(EscLineAtPort, SwappedWarningBytesFollowTheEncoderThroughRemovalAndAnotherProject)
{
    plan({test::plannedEncoder(at3)});
    connectPort(startPeer(QStringLiteral("--addresses 03 --warnings 0098")));
    ASSERT_TRUE(answers(at3));
    const auto isSwapped = [this] { return line().explainOptions().swaps(EscLineAddress::of(at3.node)); };
    window().findChild<StructureView *>()->choose(at3);
    lineActions().swapWarningBytes->trigger();
    FoundEncoder found;
    found.address = EscLineAddress::of(at3.node);
    found.baudRate = 19'200;
    const auto takeOver = [&] {
        Q_EMIT window().findChild<EscLineSearch *>()->takeOverWanted({found},
                                                                     QStringLiteral("kuebler-esc-rs485"));
    };
    lineActions().remove->trigger();
    EXPECT_FALSE(isSwapped());
    shown->project().undoStack().undo(); // the project has it again, the line does not
    takeOver();
    EXPECT_TRUE(isSwapped()) << "as the project says";

    shown->project().setProject({}, {});
    EXPECT_TRUE(isSwapped()) << "the line is open as it was";
    takeOver();
    ASSERT_TRUE(linePlan(project(), firstLine));
    EXPECT_TRUE(encodersOnLine(project()).at(0).its<EscEncoderSettings>().swapsWarningBytes);

    shown->project().setProject({}, {});
    window().findChild<StructureView *>()->choose(at3);
    lineActions().swapWarningBytes->trigger();
    EXPECT_FALSE(isSwapped());
    ASSERT_TRUE(linePlan(project(), firstLine)) << "what is told of an encoder takes it into the project";
    EXPECT_FALSE(encodersOnLine(project()).at(0).its<EscEncoderSettings>().swapsWarningBytes);
}

TEST_F(EscLineAtPort, TheFormatThatWasDeterminedIsKept)
{
    plan({test::plannedEncoder(at3), test::plannedEncoder(at5)});
    Project planned = project();
    changeLine(planned, [](EscLinePlan &line) { line.settings.fractionBits = 28; });
    shown->project().setProject(planned, {});
    connectPort(startPeer(QStringLiteral("--addresses 03,05 --silent 03")));
    ASSERT_TRUE(answers(at5));
    ASSERT_TRUE(comes([&] { return line().encoder(at3)->latest().state == EncoderState::silent; }));
    window().findChild<StructureView *>()->choose(test::fraba);
    lineActions().settings->trigger();
    click(form(), QStringLiteral("Determine"));
    ASSERT_TRUE(comes([&] { return linePlan(project(), firstLine)->settings.fractionBits == 29; }))
        << "05 is asked: it answers";
    EXPECT_EQ(line().fractionBits(), 29);
    EXPECT_EQ(form().settings().fractionBits, 29);
    ask(QStringLiteral("05F"));
    EXPECT_TRUE(comes([&] { return isExplained(QStringLiteral("20000000h = 1")); }));
    shown->project().undoStack().undo();
    EXPECT_EQ(project(), [&] {
        Project before = planned;
        changeLine(before, [this](EscLinePlan &line) {
            line.settings.port = linePlan(project(), firstLine)->settings.port;
        });
        return before;
    }());
}

TEST_F(EscLineAtPort, TheFormatIsDeterminedFromTheChosenEncoder)
{
    plan({test::plannedEncoder(at3), test::plannedEncoder(at5)});
    connectPort(startPeer(QStringLiteral("--addresses 03,05")));
    ASSERT_TRUE(answers(at3));
    ASSERT_TRUE(answers(at5));
    std::optional<Place> asked;
    QObject::connect(&line(), &EscLineSession::fractionBitsDetermined, &line(),
                     [&](Place number, const Result<int> &) { asked = number; });
    window().findChild<StructureView *>()->choose(at5);
    lineActions().settings->trigger();
    click(form(), QStringLiteral("Determine"));
    ASSERT_TRUE(comes([&] { return asked.has_value(); }));
    EXPECT_EQ(asked, at5);
}

TEST_F(EscLineAtPort, AfterAnotherBaudRateTheLinesIsOffered)
{
    plan({test::plannedEncoder(at3)});
    connectPort(startPeer(QStringLiteral("--addresses 03")));
    ASSERT_TRUE(answers(at3));
    write(at3, Parameter::baudRate, 9'600);
    lineActions().settings->trigger();
    ASSERT_TRUE(comes([&] { return said().contains(QStringLiteral("esc:03 (at 9600 Bd)")); }))
        << said().toStdString();
    click(form(), QStringLiteral("Set the line to 9600 Bd"));
    EXPECT_EQ(said(), QString());
    EXPECT_EQ(form().settings().serial.baudRate, 9'600);
    EXPECT_EQ(linePlan(project(), firstLine)->settings.serial.baudRate, 9'600);
    shown->project().undoStack().undo();
    EXPECT_EQ(linePlan(project(), firstLine)->settings.serial.baudRate, 19'200);
}

TEST_F(EscLineAtPort, WhereOthersStandAtTheOldBaudRateItIsSaidWhichWillBeSilent)
{
    plan({test::plannedEncoder(at3), test::plannedEncoder(at5)});
    connectPort(startPeer(QStringLiteral("--addresses 03,05")));
    ASSERT_TRUE(answers(at3));
    ASSERT_TRUE(answers(at5));
    write(at3, Parameter::baudRate, 9'600);
    lineActions().settings->trigger();
    ASSERT_TRUE(comes([&] { return said().contains(QStringLiteral("esc:03 (at 9600 Bd)")); }))
        << said().toStdString();
    EXPECT_FALSE(said().contains(QStringLiteral("esc:05")));
    for (const auto *button : form().findChildren<QPushButton *>())
        EXPECT_FALSE(button->isVisibleTo(&form()) && button->text().contains(QStringLiteral("9600")));
}

} // namespace
} // namespace codewheel
