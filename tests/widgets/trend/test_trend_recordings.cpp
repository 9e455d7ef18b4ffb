// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings in the trend: beside each other, on top of each other, and beside what comes.
#include "recording/recording_archive.h"
#include "tests/recording/recording_file.h"
#include "tests/widgets/trend/trend_page_test.h"
#include "widgets/input/number_fields.h"
#include "widgets/trend/shift_bar.h"

#include <QAction>
#include <QFile>
#include <QMenu>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QToolButton>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::baumer;
using test::noon;

class TrendRecordingsTest : public test::TrendPageTest
{
protected:
    // Ten seconds of a shaft that turns; under a bus of that number.
    std::unique_ptr<RecordingArchive> open(int bus, Instant begin = noon)
    {
        files.push_back(std::make_unique<test::RecordingFile>());
        auto writer = files.back()->begin();
        writer->add(test::positions(begin, 10'000, [](std::size_t index) { return index; }));
        (void)writer->end();
        auto archive = RecordingArchive::open(files.back()->path, {{"1.0"_ring.bus, BusId{bus}}});
        EXPECT_TRUE(archive);
        histories.add(**archive);
        return std::move(*archive);
    }
    static Track position(int bus) { return {{BusId{bus}, "1.0"_ring.node}, Channel::position, {}}; }
    ShiftBar &bar() { return *page.findChild<ShiftBar *>(); }
    // Of the menu, which has what can be done now.
    QAction &way(const char *name)
    {
        QAction &action = *bar().findChild<QAction *>(QLatin1String(name));
        EXPECT_TRUE(find<QToolButton>("shiftWays").menu()->actions().contains(&action));
        return action;
    }

    std::vector<std::unique_ptr<test::RecordingFile>> files;
};

TEST_F(TrendRecordingsTest, AllOfARecordingIsSeenAndItsCurveIsThatOfTheFile)
{
    const auto night = open(8);
    page.showTrack(position(8));
    view().showAll();
    EXPECT_LT(seen().from, noon);
    EXPECT_GT(seen().to, noon + 9'999ms);
    EXPECT_LT(seen().to, noon + 12s);
    ASSERT_EQ(lane(0).curves.size(), 1U);
    EXPECT_EQ(lane(0).curves[0].history->at(noon + 5s)->value, 5'000);
    EXPECT_LT(lane(0).low, 1);
    EXPECT_GT(lane(0).high, 9'998);
    click(0.5);
    EXPECT_TRUE(bar().isVisible());
}

TEST_F(TrendRecordingsTest, OnTopOfWhatComesByBeginningTogether)
{
    advance(2s);
    const auto night = open(8);
    page.showTrack({baumer, Channel::position, {}});
    page.showTrack(position(8));
    EXPECT_EQ(find<DecimalField>("recordingShift").value(), 0);
    EXPECT_FALSE(way("shiftNone").isEnabled());
    way("shiftBegin").trigger();
    EXPECT_EQ(night->span()->from, histories.of(baumer, Channel::position)->span()->from);
    EXPECT_NEAR(find<DecimalField>("recordingShift").value(),
                std::chrono::duration<double>(night->shift()).count(), 0.001);
    way("shiftNone").trigger();
    EXPECT_EQ(night->shift(), 0s);
    EXPECT_EQ(night->span()->from, noon);
}

TEST_F(TrendRecordingsTest, TwoRecordingsLieOnTopOfEachOtherByTheCursors)
{
    const auto night = open(8);
    const auto next = open(9, noon + 24h);
    page.showTrack(position(8));
    page.showTrack(position(9));
    view().setCursor(0, noon + 24h + 3s);
    EXPECT_FALSE(way("shiftCursor").isEnabled());
    view().setCursor(1, noon + 1s);
    way("shiftCursor").trigger();
    EXPECT_EQ(next->shift(), -24h - 2s);
    EXPECT_EQ(night->shift(), 0s);
    page.bringUpToDate();
    EXPECT_EQ(lane(0).curves[0].history->at(noon + 1s)->value, 1'000);
    EXPECT_EQ(lane(1).curves[0].history->at(noon + 1s)->value, 3'000);
}

TEST_F(TrendRecordingsTest, TheShiftCanBeTyped)
{
    const auto night = open(8);
    page.showTrack(position(8));
    auto &field = find<DecimalField>("recordingShift");
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, QLocale().toString(-1.5, 'f', 1));
    QTest::keyClick(&field, Qt::Key_Return);
    EXPECT_EQ(night->shift(), -1'500ms);
    EXPECT_EQ(histories.of(position(8).place, Channel::position)->span()->from, noon - 1'500ms);
}

TEST_F(TrendRecordingsTest, ItsTableHasItsOwnTimesWhateverTheShift)
{
    const auto night = open(8);
    night->setShift(34s);
    setBusNames({{BusId{8}, QStringLiteral("b Master")}});
    const auto noNames = qScopeGuard([] { setBusNames({}); });
    page.showTrack(position(8));
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("night.csv"));
    page.exportTo(path, TrendPage::Extract::all);
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(path); }));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readLine().startsWith("time [s],b Master/1.0 position"));
    const QByteArray first =
        QByteArray::number(qint64{std::chrono::floor<std::chrono::seconds>(noon).count()});
    EXPECT_TRUE(file.readLine().startsWith(first + '.'));
}

TEST_F(TrendRecordingsTest, FollowsWhatIsPlayed)
{
    const auto night = open(8);
    night->setShift(60s);
    page.showTrack(position(8));
    night->setPlayed(noon + 4s);
    view().follow();
    page.showFrame();
    EXPECT_EQ(view().scene().played, std::optional(Instant(noon + 64s)));
    EXPECT_LT(seen().to - (noon + 64s), 1s);
    night->setPlayed(noon + 5s);
    page.showFrame();
    EXPECT_LT(seen().to - (noon + 65s), 1s);
    EXPECT_EQ(view().scene().played, std::optional(Instant(noon + 65s)));
}

TEST_F(TrendRecordingsTest, TheMomentAtTheCursorIsAskedFor)
{
    const auto night = open(8);
    night->setShift(60s);
    page.showTrack(position(8));
    std::vector<Instant> asked;
    QObject::connect(night.get(), &Archive::asked, &page, [&](Instant at) { asked.push_back(at); });
    EXPECT_FALSE(find<QToolButton>("showMoment").isEnabled());
    view().setCursor(0, noon + 63s);
    QTest::mouseClick(&find<QToolButton>("showMoment"), Qt::LeftButton);
    EXPECT_THAT(asked, testing::ElementsAre(noon + 3s));
}

TEST_F(TrendRecordingsTest, ItsCurvesGoWithIt)
{
    advance(1s);
    auto night = open(8);
    page.showTrack({baumer, Channel::position, {}});
    page.showTrack(position(8));
    page.tracks().setTravel(position(8).place, 5);
    const QStringList state = page.tracks().state();
    page.tracks().restore({});
    page.tracks().restore(state); // as in the window of another language
    EXPECT_EQ(page.tracks().shown().size(), 2U);
    night.reset();
    EXPECT_EQ(page.tracks().shown().size(), 1U);
    EXPECT_FALSE(page.tracks().travel(position(8).place));
    EXPECT_FALSE(bar().isVisible());
    page.showFrame();
    EXPECT_EQ(view().scene().lanes.size(), 1U);
    page.tracks().restore(state); // as after the next start
    EXPECT_EQ(page.tracks().shown().size(), 1U);
}

TEST_F(TrendRecordingsTest, ABlockThatIsDamagedIsSaid)
{
    const auto night = open(8);
    files.back()->execute(QStringLiteral("UPDATE samples SET data = x'00'"));
    page.showTrack(position(8));
    view().showSpan({noon + 1s, noon + 1'500ms});
    page.grab();
    EXPECT_THAT(sentence().toStdString(), testing::HasSubstr("damaged"));
}

} // namespace
} // namespace codewheel
