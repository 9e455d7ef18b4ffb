// SPDX-License-Identifier: GPL-3.0-or-later
// Faults that arrive while another program is in front: the desktop is told, by a notification service that
// shares no code with the program.
#include "app/window/buses/plant.h"
#include "app/window/faults/unseen_faults.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "app/window/main_window.h"
#include "app/window/program.h"
#include "app/window/settings_at_work.h"
#include "app/window/window_actions.h"
#include "kinds/esc/protocol/esc_messages.h"
#include "tests/app/desktop_bus.h"
#include "tests/support/places.h"
#include "widgets/settings/settings_dialog.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QElapsedTimer>
#include <QJsonObject>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr int longestNoticeWait = 60'000; // ms
constexpr int noBlock = 1'000;            // ms; a blocking call would wait for seconds
const QString notify = QStringLiteral("Notify");

QStringList withAll()
{
    return {QStringLiteral("--capabilities"), QStringLiteral("actions,body,body-markup,sound")};
}

// As the arguments of Notify.
QString titleOf(const QJsonArray &call)
{
    return call.at(3).toString();
}
QString bodyOf(const QJsonArray &call)
{
    return call.at(4).toString();
}
QJsonObject hintsOf(const QJsonArray &call)
{
    return call.at(6).toObject();
}

Message fault(Place place, MessageCode id = EscMessageId::portLost)
{
    return {
        .place = place, .severity = Severity::fault, .id = id, .arguments = {QStringLiteral("/dev/ttyUSB0")}};
}

std::unique_ptr<QWidget> windowInFront()
{
    auto window = std::make_unique<QWidget>();
    window->show();
    window->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(window.get()));
    return window;
}

class UnseenFaultsTest : public testing::Test
{
protected:
    QJsonArray last() { return desktop.calls(notify).back(); }

    test::DesktopBus desktop;
};

TEST_F(UnseenFaultsTest, AreToldWithTheirPlaceAndTheirSentence)
{
    desktop.serve(withAll());
    UnseenFaults faults;
    faults.take(fault("1.0"_ring));
    ASSERT_TRUE(desktop.waitForCalls(notify, 1));
    EXPECT_EQ(titleOf(last()), QStringLiteral("Fault: 1.0"));
    EXPECT_TRUE(bodyOf(last()).contains(QStringLiteral("/dev/ttyUSB0"))) << bodyOf(last()).toStdString();
    EXPECT_EQ(last().at(5).toArray().first().toString(), QStringLiteral("default")) << "a click is an action";
    EXPECT_TRUE(hintsOf(last()).value(QStringLiteral("suppress-sound")).toBool());
    EXPECT_FALSE(hintsOf(last()).contains(QStringLiteral("sound-name")));
}

TEST_F(UnseenFaultsTest, OtherMessagesAreNotTold)
{
    desktop.serve(withAll());
    UnseenFaults faults;
    Message attention = fault("1.0"_ring);
    attention.severity = Severity::attention;
    faults.take(attention);
    faults.take(fault("2.0"_ring));
    ASSERT_TRUE(desktop.waitForCalls(notify, 1));
    EXPECT_EQ(titleOf(last()), QStringLiteral("Fault: 2.0"));
}

TEST_F(UnseenFaultsTest, SeveralAreOneNoticeThatTakesThePlaceOfTheFirst)
{
    desktop.serve(withAll());
    UnseenFaults faults(1'000ms);
    for (const Place place : {"1.0"_ring, "2.0"_ring, "3.0"_ring})
        faults.take(fault(place));
    QElapsedTimer sinceFirst;
    ASSERT_TRUE(desktop.waitForCalls(notify, 1));
    sinceFirst.start();
    EXPECT_EQ(titleOf(last()), QStringLiteral("Fault: 1.0"));
    ASSERT_TRUE(desktop.waitForCalls(notify, 2));
    EXPECT_GT(sinceFirst.elapsed(), 500) << "not at once";
    EXPECT_EQ(titleOf(last()), QStringLiteral("3 faults, the last: 3.0"));
    EXPECT_EQ(last().at(1).toInt(), 1) << "the same notice";
    QTest::qWait(1'500);
    EXPECT_EQ(desktop.calls(notify).size(), 2u);
}

TEST_F(UnseenFaultsTest, WithAWindowInFrontNothingIsToldAndWhatWasToldGoes)
{
    desktop.serve(withAll());
    UnseenFaults faults(10ms);
    faults.take(fault("1.0"_ring));
    ASSERT_TRUE(desktop.waitForCalls(notify, 1));
    QTest::qWait(100); // the answer arrives
    auto inFront = windowInFront();
    EXPECT_TRUE(desktop.waitForCalls(QStringLiteral("CloseNotification"), 1));
    faults.take(fault("2.0"_ring));
    inFront.reset();
    ASSERT_EQ(QGuiApplication::focusWindow(), nullptr);
    QTest::qWait(100);
    EXPECT_EQ(desktop.calls(notify).size(), 1u);
    faults.take(fault("3.0"_ring));
    ASSERT_TRUE(desktop.waitForCalls(notify, 2));
    EXPECT_EQ(titleOf(last()), QStringLiteral("Fault: 3.0")) << "counted anew";
}

TEST_F(UnseenFaultsTest, TheSoundIsThatOfTheDesktopForErrors)
{
    desktop.serve(withAll());
    UnseenFaults faults;
    faults.setWishes(true, true);
    const QSignalSpy beeps(&faults, &UnseenFaults::beepWanted);
    faults.take(fault("1.0"_ring));
    ASSERT_TRUE(desktop.waitForCalls(notify, 1));
    EXPECT_EQ(hintsOf(last()).value(QStringLiteral("sound-name")).toString(), QStringLiteral("dialog-error"));
    QTest::qWait(100);
    EXPECT_EQ(beeps.count(), 0);
}

TEST_F(UnseenFaultsTest, ADesktopWithoutSoundsActionsAndMarkupGetsNoneOfThem)
{
    desktop.serve({QStringLiteral("--capabilities"), QStringLiteral("body")});
    UnseenFaults faults;
    faults.setWishes(true, true);
    QSignalSpy beeps(&faults, &UnseenFaults::beepWanted);
    Message odd = fault("1.0"_ring);
    odd.arguments = {QStringLiteral("<b>&")};
    faults.take(odd);
    ASSERT_TRUE(desktop.waitForCalls(notify, 1));
    EXPECT_TRUE(bodyOf(last()).contains(QStringLiteral("<b>&"))) << bodyOf(last()).toStdString();
    EXPECT_TRUE(last().at(5).toArray().isEmpty());
    EXPECT_EQ(beeps.count(), 1);
}

TEST_F(UnseenFaultsTest, WhatLooksLikeMarkupIsNone)
{
    desktop.serve(withAll());
    UnseenFaults faults;
    Message odd = fault("1.0"_ring);
    odd.arguments = {QStringLiteral("<b>&")};
    faults.take(odd);
    ASSERT_TRUE(desktop.waitForCalls(notify, 1));
    EXPECT_TRUE(bodyOf(last()).contains(QStringLiteral("&lt;b&gt;&amp;"))) << bodyOf(last()).toStdString();
}

// The user is called by other means, and nothing is waited for.
TEST_F(UnseenFaultsTest, AServiceThatNeverAnswersHoldsNothingUp)
{
    desktop.serve({QStringLiteral("--mute")});
    UnseenFaults faults(10ms);
    faults.setWishes(true, true);
    QSignalSpy told(&faults, &UnseenFaults::told);
    QSignalSpy beeps(&faults, &UnseenFaults::beepWanted);
    QElapsedTimer clock;
    clock.start();
    faults.take(fault("1.0"_ring));
    EXPECT_LT(clock.elapsed(), noBlock);
    EXPECT_EQ(told.count(), 1);
    clock.restart();
    int turns = 0;
    while (desktop.calls(QStringLiteral("GetCapabilities")).empty() || turns < 100) {
        QElapsedTimer turn;
        turn.start();
        QTest::qWait(1);
        ASSERT_LT(turn.elapsed(), noBlock);
        ++turns;
        ASSERT_LT(clock.elapsed(), longestNoticeWait);
    }
    faults.take(fault("2.0"_ring));
    ASSERT_TRUE(QTest::qWaitFor([&] { return beeps.count() > 0; }, longestNoticeWait));
}

TEST_F(UnseenFaultsTest, WithoutAServiceOnlyTheTaskBarAndTheBeepAreLeft)
{
    UnseenFaults faults;
    faults.setWishes(true, true);
    QSignalSpy told(&faults, &UnseenFaults::told);
    QSignalSpy beeps(&faults, &UnseenFaults::beepWanted);
    faults.take(fault("1.0"_ring));
    EXPECT_EQ(told.count(), 1);
    EXPECT_TRUE(QTest::qWaitFor([&] { return beeps.count() == 1; }, longestNoticeWait));
}

TEST(UnseenFaultsWithoutADesktop, AreToldByTaskBarAndBeep)
{
    UnseenFaults faults;
    faults.setWishes(true, true);
    const QSignalSpy told(&faults, &UnseenFaults::told);
    const QSignalSpy beeps(&faults, &UnseenFaults::beepWanted);
    faults.take(fault("1.0"_ring));
    EXPECT_EQ(told.count(), 1);
    EXPECT_EQ(beeps.count(), 1);
}

// The running program, behind the windows of others.
class ProgramBehind : public UnseenFaultsTest
{
protected:
    ProgramBehind()
    {
        desktop.serve(withAll());
        program = std::make_unique<Program>(*qApp, folder.filePath(QStringLiteral("program.ini")));
        program->openWindow();
        program->window()->show();
        EXPECT_TRUE(QTest::qWaitFor([this] { return program->plant() != nullptr; }, longestNoticeWait));
        EXPECT_TRUE(QTest::qWaitFor([this] { return ring().bus()->isRunning(); }, longestNoticeWait));
        program->window()->activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(program->window()));
    }
    RingAtWork &ring() { return *program->plant()->first<RingAtWork>(); }
    // The offscreen platform leaves a window active until another one was, and is gone.
    static void goBehind()
    {
        windowInFront();
        EXPECT_EQ(QGuiApplication::focusWindow(), nullptr);
    }
    void cutTheCable() { ring().controls().setFault(TrainingFault::wireBreak, NodeId("4.0"), 1); }
    void tick(const char *box, bool on)
    {
        program->window()->actions().settings->trigger();
        auto *dialog = program->window()->findChild<SettingsDialog *>();
        auto *its = dialog->findChild<QCheckBox *>(QLatin1String(box));
        ASSERT_TRUE(its->isEnabled());
        its->setChecked(on);
        dialog->accept();
    }

    QTemporaryDir folder;
    std::unique_ptr<Program> program;
};

TEST_F(ProgramBehind, TellsWhatFailsAndComesToTheFrontOnAClick)
{
    goBehind();
    cutTheCable();
    ASSERT_TRUE(desktop.waitForCalls(notify, 1));
    EXPECT_TRUE(titleOf(last()).startsWith(QStringLiteral("Fault: "))) << titleOf(last()).toStdString();
    EXPECT_FALSE(bodyOf(last()).isEmpty());
    QTest::qWait(100); // the answer arrives
    desktop.click(1);
    EXPECT_TRUE(QTest::qWaitFor([this] { return QApplication::activeWindow() == program->window(); },
                                longestNoticeWait));
    EXPECT_EQ(qgetenv("XDG_ACTIVATION_TOKEN"), QByteArray("token of the click"));
    qunsetenv("XDG_ACTIVATION_TOKEN");
}

TEST_F(ProgramBehind, SaysNothingToTheDesktopWhileItIsInFront)
{
    cutTheCable();
    ASSERT_TRUE(QTest::qWaitFor(
        [this] { return ring().bus()->state() != BusState::open || !ring().bus()->isRunning(); },
        longestNoticeWait));
    QTest::qWait(300);
    EXPECT_TRUE(desktop.calls(notify).empty());
}

TEST_F(ProgramBehind, ItsSettingsSayWhetherAndHow)
{
    tick("settingsNoticeSound", true);
    goBehind();
    cutTheCable();
    ASSERT_TRUE(desktop.waitForCalls(notify, 1));
    EXPECT_TRUE(hintsOf(last()).contains(QStringLiteral("sound-name")));
    tick("settingsNotices", false);
    const auto before = desktop.calls(notify).size();
    goBehind();
    ring().controls().setFault(TrainingFault::wireBreak, NodeId("4.0"), 0);
    ring().bus()->setRunning(true);
    ASSERT_TRUE(QTest::qWaitFor([this] { return ring().bus()->isRunning(); }, longestNoticeWait));
    cutTheCable();
    ASSERT_TRUE(QTest::qWaitFor([this] { return !ring().bus()->isRunning(); }, longestNoticeWait));
    QTest::qWait(300);
    EXPECT_EQ(desktop.calls(notify).size(), before);
    ProgramSettings kept = WindowSettings(folder.filePath(QStringLiteral("program.ini"))).choices();
    EXPECT_FALSE(kept.notifiesOfFaults);
    EXPECT_TRUE(kept.notifiesWithSound);
}

} // namespace
} // namespace codewheel
