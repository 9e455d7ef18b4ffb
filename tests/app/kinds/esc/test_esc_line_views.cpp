// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/simulator/simulated_esc_line.h"
#include "tests/app/planned_encoder.h"
#include "tests/app/press_connect.h"
#include "tests/app/window_test.h"
#include "tests/support/plans.h"
#include "tests/support/pty_pair.h"
#include "widgets/comparison/comparison_page.h"
#include "widgets/connect/connect_page.h"
#include "widgets/kinds/esc/line/esc_line_panel.h"
#include "widgets/kinds/esc/line/esc_line_search.h"
#include "widgets/kinds/esc/line/esc_line_settings_form.h"
#include "widgets/kinds/esc/line/esc_line_terminal.h"
#include "widgets/kinds/esc/training/esc_line_training_panel.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/models/traffic_model.h"
#include "widgets/structure/structure_model.h"
#include "widgets/structure/structure_view.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTableView>
#include <QTest>
#include <QTreeView>
#include <QWidget>

#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

const Place standingEncoder = placeOnLine({5}); // at 1235h = 4661

class EscLineViewsTest : public test::WindowTest
{
protected:
    EscLineViewsTest() { advance(200); }

    template <typename View>
    View &view()
    {
        return *window().findChild<View *>();
    }
    QPushButton *button(const QWidget &in, const QString &text)
    {
        for (auto *found : in.findChildren<QPushButton *>())
            if (plainLabel(found->text()) == text && found->isVisibleTo(&in))
                return found;
        ADD_FAILURE() << text.toStdString();
        return nullptr;
    }
    QTreeView &tree() { return *window().findChild<QTreeView *>(QStringLiteral("structure")); }
    EscLineSession &line() { return *shown->line().session(); }
    Project project() { return shown->project().project(); }
    // Gives the project these encoders on its line, as the user would plan them.
    void plan(const std::vector<ProjectDevice> &encoders)
    {
        Project planned = project();
        setEncodersOnLine(planned, encoders);
        shown->project().setProject(planned, {});
    }
    static FoundEncoder found(EscLineAddress address, int baudRate)
    {
        FoundEncoder one;
        one.address = address;
        one.baudRate = baudRate;
        return one;
    }
    ConnectPage &connection() { return *window().findChild<ConnectPage *>(QStringLiteral("lineSettings")); }
    // As the user connects it; positions are polled only rarely.
    void connectPort(const QString &port)
    {
        lineActions().settings->trigger();
        test::chooseSerialPort(connection());
        auto &form = view<EscLineSettingsForm>();
        EscLineSettings settings = form.settings();
        settings.port = port;
        settings.pollInterval = std::chrono::milliseconds(500);
        form.setSettings(settings);
        test::pressConnect(connection());
        EXPECT_TRUE(QTest::qWaitFor([this] { return !shown->line().isOpening(); }));
        advance(50);
    }
    bool hasRow(const QString &text)
    {
        for (auto *table : view<EscLineTerminal>().findChildren<QTableView *>())
            for (int row = 0; row < table->model()->rowCount(); ++row)
                for (int column = 0; column < table->model()->columnCount(); ++column)
                    if (table->model()->index(row, column).data().toString().contains(text))
                        return true;
        return false;
    }
};

TEST_F(EscLineViewsTest, TheKeyOpensTheTerminalAndARequestIsTypedThere)
{
    QTest::keyClick(&window(), Qt::Key_F8, Qt::ShiftModifier);
    advance(50);
    ASSERT_TRUE(view<EscLineTerminal>().isVisible());
    QWidget *field = QApplication::focusWidget();
    ASSERT_TRUE(view<EscLineTerminal>().isAncestorOf(field));
    QTest::keyClicks(field, QStringLiteral("05N"));
    QTest::keyClick(field, Qt::Key_Escape); // the list of commands
    QTest::keyClick(field, Qt::Key_Return);
    advance(200);
    EXPECT_TRUE(hasRow(QStringLiteral("serial number?")));
}

TEST_F(EscLineViewsTest, WhatWasTypedIsThereAfterTheNextStart)
{
    view<EscLineTerminal>().setHistory({QStringLiteral("05N")});
    Q_EMIT view<EscLineTerminal>().historyChanged();
    window().close();
    advance(5);
    open();
    EXPECT_EQ(view<EscLineTerminal>().history(), QStringList{QStringLiteral("05N")});
}

TEST_F(EscLineViewsTest, EnterOnTheLineOpensItsFiguresAndOnAnEncoderTheTerminal)
{
    view<StructureView>().choose(firstLine);
    tree().setFocus();
    QTest::keyClick(&tree(), Qt::Key_Return);
    advance(50);
    EXPECT_TRUE(view<EscLinePanel>().isVisible());
    EXPECT_FALSE(view<EscLinePanel>().visibleRegion().isEmpty());
    view<StructureView>().choose(standingEncoder);
    tree().setFocus();
    QTest::keyClick(&tree(), Qt::Key_Return);
    advance(50);
    EXPECT_FALSE(view<EscLineTerminal>().visibleRegion().isEmpty());
}

TEST_F(EscLineViewsTest, WhatIsFoundIsTakenOver)
{
    ASSERT_TRUE(line().remove(standingEncoder));
    advance(50);
    const auto *model = static_cast<const StructureModel *>(tree().model());
    ASSERT_FALSE(model->indexOf(standingEncoder).isValid());
    lineActions().search->trigger();
    ASSERT_TRUE(view<EscLineSearch>().isVisible());
    QTest::mouseClick(button(view<EscLineSearch>(), QStringLiteral("Search")), Qt::LeftButton);
    advance(20'000);
    QTest::mouseClick(button(view<EscLineSearch>(), QStringLiteral("Take over")), Qt::LeftButton);
    advance(100);
    EXPECT_TRUE(model->indexOf(standingEncoder).isValid());
    EXPECT_EQ(model->rowCount(model->indexOf(firstLine)), 3);
    EXPECT_FALSE(linePlan(project(), firstLine)) << "they are no more than simulated";
}

TEST_F(EscLineViewsTest, WhatIsFoundAtAPortIsKeptInTheProject)
{
    PtyPair pty;
    connectPort(pty.path());
    Q_EMIT view<EscLineSearch>().takeOverWanted({found({7}, 19'200)}, QStringLiteral("kuebler-esc-rs485"));
    EXPECT_EQ(line().places(), std::vector{placeOnLine({7})});
    ASSERT_TRUE(linePlan(project(), firstLine));
    EXPECT_EQ(encodersOnLine(project()), std::vector{test::plannedEncoder(placeOnLine({7}))});
}

TEST_F(EscLineViewsTest, AnotherProjectTakesOverTheLineAsItIsOpen)
{
    PtyPair pty;
    EscLinePlan slow;
    slow.settings.serial.baudRate = 9'600;
    Project slowProject = project();
    setLinePlan(slowProject, firstLine, slow);
    shown->project().setProject(slowProject, {});
    connectPort(pty.path());
    EXPECT_EQ(view<EscLineSearch>().wish().baudRates, std::vector{9'600});
    shown->project().setProject({}, {});
    ASSERT_FALSE(linePlan(project(), firstLine));
    Q_EMIT view<EscLineSearch>().takeOverWanted({found({7}, 9'600)}, QStringLiteral("kuebler-esc-rs485"));
    ASSERT_TRUE(linePlan(project(), firstLine));
    EXPECT_EQ(linePlan(project(), firstLine)->settings.serial.baudRate, 9'600);
    EXPECT_EQ(linePlan(project(), firstLine)->settings.port, pty.path());
    EXPECT_EQ(encodersOnLine(project()), std::vector{test::plannedEncoder(placeOnLine({7}))});
}

TEST_F(EscLineViewsTest, WhatAnswersAtAnotherBaudRateIsNotTakenOverAndThatIsSaid)
{
    lineActions().search->trigger();
    const auto before = line().places();
    const auto steps = shown->project().project();
    Q_EMIT view<EscLineSearch>().takeOverWanted({found({8}, 9'600)}, QStringLiteral("kuebler-esc-rs485"));
    EXPECT_EQ(line().places(), before);
    EXPECT_EQ(shown->project().project(), steps);
    const auto *message = view<EscLineSearch>().findChild<InlineMessage *>();
    ASSERT_TRUE(message->isVisible());
    EXPECT_TRUE(message->sentence().contains(QStringLiteral("08h (8)")));
}

TEST_F(EscLineViewsTest, AnEncoderIsRemovedFromLineAndProject)
{
    plan({test::plannedEncoder(standingEncoder), test::plannedEncoder(placeOnLine({7}))});
    PtyPair pty;
    connectPort(pty.path());
    view<StructureView>().choose(standingEncoder);
    advance(50);
    EXPECT_TRUE(lineActions().remove->isEnabled());
    lineActions().remove->trigger();
    advance(50);
    EXPECT_EQ(line().encoder(standingEncoder), nullptr);
    EXPECT_EQ(encodersOnLine(project()), std::vector{test::plannedEncoder(placeOnLine({7}))});
    view<StructureView>().choose(test::fraba);
    EXPECT_FALSE(lineActions().remove->isEnabled());
}

TEST_F(EscLineViewsTest, ThatAnEncoderAtAJobIsNotRemovedIsTold)
{
    view<StructureView>().choose(standingEncoder);
    advance(50);
    ASSERT_TRUE(line().encoder(standingEncoder)->start(ReadParameters{{Parameter::warnings}}));
    lineActions().remove->trigger();
    const auto *notice = window().findChild<InlineMessage *>(QStringLiteral("notice"));
    ASSERT_NE(line().encoder(standingEncoder), nullptr);
    EXPECT_TRUE(notice->isVisible());
    EXPECT_TRUE(notice->sentence().startsWith(QStringLiteral("A job is running at esc:05")));
    advance(2000);
    EXPECT_FALSE(notice->isVisible()) << "the job has ended";
}

TEST_F(EscLineViewsTest, RemovedFromTheTrainingLineTheProjectsOwnStays)
{
    plan({test::plannedEncoder(standingEncoder)});
    view<StructureView>().choose(standingEncoder);
    advance(50);
    lineActions().remove->trigger();
    advance(50);
    EXPECT_EQ(line().encoder(standingEncoder), nullptr);
    EXPECT_EQ(encodersOnLine(project()), std::vector{test::plannedEncoder(standingEncoder)});
}

TEST_F(EscLineViewsTest, NoTrainingEncoderIsTakenAlongToAPort)
{
    ASSERT_EQ(line().places().size(), 3u);
    PtyPair pty;
    connectPort(pty.path());
    EXPECT_TRUE(line().places().empty());
    EXPECT_TRUE(encodersOnLine(project()).empty());
}

TEST_F(EscLineViewsTest, ThePortOfAnEncoderIsConnectedInWatch)
{
    plan({test::plannedEncoder(standingEncoder, QStringLiteral("Slide")),
          test::plannedEncoder(placeOnLine({7}))});
    PtyPair pty;
    connectPort(pty.path());
    ASSERT_NE(shown->line().session(), nullptr);
    EXPECT_EQ(line().linkName(), pty.path());
    EXPECT_EQ(shown->line().training(), nullptr);
    EXPECT_FALSE(line().isOperating());
    EXPECT_TRUE(bus().isOperating()) << "the ring has its own";
    EXPECT_EQ(linePlan(project(), firstLine)->settings, view<EscLineSettingsForm>().settings());
    EXPECT_EQ(line().places(), (std::vector{standingEncoder, placeOnLine({7})}))
        << "the encoders of the project";
    EXPECT_EQ(findDevice(project(), standingEncoder)->station, QStringLiteral("Slide"));

    lineActions().disconnectBus->trigger();
    advance(50);
    EXPECT_EQ(shown->line().session(), nullptr);
    EXPECT_FALSE(lineActions().disconnectBus->isEnabled());
    lineActions().training->trigger();
    advance(200);
    EXPECT_NE(shown->line().training(), nullptr);
    EXPECT_EQ(line().encoder(standingEncoder)->latest().position, 0x1235);
}

TEST_F(EscLineViewsTest, APortThatIsNotThereIsToldOnTheSpotAndTheLineGoesOn)
{
    lineActions().settings->trigger();
    test::chooseSerialPort(connection());
    auto &form = view<EscLineSettingsForm>();
    EscLineSettings settings = form.settings();
    settings.port = QStringLiteral("/dev/there-is-none");
    form.setSettings(settings);
    test::pressConnect(connection());
    EXPECT_TRUE(QTest::qWaitFor([this] { return !shown->line().isOpening(); }));
    bool isTold = false;
    for (const auto *message : connection().findChildren<InlineMessage *>())
        isTold = isTold || message->sentence().contains(QStringLiteral("/dev/there-is-none"));
    EXPECT_TRUE(isTold);
    EXPECT_NE(shown->line().training(), nullptr);
    EXPECT_TRUE(line().isOperating());
}

TEST_F(EscLineViewsTest, WithoutItsAdapterTheComparisonSaysHowTheLineWas)
{
    view<StructureView>().choose(firstLine);
    advance(2'000);
    window().showComparison();
    advance(50);
    const auto shownPage = [this] {
        for (auto *each : window().findChildren<ComparisonPage *>())
            if (each->isVisible())
                return each;
        return static_cast<ComparisonPage *>(nullptr);
    };
    ASSERT_NE(shownPage(), nullptr);
    const auto &summary = *shownPage()->findChild<QLabel *>(QStringLiteral("comparisonSummary"));
    EXPECT_EQ(summary.text(), QStringLiteral("3 lines differ."));
    shown->line().training()->setUnplugged(true);
    advance(3'000);
    EXPECT_TRUE(
        summary.text().startsWith(QStringLiteral("3 lines differed. The link is lost. Shown is how it was ")))
        << summary.text().toStdString();
    const auto &structure = *tree().model();
    const QModelIndexList found =
        structure.match(structure.index(0, 0), Qt::DisplayRole, QStringLiteral("12"), 1,
                        Qt::MatchContains | Qt::MatchRecursive);
    ASSERT_FALSE(found.isEmpty());
    const QModelIndex position = found.front().siblingAtColumn(StructureModel::positionColumn);
    EXPECT_TRUE(position.data(Qt::AccessibleTextRole).toString().endsWith(QStringLiteral("not up to date")))
        << position.data().toString().toStdString();
    shown->line().training()->setUnplugged(false);
    advance(4'000);
    EXPECT_EQ(summary.text(), QStringLiteral("3 lines differ."));
}

TEST_F(EscLineViewsTest, TheTrainerDisturbsTheLine)
{
    auto &panel = view<EscLineTrainingPanel>();
    window().findChild<QDockWidget *>(QStringLiteral("trainingDock"))->raise();
    view<StructureView>().choose(firstLine);
    advance(50);
    const auto box = [&](const QString &text) -> QCheckBox * {
        for (auto *found : panel.findChildren<QCheckBox *>())
            if (found->text() == text && found->isVisibleTo(&panel))
                return found;
        return nullptr;
    };
    ASSERT_NE(box(QStringLiteral("Adapter unplugged")), nullptr);
    box(QStringLiteral("Adapter unplugged"))->click();
    advance(300);
    EXPECT_FALSE(line().latest().connected);
    box(QStringLiteral("Adapter unplugged"))->click();
    advance(3000);
    EXPECT_TRUE(line().latest().connected) << "it is looked for";

    view<StructureView>().choose(standingEncoder);
    advance(50);
    ASSERT_NE(box(QStringLiteral("Battery flat")), nullptr);
    box(QStringLiteral("Battery flat"))->click();
    advance(3000);
    EXPECT_EQ(line().encoder(standingEncoder)->latest().alarms, 0x4000);
    view<StructureView>().choose(test::fraba);
    advance(50);
    EXPECT_FALSE(panel.isVisible()) << "the ring has its own";
}

TEST_F(EscLineViewsTest, BytesThatAreLostAreCountedAndSeen)
{
    auto &panel = view<EscLineTrainingPanel>();
    view<StructureView>().choose(firstLine);
    advance(50);
    for (auto *field : panel.findChildren<QSpinBox *>())
        if (field->accessibleName().startsWith(QStringLiteral("Lost bytes")))
            field->setValue(100);
    EXPECT_EQ(shown->line().training()->faults().lost, 100);
    advance(2000);
    EXPECT_GT(line().latest().figures.timeOuts, 0u);
}

// At the desk, before anybody is at the machine.
TEST_F(EscLineViewsTest, APortIsPlannedWithoutBeingOpened)
{
    lineActions().settings->trigger();
    test::chooseSerialPort(connection());
    auto &form = view<EscLineSettingsForm>();
    EXPECT_FALSE(button(connection(), QStringLiteral("Keep in project"))->isEnabled())
        << "the training line is open";
    lineActions().disconnectBus->trigger();
    advance(50);
    EscLineSettings settings = form.settings();
    settings.port = QStringLiteral("/dev/ttyHALL");
    settings.serial.baudRate = 4800;
    form.setSettings(settings);
    const int steps = shown->project().undoStack().index();
    button(connection(), QStringLiteral("Keep in project"))->click();
    EXPECT_EQ(linePlan(project(), firstLine)->settings.port, QStringLiteral("/dev/ttyHALL"));
    EXPECT_EQ(linePlan(project(), firstLine)->settings.serial.baudRate, 4800);
    EXPECT_EQ(shown->project().undoStack().index(), steps + 1);
    EXPECT_EQ(form.settings().port, QStringLiteral("/dev/ttyHALL"));
    EXPECT_EQ(shown->line().session(), nullptr) << "nothing is opened";
    shown->project().undoStack().undo();
    const EscLinePlan *before = linePlan(project(), firstLine);
    EXPECT_TRUE(before == nullptr || before->settings.port.isEmpty());
}

// The project page says so of it, too.
TEST_F(EscLineViewsTest, ALineThatIsPlannedWithoutAPortIsTheTrainingLine)
{
    lineActions().disconnectBus->trigger();
    advance(50);
    Project planned = project();
    setLinePlan(planned, firstLine, EscLinePlan{});
    shown->project().setProject(planned, {});
    lineActions().settings->trigger();
    const auto &link = *connection().findChild<QComboBox *>(QStringLiteral("link"));
    EXPECT_EQ(link.currentText(), QStringLiteral("Training line"));
    EscLinePlan atPort;
    atPort.settings.port = QStringLiteral("/dev/ttyHALL");
    setLinePlan(planned, firstLine, atPort);
    shown->project().setProject(planned, {});
    EXPECT_NE(link.currentText(), QStringLiteral("Training line"));

    shown->project().setProject({}, {});
    Project added = shown->project().project(); // as by Add on the project page
    setLinePlan(added, firstLine, EscLinePlan{});
    shown->project().edit(added, QStringLiteral("Add"));
    EXPECT_EQ(link.currentText(), QStringLiteral("Training line"));
}

TEST_F(EscLineViewsTest, WhatIsWantedForAnEncoderThatItsPlannedLineLacksIsToldWhenSaved)
{
    ProjectDevice planned;
    planned.standAt(placeOnLine({3}));
    planned.participant.deviceKey = QStringLiteral("kuebler-esc-rs485");
    plan({planned});
    shown->project().setFile(folder.filePath(QStringLiteral("line.codewheel")));
    shown->project().editDevice(standingEncoder, QStringLiteral("Steps"), [](ProjectDevice &device) {
        device.wanted = {{Parameter::steps, 100}};
    });
    actions().saveProject->trigger();
    const QString notice = window().findChild<InlineMessage *>(QStringLiteral("notice"))->sentence();
    EXPECT_TRUE(notice.startsWith(QStringLiteral("What is planned for esc:05 is in no file")))
        << notice.toStdString();
    EXPECT_TRUE(notice.contains(QStringLiteral("F9"))) << notice.toStdString();
    EXPECT_TRUE(window().isWindowModified());
}

TEST_F(EscLineViewsTest, TheTerminalKeepsAsManyRowsAsTheSettingsSay)
{
    QSettings(folder.filePath(QStringLiteral("window.ini")), QSettings::IniFormat)
        .setValue(QStringLiteral("trace/mostRows"), 1'000);
    open();
    advance(60'000);
    const auto *rows = view<EscLineTerminal>().findChild<TrafficModel *>();
    EXPECT_LE(rows->rowCount() + rows->waiting(), 1'000);
    EXPECT_GT(rows->rowCount() + rows->waiting(), 500) << "of some thousands";
}

} // namespace
} // namespace codewheel
