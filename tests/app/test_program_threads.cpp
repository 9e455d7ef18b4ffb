// SPDX-License-Identifier: GPL-3.0-or-later
// The running program: the bus at 1 ms in its own thread, two monitors, a wizard's job, starts and stops.
// Meant for ThreadSanitizer; every wait is for an event.
#include "app/window/buses/plant.h"
#include "app/window/kinds/interbus/ring_actions.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "app/window/main_window.h"
#include "app/window/program.h"
#include "app/window/recording/recordings.h"
#include "kinds/interbus/ring/ring_session.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "project/project_file.h"
#include "tests/app/window_test.h"
#include "tests/replay/replay_recording.h"
#include "widgets/monitor/monitor_area.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/replay/replay_bar.h"
#include "widgets/structure/structure_view.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QAbstractButton>
#include <QApplication>
#include <QLocale>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

constexpr int generous = 60'000; // ms; sanitizers are slow

class RunningProgram : public testing::Test
{
protected:
    RunningProgram()
    {
        program.openWindow();
        program.window()->show();
        EXPECT_TRUE(QTest::qWaitFor([this] { return program.plant() != nullptr; }, generous));
    }

    RingSession &bus() { return *program.plant()->first<RingAtWork>()->bus(); }
    bool waitFor(const std::function<bool()> &what) { return QTest::qWaitFor(what, generous); }

    void click(const QString &button)
    {
        auto *found = program.window()->findChild<QAbstractButton *>(button);
        ASSERT_TRUE(found != nullptr && waitFor([found] { return found->isEnabled(); }))
            << button.toStdString();
        found->click();
    }
    void runTheWizard()
    {
        auto *wanted = program.window()->findChild<WantedValues *>();
        wanted->set(fraba, Parameter::steps, 255);
        wanted->set(fraba, Parameter::revolutions, 1);
        program.window()->showWizard();
        auto *wizard = program.window()->findChild<ParameterWizard *>();
        while (wizard->page() < ParameterWizard::review)
            click(QStringLiteral("wizardNext"));
        click(QStringLiteral("byItself"));
        std::optional<Outcome> outcome;
        QObject::connect(bus().encoder(fraba), &EncoderSession::finished, wizard,
                         [&](const Outcome &end) { outcome = end; });
        click(QStringLiteral("wizardNext"));
        ASSERT_TRUE(waitFor([&] { return outcome.has_value(); }));
        EXPECT_TRUE(outcome->result);
        program.window()->showMonitors();
    }

    QTemporaryDir folder;
    Program program{*qApp, folder.filePath(QStringLiteral("program.ini"))};
};

TEST_F(RunningProgram, TwoMonitorsARunOfTheWizardAndFiftyStartsAndStops)
{
    auto *monitors = program.window()->findChild<MonitorArea *>();
    for (const Place number : {fraba, baumer})
        monitors->pin(number);
    program.plant()->first<RingAtWork>()->controls().setSpeed(fraba.node, 300);
    ASSERT_TRUE(waitFor([this] { return bus().latest().cycle > 100; }));

    runTheWizard();
    EXPECT_EQ(bus().encoder(fraba)->known(Parameter::steps)->value, 255);

    for (int i = 0; i < 50; ++i) {
        program.window()->actions().stop->trigger();
        ASSERT_TRUE(waitFor([this] { return !bus().isRunning(); })) << i;
        program.window()->actions().start->trigger();
        ASSERT_TRUE(waitFor([this] { return bus().isRunning(); })) << i;
    }
    const std::uint64_t cycle = bus().latest().cycle;
    EXPECT_TRUE(waitFor([&] { return bus().latest().cycle > cycle; }));
}

TEST_F(RunningProgram, AnotherLanguageMakesTheWindowAnewWhileTheBusGoesOn)
{
    const QLocale before;
    const RingSession *session = program.plant()->first<RingAtWork>()->bus();
    const std::uint64_t cycle = bus().latest().cycle;
    auto *wanted = program.window()->findChild<WantedValues *>();
    wanted->set(fraba, Parameter::steps, 255);
    Q_EMIT program.window()->languageChosen(QStringLiteral("de"));
    ASSERT_TRUE(waitFor([this] {
        return program.window()->findChild<MonitorArea *>() != nullptr &&
               QLocale().language() == QLocale::German;
    }));
    EXPECT_EQ(program.plant()->first<RingAtWork>()->bus(), session);
    wanted = program.window()->findChild<WantedValues *>();
    EXPECT_EQ(wanted->value(fraba, Parameter::steps), 255);
    program.window()->actions().undo->trigger();
    EXPECT_EQ(wanted->value(fraba, Parameter::steps), std::nullopt) << "undo goes on as well";
    EXPECT_TRUE(waitFor([&] { return bus().latest().cycle > cycle; }));
    EXPECT_EQ(program.window()->findChild<MonitorArea *>()->cards().size(), 1u);
    Q_EMIT program.window()->languageChosen(QStringLiteral("en"));
    ASSERT_TRUE(waitFor([] { return QLocale().language() == QLocale::English; }));
    QLocale::setDefault(before);
}

TEST_F(RunningProgram, AnotherLanguageKeepsTheRecordingsThatAreOpenAndPlaysOn)
{
    const QLocale before;
    const test::ReplayRecording recording;
    ASSERT_TRUE(program.window()->openRecording(recording.path));
    const auto playback = program.plant()->recordings().all().front().playback;
    playback->play(Playback::Direction::forward);
    Q_EMIT program.window()->languageChosen(QStringLiteral("de"));
    ASSERT_TRUE(waitFor([this] {
        return program.window()->findChild<ReplayBar *>() != nullptr &&
               QLocale().language() == QLocale::German;
    }));
    EXPECT_EQ(program.window()->findChild<ReplayBar *>()->accessibleName(), QStringLiteral("Aufzeichnung"));
    const Instant position = playback->position();
    EXPECT_TRUE(waitFor([&] { return playback->position() > position; })) << "by its clock";
    Q_EMIT program.window()->languageChosen(QStringLiteral("en"));
    ASSERT_TRUE(waitFor([] { return QLocale().language() == QLocale::English; }));
    QLocale::setDefault(before);
}

TEST_F(RunningProgram, EveryBusIsOpenedByItsThread)
{
    const auto isOpen = [this](BusId bus) { return program.plant()->find(bus)->isOpen(); };
    EXPECT_TRUE(waitFor([&] { return isOpen(firstBus) && isOpen(firstLine); }));
    constexpr BusId secondRing{3};
    ProjectDocument &project = program.plant()->find(firstBus)->project();
    Project plan = project.project();
    planBus(plan, secondRing, *busKind(u"interbus"));
    ProjectDevice device = plan.devices.front();
    device.bus = secondRing;
    setDevicesOn(plan, secondRing, {device});
    project.edit(std::move(plan), {});
    program.window()->findChild<StructureView *>()->choose(secondRing);
    program.window()->findChild<RingActions *>()->connectBus->trigger();
    EXPECT_TRUE(waitFor([&] { return isOpen(secondRing); }));
    program.window()->findChild<RingActions *>()->disconnectBus->trigger();
    EXPECT_TRUE(waitFor([&] { return !isOpen(secondRing); }));
    EXPECT_TRUE(isOpen(firstBus));
}

TEST_F(RunningProgram, ABusThatWasNotConnectedForAWhileHasTheTimeOfTheDay)
{
    const auto isRight = [this] {
        return bus().dateTime(bus().now()).msecsTo(QDateTime::currentDateTime()) < 1'000;
    };
    EXPECT_TRUE(waitFor(isRight));
    const auto &actions = *program.window()->findChild<RingActions *>();
    actions.disconnectBus->trigger();
    ASSERT_TRUE(waitFor([this] { return !bus().isOpen(); }));
    QTest::qWait(2'000);
    EXPECT_FALSE(isRight()) << "its clock stands still";
    actions.connectBus->trigger();
    ASSERT_TRUE(waitFor([this] { return bus().isOpen(); }));
    EXPECT_TRUE(QTest::qWaitFor(isRight, 10'000));
}

TEST(ProgramStart, OpensTheFileItIsGiven)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("crane.codewheel"));
    Project project;
    project.title = QStringLiteral("Crane");
    ASSERT_TRUE(saveProject(project, file));
    Program program(*qApp, folder.filePath(QStringLiteral("program.ini")));
    program.openAtStart(file);
    program.openWindow();
    program.window()->show();
    ASSERT_TRUE(QTest::qWaitFor([&] { return program.plant() != nullptr; }, generous));
    EXPECT_EQ(program.window()->windowTitle(), QStringLiteral("crane.codewheel[*]"));
}

} // namespace
} // namespace codewheel
