// SPDX-License-Identifier: GPL-3.0-or-later
// A recording in the window: opened, played, stepped, shown as what it is, and closed.
#include "app/window/recording/recordings.h"
#include "bus/bus_outline.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "tests/app/window_test.h"
#include "tests/replay/replay_recording.h"
#include "vocabulary/freshness_text.h"
#include "widgets/kinds/esc/line/esc_line_terminal.h"
#include "widgets/kinds/esc/line/request_field.h"
#include "widgets/look/inline_message.h"
#include "widgets/monitor/word_field.h"
#include "widgets/monitor/word_line.h"
#include "widgets/recording/recording_dialog.h"
#include "widgets/replay/replay_bar.h"
#include "widgets/replay/replay_slider.h"
#include "widgets/structure/structure_view.h"
#include "widgets/trend/trend_page.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using test::hoist;
using test::noon;
using namespace std::chrono_literals;

constexpr int crane = 100'001;
const Place recordedHoist = test::replayed(hoist, crane);

class ReplayInWindow : public test::WindowTest
{
protected:
    void openRecording()
    {
        ASSERT_TRUE(window().openRecording(recording.path));
        structure().choose(recordedHoist);
        advance(33);
    }
    StructureView &structure() { return *window().findChild<StructureView *>(); }
    ReplayBar *bar()
    {
        for (auto *each : window().findChildren<ReplayBar *>())
            if (each->isVisible())
                return each;
        return nullptr;
    }
    Playback &playback() { return *shown->plant().recordings().all().front().playback; }
    QAction &tool(const QString &text)
    {
        for (QAction *each : bar()->findChild<QToolBar *>()->actions())
            if (each->text() == text)
                return *each;
        ADD_FAILURE() << text.toStdString();
        return *new QAction(bar());
    }
    void press(const QString &text)
    {
        QWidget *button = bar()->findChild<QToolBar *>()->widgetForAction(&tool(text));
        ASSERT_TRUE(button->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
    }
    QString time() { return bar()->findChild<QLabel *>(QStringLiteral("replayTime"))->text(); }
    QString status()
    {
        QStringList texts;
        for (const auto *label : window().statusBar()->findChildren<QLabel *>())
            texts << label->text();
        return texts.join(u'\n');
    }
    QString notice() { return window().findChild<InlineMessage *>(QStringLiteral("notice"))->sentence(); }
    // Whatever order the words stand in.
    QStringList words()
    {
        QStringList texts;
        for (const auto *field : monitors().card(recordedHoist)->findChildren<WordField *>())
            texts << field->text();
        return texts;
    }

    test::ReplayRecording recording;
};

TEST_F(ReplayInWindow, IsABusBesideTheOthersAndSaysThatItIsARecording)
{
    EXPECT_FALSE(actions().closeRecording->isEnabled());
    openRecording();
    EXPECT_TRUE(structure().has({{crane}}));
    EXPECT_TRUE(structure().has(test::replayed(test::atTheGate, crane + 1)));
    EXPECT_TRUE(structure().has(test::fraba)) << "the connected ring stays";
    EXPECT_EQ(recordedHoist.shown(), QStringLiteral("night Crane/1.0"));
    EXPECT_EQ(hoist.shown(), QStringLiteral("1.0"));
    ASSERT_NE(bar(), nullptr);
    EXPECT_TRUE(time().endsWith(QStringLiteral(":00.000"))) << time().toStdString();
    EXPECT_TRUE(status().contains(QStringLiteral("night Crane: recording"))) << status().toStdString();
    const EncoderBus &its = *shown->buses().open(BusId{crane});
    EXPECT_EQ(its.outline().state().word, QStringLiteral("recording"));
    EXPECT_TRUE(actions().closeRecording->isEnabled());
    structure().choose(test::fraba);
    EXPECT_EQ(bar(), nullptr) << "the bar belongs to the recording";
    EXPECT_FALSE(status().contains(QStringLiteral("recording")));
}

// Nothing live goes on under its bar.
TEST_F(ReplayInWindow, ThePanelsShowTheRecordedEncoderAtOnce)
{
    structure().choose(hoist);
    ASSERT_TRUE(window().openRecording(recording.path));
    advance(33);
    ASSERT_NE(bar(), nullptr);
    EXPECT_EQ(structure().current(), recordedHoist);
    ASSERT_NE(monitors().card(recordedHoist), nullptr);
    EXPECT_TRUE(monitors().card(recordedHoist)->isVisible());
}

TEST_F(ReplayInWindow, NothingCanBeSentAndLooksSo)
{
    openRecording();
    for (const QAction *action : {actions().watch, actions().operate, actions().start, actions().stop,
                                  actions().zeroOut, actions().wizard, actions().cams, actions().compare})
        EXPECT_FALSE(action->isEnabled()) << action->text().toStdString();
    EXPECT_TRUE(actions().zeroOut->toolTip().startsWith(QStringLiteral("This is a recording")));
    EXPECT_FALSE(actions().alarmStop->toolTip().contains(QStringLiteral("night")));
    actions().alarmStop->trigger();
    advance(99);
    EXPECT_TRUE(shown->buses().open(BusId{crane})->isRunning());
    structure().choose(test::fraba);
    EXPECT_TRUE(actions().stop->isEnabled() || actions().start->isEnabled());
    EXPECT_TRUE(actions().compare->isEnabled());
}

TEST_F(ReplayInWindow, PlaysAndShowsTheRecordedWordsBitForBit)
{
    openRecording();
    press(QStringLiteral("Play"));
    EXPECT_TRUE(tool(QStringLiteral("Play")).isChecked());
    advance(1'000);
    press(QStringLiteral("Pause"));
    advance(33);
    EXPECT_FALSE(playback().isPlaying());
    EXPECT_GE(playback().position(), noon + 990ms);
    const auto expected = static_cast<Word>(1'000 + (playback().position() - noon) / 10ms);
    EXPECT_TRUE(words().contains(QStringLiteral("%1").arg(expected, 8, 16, QLatin1Char('0')).toUpper()))
        << words().join(u' ').toStdString();
    EXPECT_EQ(shown->buses().encoder(recordedHoist)->latest().position, expected);
    press(QStringLiteral("Backward"));
    advance(500);
    EXPECT_LT(playback().position(), noon + 600ms);
    press(QStringLiteral("Backward"));
    EXPECT_FALSE(playback().isPlaying()) << "pressed again it pauses";
}

TEST_F(ReplayInWindow, IsSteppedAndSpedUpByKeys)
{
    openRecording();
    const auto key = [this](Qt::Key which) {
        QTest::keyClick(&window(), which, Qt::ControlModifier | Qt::AltModifier);
        advance(33);
    };
    key(Qt::Key_Period);
    EXPECT_EQ(playback().position(), noon + 10ms);
    key(Qt::Key_Period);
    key(Qt::Key_Comma);
    EXPECT_EQ(playback().position(), noon + 10ms);
    key(Qt::Key_End);
    EXPECT_EQ(playback().position(), noon + 10s);
    key(Qt::Key_Home);
    EXPECT_EQ(playback().position(), noon);
    key(Qt::Key_Plus);
    EXPECT_EQ(playback().factor(), 10);
    EXPECT_EQ(bar()->findChild<QComboBox *>(QStringLiteral("replaySpeed"))->currentText(),
              QStringLiteral("10×"));
    key(Qt::Key_F);
    EXPECT_TRUE(playback().isPlaying());
    key(Qt::Key_P);
    EXPECT_FALSE(playback().isPlaying());
    structure().choose(test::fraba);
    key(Qt::Key_F);
    EXPECT_FALSE(playback().isPlaying()) << "the keys belong to the bar";
}

TEST_F(ReplayInWindow, TheSliderGoesToAnyMoment)
{
    openRecording();
    auto &slider = *bar()->findChild<ReplaySlider *>();
    slider.setFocus();
    QTest::keyClick(&slider, Qt::Key_End);
    EXPECT_EQ(playback().position(), noon + 10s);
    QTest::keyClick(&slider, Qt::Key_PageDown);
    EXPECT_EQ(playback().position(), noon + 9s);
    advance(33);
    EXPECT_EQ(slider.accessibleDescription(), recordedText(playback().dateTime(noon + 9s)));
    EXPECT_TRUE(slider.accessibleName().startsWith(QStringLiteral("Moment")));
}

TEST_F(ReplayInWindow, WhatNobodyRecordedIsShownAsUnknown)
{
    openRecording();
    playback().jumpTo(noon + 4s);
    advance(66);
    for (const QString &word : words())
        EXPECT_EQ(word, QStringLiteral("–"));
    for (const auto *line : monitors().card(recordedHoist)->findChildren<WordLine *>())
        EXPECT_EQ(line->meaning(), QStringLiteral("Of this time nothing is recorded."));
    playback().jumpTo(noon + 6s);
    advance(66);
    EXPECT_TRUE(words().contains(QStringLiteral("00001388"))) << words().join(u' ').toStdString();
}

TEST_F(ReplayInWindow, IsClosedByItsBarAndTheWindowGoesOn)
{
    openRecording();
    press(QStringLiteral("Close"));
    QTest::qWait(0);
    advance(66);
    EXPECT_FALSE(structure().has({{crane}}));
    EXPECT_FALSE(structure().has({{crane + 1}}));
    EXPECT_TRUE(window().findChildren<ReplayBar *>().isEmpty());
    EXPECT_TRUE(shown->plant().recordings().all().empty());
    EXPECT_FALSE(actions().closeRecording->isEnabled());
    EXPECT_TRUE(structure().row().has_value());
    openRecording();
    EXPECT_NE(bar(), nullptr) << "and again";
}

TEST_F(ReplayInWindow, TwoRecordingsAreOpenSideBySideAndTheSameOneOnlyOnce)
{
    test::ReplayRecording other;
    openRecording();
    ASSERT_TRUE(window().openRecording(other.path));
    EXPECT_EQ(shown->plant().recordings().all().size(), 2U);
    const Place second = test::replayed(hoist, crane + 2);
    EXPECT_TRUE(structure().has(second));
    EXPECT_NE(second.shown(), recordedHoist.shown());
    ASSERT_TRUE(window().openRecording(recording.path));
    EXPECT_EQ(shown->plant().recordings().all().size(), 2U);
    EXPECT_EQ(structure().row()->bus, BusId{crane});
}

TEST_F(ReplayInWindow, WhatIsNoRecordingIsRefusedWithASentence)
{
    const test::RecordingFile file;
    file.fill("no database");
    EXPECT_FALSE(window().openRecording(file.path));
    EXPECT_TRUE(notice().contains(file.path)) << notice().toStdString();
    EXPECT_FALSE(window().openRecording(folder.filePath(QStringLiteral("missing.cwrec"))));
    EXPECT_TRUE(notice().contains(QStringLiteral("missing.cwrec"))) << notice().toStdString();
    EXPECT_TRUE(shown->plant().recordings().all().empty());
}

TEST_F(ReplayInWindow, IsOpenedByDroppingItsFile)
{
    QMimeData files;
    files.setUrls({QUrl::fromLocalFile(recording.path)});
    QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &files, Qt::LeftButton, {});
    QApplication::sendEvent(&window(), &enter);
    QDropEvent drop(QPointF(5, 5), Qt::CopyAction, &files, Qt::LeftButton, {});
    QApplication::sendEvent(&window(), &drop);
    EXPECT_TRUE(QTest::qWaitFor([this] { return !shown->plant().recordings().all().empty(); }));
    EXPECT_NE(bar(), nullptr);
}

TEST_F(ReplayInWindow, WhatTheProgramSaidThenStandsInTheBarUntilAJump)
{
    openRecording();
    const auto *told = bar()->findChild<QLabel *>(QStringLiteral("replayMessage"));
    EXPECT_FALSE(told->isVisible());
    playback().jumpTo(noon + 6'400ms);
    advance(33);
    press(QStringLiteral("Play"));
    advance(300);
    EXPECT_TRUE(told->isVisible());
    EXPECT_TRUE(told->text().contains(QStringLiteral("06  1.0  "))) << told->text().toStdString();
    playback().jumpTo(noon);
    EXPECT_FALSE(told->isVisible());
}

TEST_F(ReplayInWindow, NothingOfItIsKeptAsIfItHadHappenedNow)
{
    openRecording();
    const int before = shown->messages().rowCount();
    playback().jumpTo(noon + 6'400ms);
    press(QStringLiteral("Play"));
    advance(300);
    EXPECT_EQ(shown->messages().rowCount(), before);
    EXPECT_EQ(shown->plant().histories().of(recordedHoist), nullptr);
    window().close();
    EXPECT_TRUE(QTest::qWaitFor([this] { return !window().isVisible(); }))
        << "recorded OUT words ask nothing";
}

TEST_F(ReplayInWindow, StaysWhenTheProjectIsReplaced)
{
    openRecording();
    shown->project().setProject({}, {});
    advance(33);
    EXPECT_TRUE(structure().has(recordedHoist));
}

TEST_F(ReplayInWindow, TheTrendShowsAllOfItAndFollowsTheMoment)
{
    openRecording();
    actions().trend->trigger();
    auto &trend = *window().findChild<TrendPage *>();
    trend.showTrack({recordedHoist, Channel::position, {}});
    trend.view().showAll();
    ASSERT_EQ(trend.view().scene().lanes.size(), 1U);
    const History &curve = *trend.view().scene().lanes[0].curves[0].history;
    EXPECT_EQ(curve.span()->from, noon);
    EXPECT_EQ(curve.at(noon + 1s)->value, 1'100);
    trend.view().setCursor(0, noon + 1'500ms);
    auto *moment = trend.findChild<QToolButton *>(QStringLiteral("showMoment"));
    ASSERT_TRUE(moment->isVisible());
    QTest::mouseClick(moment, Qt::LeftButton);
    advance(33);
    EXPECT_EQ(playback().position(), noon + 1'500ms);
    EXPECT_EQ(shown->buses().encoder(recordedHoist)->latest().position, 1'150);
    EXPECT_EQ(trend.view().scene().played, std::optional(Instant(noon + 1'500ms)));
    actions().closeRecording->trigger();
    QCoreApplication::processEvents();
    EXPECT_TRUE(trend.tracks().shown().empty());
    EXPECT_TRUE(shown->plant().histories().archives().empty());
}

TEST_F(ReplayInWindow, TheTrendScalesEachPartByWhatWasKnownThen)
{
    const test::RecordingFile file;
    {
        auto writer = file.begin();
        const auto known = [](std::int64_t steps) {
            return test::frabaWith({{Parameter::steps, steps}, {Parameter::revolutions, 1}});
        };
        writer->add(RecordedBus{firstBus, QStringLiteral("Crane")});
        writer->add(RecordedClock{noon, noon});
        writer->add(RecordedDescription{hoist, noon, known(3'600)});
        writer->add(test::turning(hoist, noon, 200, 1'000));
        writer->add(RecordedInterruption{hoist, noon + 2s});
        writer->add(RecordedDescription{hoist, noon + 5s, known(7'200)});
        writer->add(test::turning(hoist, noon + 6s, 400, 2'000));
        writer->end();
    }
    ASSERT_TRUE(window().openRecording(file.path));
    actions().trend->trigger();
    auto &trend = *window().findChild<TrendPage *>();
    trend.showTrack({recordedHoist, Channel::position, {}});
    trend.tracks().setUnit(0, TrackUnit::degrees);
    for (const Instant played : {noon, noon + 9s}) {
        playback().jumpTo(played);
        advance(1'000);
        const TrendCurve &curve = trend.view().scene().lanes.at(0).curves.at(0);
        EXPECT_DOUBLE_EQ(curve.valueOf(*curve.history->at(noon)), 100) << played.count();
        EXPECT_DOUBLE_EQ(curve.valueOf(*curve.history->at(noon + 6s)), 100) << played.count();
    }
}

// What it shows is not what a request would go to.
TEST_F(ReplayInWindow, NothingIsSentFromTheTerminalOfALiveLineWhileItIsChosen)
{
    shown->line().openTraining();
    advance(200);
    structure().choose(placeOnLine({5}));
    lineActions().terminal->trigger();
    advance(50);
    auto *terminal = window().findChild<EscLineTerminal *>();
    auto *field = terminal->findChild<RequestField *>();
    QTest::keyClicks(field, QStringLiteral("05GP00000010"));
    ASSERT_TRUE(field->isEnabled());
    openRecording();
    EXPECT_FALSE(field->isEnabled());
    EXPECT_TRUE(field->toolTip().contains(QStringLiteral("recording"))) << field->toolTip().toStdString();
    structure().choose(placeOnLine({5}));
    advance(33);
    EXPECT_TRUE(field->isEnabled());
}

TEST_F(ReplayInWindow, IsNotRecordedAgain)
{
    openRecording();
    actions().record->trigger();
    auto *dialog = window().findChild<RecordingDialog *>();
    ASSERT_NE(dialog, nullptr);
    QStringList offered;
    for (QTreeWidgetItemIterator item(dialog->findChild<QTreeWidget *>()); *item != nullptr; ++item)
        offered << (*item)->text(0);
    EXPECT_THAT(offered.join(u'\n').toStdString(),
                testing::AllOf(testing::HasSubstr("1.0"), testing::Not(testing::HasSubstr("night"))));
    for (const auto *choice : dialog->findChildren<QComboBox *>())
        for (int row = 0; row < choice->count(); ++row)
            EXPECT_FALSE(choice->itemText(row).contains(QStringLiteral("night")));
    dialog->reject();
}

} // namespace
} // namespace codewheel
