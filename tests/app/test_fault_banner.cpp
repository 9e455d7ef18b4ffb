// SPDX-License-Identifier: GPL-3.0-or-later
// Faults anywhere are shown above the pages of the window.
#include "app/window/kinds/interbus/ring_views.h"
#include "kinds/esc/simulator/simulated_esc_line.h"
#include "kinds/interbus/words/k3_word.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "tests/support/plans.h"
#include "widgets/structure/fault_banner.h"
#include "widgets/structure/structure_view.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>

namespace codewheel {
namespace {

constexpr BusId otherRing{3};

class FaultBannerInWindow : public test::WindowTest
{
protected:
    void befall(TrainingFault fault, Place place, int value = 1)
    {
        shown->controls().setFault(fault, place.node, value);
        advance(99);
    }
    FaultBanner &banner() { return *window().findChild<FaultBanner *>(); }
    QToolButton &button(const char *id) { return *banner().findChild<QToolButton *>(QLatin1String(id)); }
    void press(const char *id) { QTest::mouseClick(&button(id), Qt::LeftButton); }
    std::optional<Place> row() { return window().findChild<StructureView *>()->row(); }
    QStringList listed()
    {
        QMenu &menu = *button("otherFaults").menu();
        Q_EMIT menu.aboutToShow();
        QStringList texts;
        for (const QAction *action : menu.actions())
            texts << action->text();
        return texts;
    }
};

TEST_F(FaultBannerInWindow, ComesWithTheFaultAndGoesWhenTheBusRunsAgain)
{
    EXPECT_FALSE(banner().isVisible());
    befall(TrainingFault::wireBreak, "4.0"_ring);
    ASSERT_TRUE(banner().isVisible());
    const QString sentence = QStringLiteral(
        "The cable between 3.0 and 4.0 is interrupted, or 4.0 has no supply. Check plug, shield and 24 V.");
    EXPECT_EQ(banner().sentence(), sentence);
    EXPECT_EQ(banner().accessibleName(), roleWord(Role::fault) + QStringLiteral(": ") + sentence);

    press("startAgain");
    advance(99);
    EXPECT_EQ(banner().sentence(), sentence) << "the cable is still broken";
    befall(TrainingFault::wireBreak, "4.0"_ring, 0);
    EXPECT_TRUE(banner().sentence().endsWith(QStringLiteral("Start it again.")));
    press("startAgain");
    advance(99);
    EXPECT_TRUE(bus().isRunning());
    EXPECT_FALSE(banner().isVisible());
}

TEST_F(FaultBannerInWindow, NamesTheFaultThatAStartHasMet)
{
    befall(TrainingFault::wireBreak, "1.0"_ring);
    const QString sentence = banner().sentence();
    befall(TrainingFault::wireBreak, "1.0"_ring, 0);
    befall(TrainingFault::wireBreak, "1.0"_ring);
    EXPECT_TRUE(banner().sentence().endsWith(QStringLiteral("Start it again."))) << "nobody looks in READY";
    press("startAgain");
    advance(99);
    EXPECT_EQ(banner().sentence(), QStringLiteral("The ring could not be started. ") + sentence);
    press("showFault");
    EXPECT_EQ(row(), "1.0"_ring);
    befall(TrainingFault::wireBreak, "1.0"_ring, 0);
    press("startAgain");
    advance(99);
    EXPECT_TRUE(bus().isRunning());
    EXPECT_FALSE(banner().isVisible());
}

TEST_F(FaultBannerInWindow, ShowLeadsToThePlaceAndToThePanelThatTellsMore)
{
    befall(TrainingFault::wireBreak, "4.0"_ring);
    press("showFault");
    EXPECT_EQ(row(), "4.0"_ring);
    EXPECT_TRUE(window().findChild<QDockWidget *>(QStringLiteral("masterDock"))->widget()->isVisible());
}

TEST_F(FaultBannerInWindow, SwitchesTheSegmentOffAfterAsking)
{
    befall(TrainingFault::wireBreak, "4.0"_ring);
    actions().watch->trigger();
    advance(99);
    EXPECT_FALSE(button("switchFaultOff").isEnabled());
    EXPECT_EQ(button("switchFaultOff").toolTip(),
              QStringLiteral("The program only watches. Switch to Operate first."));
    actions().operate->trigger();
    advance(99);
    press("switchFaultOff");
    auto *question = window().findChild<InlineMessage *>(QStringLiteral("masterMessage"));
    ASSERT_TRUE(question->isVisible());
    QTest::mouseClick(question->findChild<QPushButton *>(), Qt::LeftButton);
    advance(99);
    press("startAgain");
    advance(99);
    EXPECT_TRUE(bus().isRunning()) << "without 4.0 and what is behind it";
    EXPECT_FALSE(bus().latest().devices[3].inRing);
    EXPECT_FALSE(banner().isVisible());
}

TEST_F(FaultBannerInWindow, TellsTheWorstAndListsTheOthers)
{
    befall(TrainingFault::peripheralFault, "3.0"_ring);
    EXPECT_TRUE(banner().sentence().startsWith(QStringLiteral("3.0 reports a fault")));
    EXPECT_FALSE(button("otherFaults").isVisible());
    shown->line().training()->setUnplugged(true);
    advance(2'000);
    EXPECT_TRUE(banner().sentence().startsWith(QStringLiteral("Line: The serial port")))
        << banner().sentence().toStdString();
    EXPECT_EQ(button("otherFaults").text(), QStringLiteral("1 more"));
    ASSERT_EQ(listed().size(), 1);
    EXPECT_TRUE(listed().front().startsWith(QStringLiteral("Ring: 3.0 reports a fault")));
    button("otherFaults").menu()->actions().front()->trigger();
    EXPECT_EQ(row(), "3.0"_ring);
    shown->line().training()->setUnplugged(false);
    advance(3'000);
    EXPECT_TRUE(banner().sentence().startsWith(QStringLiteral("3.0 reports a fault")));
    befall(TrainingFault::peripheralFault, "3.0"_ring, 0);
    press("confirmFault");
    advance(99);
    EXPECT_FALSE(banner().isVisible());
}

TEST_F(FaultBannerInWindow, HasItsButtonBesideTheSentenceWhereThatTakesLessHeight)
{
    resizeTo({1024, 640});
    for (const Word word : {0x0400'4E20U, 0x8000'0000U}) { // more than it can count
        WordChannel &channel = *bus().channel(test::baumer);
        channel.stage(word);
        ASSERT_TRUE(channel.write());
        advance(50);
    }
    ASSERT_TRUE(banner().isVisible());
    QToolButton &show = button("showFault");
    const QList<QLabel *> labels = banner().findChildren<QLabel *>();
    const auto sentence =
        std::ranges::find_if(labels, [](const QLabel *label) { return !label->text().isEmpty(); });
    ASSERT_NE(sentence, labels.end());
    const auto middle = [&](const QWidget &part) { return part.mapTo(&banner(), part.rect().center()).y(); };
    EXPECT_NEAR(middle(show), middle(**sentence), 2);
    EXPECT_LT(banner().height(), 2 * show.height());
}

// The position jumps to what becomes valid, and the controller sees it.
TEST_F(FaultBannerInWindow, RunIsSentAfterAsking)
{
    send(test::baumer, 0x0200'00FF);
    advance(100);
    send(test::baumer, 0);
    advance(100);
    ASSERT_TRUE(button("sendRun").isVisible()) << banner().sentence().toStdString();
    {
        const test::Question question([](QWidget &box) { QTest::keyClick(&box, Qt::Key_Return); });
        press("sendRun");
        EXPECT_TRUE(question.text().startsWith(QStringLiteral("Send run to 2.0?")));
        EXPECT_TRUE(
            question.text().contains(QStringLiteral("IN (C20000FF) confirms Steps with the data 255")))
            << question.text().toStdString();
    }
    advance(500);
    EXPECT_EQ(in(test::baumer), 0xC200'00FFu) << "the default is Cancel";
    const test::Question question = test::Question::answeredBy(QStringLiteral("Send run"));
    press("sendRun");
    advance(500);
    EXPECT_TRUE(k3::isOperation(in(test::baumer)));
}

// In cam mode run does not change how the position is scaled.
TEST_F(FaultBannerInWindow, RunOfACamWordIsAboutCams)
{
    send(test::fraba, 0x2080'0001);
    advance(100);
    send(test::fraba, 0x4200'0064);
    advance(100);
    send(test::fraba, 0);
    advance(100);
    ASSERT_TRUE(button("sendRun").isVisible()) << banner().sentence().toStdString();
    const test::Question question([](QWidget &box) { QTest::keyClick(&box, Qt::Key_Return); });
    press("sendRun");
    EXPECT_TRUE(question.text().contains(QStringLiteral("switches its cams by these values")))
        << question.text().toStdString();
    EXPECT_FALSE(question.text().contains(QStringLiteral("gives its position by these values")));
}

// In Watch nothing is written, unless a button says that it leaves Watch.
TEST_F(FaultBannerInWindow, BringBackSaysThatItGoesToOperate)
{
    const auto *views = window().findChild<RingViews *>();
    ASSERT_NE(views, nullptr);
    const Fault left{.node = test::fraba.node, .text = {}, .actions = {FaultAction::bringBack}};
    EXPECT_EQ(views->offer(left, FaultAction::bringBack).text, QStringLiteral("Bring back"));
    actions().watch->trigger();
    advance(99);
    EXPECT_EQ(views->offer(left, FaultAction::bringBack).text, QStringLiteral("Operate, and bring back"));
}

// Of all that can be done about faults, only what is offered takes its place.
TEST_F(FaultBannerInWindow, DoesNotWidenTheWindow)
{
    resizeTo({1024, 640});
    befall(TrainingFault::wireBreak, "4.0"_ring);
    ASSERT_TRUE(banner().isVisible());
    EXPECT_EQ(window().width(), 1024);
}

TEST_F(FaultBannerInWindow, ClosedItComesBackForAnotherFaultOnly)
{
    befall(TrainingFault::parametersLost, "1.0"_ring);
    ASSERT_TRUE(banner().isVisible());
    for (auto *close : banner().findChildren<QToolButton *>())
        if (close->accessibleName() == QStringLiteral("Close this message"))
            close->click();
    advance(99);
    EXPECT_FALSE(banner().isVisible());
    befall(TrainingFault::wireBreak, "4.0"_ring);
    EXPECT_TRUE(banner().isVisible());
}

TEST_F(FaultBannerInWindow, GoesWithTheBusThatIsDisconnectedAndStaysOverAnyPage)
{
    befall(TrainingFault::wireBreak, "4.0"_ring);
    window().showWizard();
    advance(99);
    EXPECT_TRUE(banner().isVisible());
    bus().close();
    advance(99);
    EXPECT_FALSE(banner().isVisible());
}

TEST_F(FaultBannerInWindow, OfTwoRingsItNamesTheOne)
{
    Project after = shown->project().project();
    planBus(after, otherRing, *busKind(u"interbus"));
    ProjectDevice device = after.devices.front();
    device.bus = otherRing;
    setDevicesOn(after, otherRing, {device});
    shown->project().edit(std::move(after), {});
    befall(TrainingFault::wireBreak, "4.0"_ring);
    EXPECT_TRUE(banner().sentence().startsWith(QStringLiteral("Ring: The cable between 3.0")))
        << banner().sentence().toStdString();
}

// A PLC takes the cams for a position.
TEST_F(FaultBannerInWindow, AnEncoderThatAJobHasLeftInCamModeIsBroughtBack)
{
    EncoderSession &encoder = *bus().encoder(test::fraba);
    encoder.tell(Parameter::startUpMode, 1);
    advance(50);
    ASSERT_TRUE(encoder.start(WriteCams{
        .programs = {CamProgram{}}, .onlyWhatDiffers = true, .afterwards = SwitchMode{Mode::position}}));
    for (int i = 0; i < 300 && encoder.latest().mode != Mode::cam; ++i)
        advance(1);
    ASSERT_EQ(encoder.latest().mode, Mode::cam);
    bus().alarmStop();
    advance(200);
    bus().setRunning(true);
    advance(200);
    EXPECT_TRUE(banner().sentence().startsWith(QStringLiteral("1.0 was left in cam mode, program 1")))
        << banner().sentence().toStdString();
    {
        const test::Question question = test::Question::answeredBy(QStringLiteral("Cancel"));
        window().close();
        EXPECT_TRUE(question.text().contains(QStringLiteral("was left in cam mode, program 1")))
            << question.text().toStdString();
    }
    EXPECT_TRUE(window().isVisible());
    bus().setOperate(true);
    advance(50);
    const test::Question question = test::Question::answeredBy(QStringLiteral("Leave cam mode"));
    press("backToPositionMode");
    advance(500);
    EXPECT_EQ(encoder.latest().mode, Mode::position);
    EXPECT_FALSE(banner().isVisible());
}

} // namespace
} // namespace codewheel
