// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/no_room.h"
#include "tests/widgets/trend/trend_page_test.h"
#include "widgets/input/number_fields.h"
#include "widgets/look/inline_message.h"
#include "widgets/trend/trend_chart.h"
#include "widgets/trend/trend_page.h"
#include "widgets/trend/trend_values_model.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::baumer;
using test::fraba;
using test::TrendPageTest;

TEST_F(TrendPageTest, WhatCameBeforeACurveWasChosenIsShown)
{
    EXPECT_FALSE(chart().isVisible()) << "nothing is chosen yet";
    advance(5s);
    page.showTrack({baumer, Channel::position, {}});
    advance(100ms);
    ASSERT_TRUE(chart().isVisible());
    const TrendCurve &curve = lane(0).curves.front();
    EXPECT_EQ(curve.name, QStringLiteral("2.0 position, steps"));
    EXPECT_GT(curve.history->span()->to - curve.history->span()->from, 4s);
    EXPECT_GE(seen().to, histories.span()->to);
    EXPECT_FALSE(cell(0, TrendValuesModel::now).isEmpty());
}

TEST_F(TrendPageTest, StationsAreNamed)
{
    page.showTrack({fraba, Channel::out, 25});
    EXPECT_EQ(lane(0).curves.front().name, QStringLiteral("1.0 Hoist OUT bit 25"));
}

TEST_F(TrendPageTest, ItFollowsWhatComesUntilSomebodyLooksElsewhere)
{
    page.showTrack({baumer, Channel::position, {}});
    advance(3s);
    const TimeSpan before = seen();
    advance(1s);
    EXPECT_GT(seen().to, before.to + 900ms);
    press(Qt::Key_Left);
    auto *follow = page.findChildren<QAction *>().constFirst();
    for (QAction *action : page.findChildren<QAction *>())
        if (action->text() == QStringLiteral("Follow"))
            follow = action;
    EXPECT_FALSE(follow->isChecked());
    const TimeSpan scrolled = seen();
    advance(1s);
    EXPECT_EQ(seen(), scrolled);
    QTest::keyClick(&chart(), Qt::Key_End, Qt::ControlModifier);
    EXPECT_TRUE(follow->isChecked());
    EXPECT_GE(seen().to, histories.span()->to);
}

TEST_F(TrendPageTest, APauseLosesNothing)
{
    page.showTrack({baumer, Channel::position, {}});
    advance(1s);
    QTest::keyClick(&chart(), Qt::Key_H, Qt::ControlModifier);
    const TimeSpan held = seen();
    advance(2s);
    EXPECT_EQ(seen(), held);
    QTest::keyClick(&chart(), Qt::Key_H, Qt::ControlModifier);
    advance(100ms);
    EXPECT_GT(seen().to, held.to + 1900ms);
    EXPECT_EQ(histories.of(baumer)->of(Channel::position).gaps().size(), 0U);
}

TEST_F(TrendPageTest, NowIsNowInAPauseToo)
{
    page.showTrack({baumer, Channel::position, {}});
    advance(1s);
    QTest::keyClick(&chart(), Qt::Key_H, Qt::ControlModifier);
    const QString before = cell(0, TrendValuesModel::now);
    advance(330ms);
    EXPECT_TRUE(QTest::qWaitFor([&] { return cell(0, TrendValuesModel::now) != before; }));
}

TEST_F(TrendPageTest, TheWheelZoomsWhereItPoints)
{
    page.showTrack({baumer, Channel::position, {}});
    advance(20s);
    QTest::keyClick(&chart(), Qt::Key_Home, Qt::ControlModifier);
    const TimeSpan all = seen();
    EXPECT_LE(all.from, histories.span()->from);
    EXPECT_GE(all.to, histories.span()->to);
    wheel(0.5, 3);
    EXPECT_LT(seen().to - seen().from, (all.to - all.from) * 6 / 10);
    const Instant middle = all.from + (all.to - all.from) / 2;
    EXPECT_NEAR(static_cast<double>((seen().from + (seen().to - seen().from) / 2 - middle).count()), 0, 1e5);
    const TimeSpan zoomed = seen();
    wheel(0.5, 1, Qt::ShiftModifier);
    EXPECT_LT(seen().from, zoomed.from);
    EXPECT_EQ(seen().to - seen().from, zoomed.to - zoomed.from);
}

TEST_F(TrendPageTest, ABoxIsZoomedInto)
{
    page.showTrack({baumer, Channel::position, {}});
    page.showTrack({fraba, Channel::position, {}});
    advance(20s);
    QTest::keyClick(&chart(), Qt::Key_Home, Qt::ControlModifier);
    QCoreApplication::processEvents();
    const TimeSpan all = seen();
    const TrendLane before = lane(0);
    drag(at(0.25, 0.1), at(0.5, 0.3));
    EXPECT_NEAR(static_cast<double>((seen().from - all.from) / 1ms), 0.25 * (all.to - all.from) / 1ms, 100);
    EXPECT_NEAR(static_cast<double>((seen().to - all.from) / 1ms), 0.5 * (all.to - all.from) / 1ms, 100);
    EXPECT_LT(lane(0).high - lane(0).low, (before.high - before.low) * 0.6) << "its axis as well";
    const double other = lane(1).high - lane(1).low;
    EXPECT_NEAR(other, 10, 2.1) << "the other one fits";
    QTest::keyClick(&chart(), Qt::Key_Home, Qt::ControlModifier);
    EXPECT_NEAR(lane(0).high - lane(0).low, before.high - before.low, 1e4) << "fits again";
}

TEST_F(TrendPageTest, TheMiddleButtonDragsTheTime)
{
    page.showTrack({baumer, Channel::position, {}});
    advance(20s);
    const TimeSpan before = seen();
    drag(at(0.5, 0.5), at(0.75, 0.5), Qt::MiddleButton);
    EXPECT_NEAR(static_cast<double>((before.from - seen().from) / 1ms), 15'000, 1'500);
    EXPECT_NEAR(static_cast<double>((seen().to - seen().from) / 1ms), 60'000, 1);
}

TEST_F(TrendPageTest, CursorsTellValuesAndDifferences)
{
    page.showTrack({baumer, Channel::position, {}});
    page.showTrack({baumer, Channel::speed, {}});
    advance(20s);
    QTest::keyClick(&chart(), Qt::Key_Home, Qt::ControlModifier);
    click(0.5);
    click(0.6, Qt::ShiftModifier);
    const auto [a, b] = view().scene().cursors;
    ASSERT_TRUE(a && b);
    const MemoryHistory &position = histories.of(baumer)->of(Channel::position);
    const auto steps = position.at(*b)->value - position.at(*a)->value;
    EXPECT_EQ(cell(0, TrendValuesModel::cursorA), QLocale().toString(qlonglong{position.at(*a)->value}));
    EXPECT_EQ(cell(0, TrendValuesModel::difference), u'+' + QLocale().toString(qlonglong{steps}));
    EXPECT_EQ(cell(0, TrendValuesModel::degrees),
              u'+' + QLocale().toString(static_cast<double>(steps) / 8'192 * 360, 'f', 2) + u'°');
    EXPECT_NEAR(number(cell(0, TrendValuesModel::rate)), 60, 0.1);
    EXPECT_NEAR(number(cell(1, TrendValuesModel::cursorB)), 60, 0.1);
    EXPECT_TRUE(find<QLabel>("trendCursors").text().contains(QStringLiteral("B − A")));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !cell(1, TrendValuesModel::mean).isEmpty(); }));
    EXPECT_NEAR(number(cell(1, TrendValuesModel::mean)), 60, 0.1);
    EXPECT_LT(cell(0, TrendValuesModel::least), cell(0, TrendValuesModel::greatest));
}

TEST_F(TrendPageTest, KeysMoveTheCursorThatIsChosen)
{
    page.showTrack({baumer, Channel::position, {}});
    advance(20s);
    press(Qt::Key_A);
    press(Qt::Key_B);
    const Instant before = view().scene().cursors[1].value();
    press(Qt::Key_Right, Qt::ControlModifier);
    EXPECT_EQ(view().scene().cursors[1], before + chart().resolution());
    press(Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(view().scene().cursors[1], before - 9 * chart().resolution());
    EXPECT_EQ(view().scene().cursors[0], before);
    press(Qt::Key_A);
    press(Qt::Key_Right, Qt::ControlModifier);
    EXPECT_EQ(view().scene().cursors[0], before + chart().resolution());
    press(Qt::Key_Delete, Qt::ControlModifier);
    EXPECT_FALSE(view().scene().cursors[0]);
    EXPECT_FALSE(view().scene().cursors[1]);
}

TEST_F(TrendPageTest, ACursorIsDragged)
{
    page.showTrack({baumer, Channel::position, {}});
    advance(20s);
    press(Qt::Key_Left); // no longer follows
    click(0.3);
    click(0.6, Qt::ShiftModifier);
    const Instant b = view().scene().cursors[1].value();
    drag(at(0.3, 0.5), at(0.45, 0.5));
    const double part = static_cast<double>((*view().scene().cursors[0] - seen().from).count()) /
                        static_cast<double>((seen().to - seen().from).count());
    EXPECT_NEAR(part, 0.45, 0.01);
    EXPECT_EQ(view().scene().cursors[1], b);
}

TEST_F(TrendPageTest, UnitsAreThoseThatAreKnown)
{
    ring.encoder(fraba).tell(Parameter::steps, {});
    page.showTrack({fraba, Channel::position, {}});
    auto &unit = find<QComboBox>("curveUnit");
    const auto isOffered = [&](TrackUnit which) {
        return (unit.model()->flags(unit.model()->index(static_cast<int>(which), 0)) & Qt::ItemIsEnabled) !=
               0;
    };
    EXPECT_TRUE(isOffered(TrackUnit::steps));
    EXPECT_FALSE(isOffered(TrackUnit::degrees));
    page.showTrack({baumer, Channel::position, {}});
    EXPECT_TRUE(isOffered(TrackUnit::degrees));
    unit.setCurrentIndex(unit.findText(QStringLiteral("degrees")));
    Q_EMIT unit.activated(unit.currentIndex());
    EXPECT_EQ(lane(1).unit, QStringLiteral("°"));
    EXPECT_DOUBLE_EQ(lane(1).curves.front().scale.perStep, 360.0 / 8'192);
}

// The shaft goes on turning at 60 rpm.
TEST_F(TrendPageTest, WhatCameBeforeAnotherNumberOfStepsPerTurnKeepsItsScale)
{
    page.showTrack({baumer, Channel::speed, {}});
    page.showTrack({baumer, Channel::position, {}});
    advance(5s);
    ASSERT_TRUE(
        ring.encoder(baumer).start(WriteParameters{.values = {{Parameter::steps, 4'096}}, .previous = {}}));
    advance(20s);
    ASSERT_FALSE(ring.encoder(baumer).runningJob());
    page.bringUpToDate();
    ASSERT_EQ(lane(0).curves.front().scale.earlier.size(), 1U);
    EXPECT_NEAR(number(cell(0, TrendValuesModel::now)), 60, 1);
    const TimeSpan all = *view().timeOfCurves();
    view().setCursor(0, all.from + 4s);
    view().setCursor(1, all.to - 1s);
    page.bringUpToDate();
    EXPECT_NEAR(number(cell(0, TrendValuesModel::cursorA)), 60, 1)
        << cell(0, TrendValuesModel::cursorA).toStdString();
    EXPECT_NEAR(number(cell(0, TrendValuesModel::cursorB)), 60, 1);
    EXPECT_NEAR(number(cell(0, TrendValuesModel::least)), 60, 5);
    EXPECT_NEAR(number(cell(0, TrendValuesModel::greatest)), 60, 5);
    EXPECT_NEAR(number(cell(0, TrendValuesModel::mean)), 60, 1);
    EXPECT_LT(lane(0).high, 100) << "the axis fits";
}

TEST_F(TrendPageTest, EachCurveHasOneLineOfTheTableHoweverLongItsName)
{
    TrendPage narrow(ring.buses, histories,
                     [](Place) { return QStringLiteral("Hoist of the crane in hall 2"); });
    narrow.resize(520, 600);
    narrow.show();
    narrow.showTrack({fraba, Channel::position, {}});
    narrow.showTrack({baumer, Channel::speed, {}});
    narrow.showTrack({baumer, Channel::position, {}});
    advance(2s);
    narrow.showFrame();
    const TimeSpan all = *narrow.view().timeOfCurves();
    narrow.view().setCursor(0, all.from + 100ms);
    narrow.view().setCursor(1, all.to - 100ms);
    narrow.bringUpToDate();
    QCoreApplication::processEvents();
    const QTableView &table = *narrow.findChild<QTableView *>(QStringLiteral("trendTable"));
    for (int row = 0; row < 3; ++row) {
        const QModelIndex name = table.model()->index(row, TrendValuesModel::name);
        const QRect line = table.visualRect(name);
        EXPECT_LT(line.width(), table.fontMetrics().horizontalAdvance(name.data().toString())) << row;
        EXPECT_LT(line.height(), 2 * table.fontMetrics().height()) << row;
        EXPECT_LE(line.bottom(), table.viewport()->rect().bottom()) << row;
        EXPECT_EQ(name.data(Qt::ToolTipRole), name.data()) << "all of it";
    }
}

TEST_F(TrendPageTest, MillimetresNeedTheTravelPerTurn)
{
    page.showTrack({baumer, Channel::position, {}});
    auto &unit = find<QComboBox>("curveUnit");
    auto &travel = find<DecimalField>("curveTravel");
    EXPECT_FALSE(travel.isVisible());
    unit.setCurrentIndex(unit.findText(QStringLiteral("millimetres")));
    Q_EMIT unit.activated(unit.currentIndex());
    ASSERT_TRUE(travel.isVisible());
    EXPECT_EQ(lane(0).unit, QStringLiteral("steps")) << "not known yet";
    travel.setFocus();
    travel.selectAll();
    QTest::keyClicks(&travel, QStringLiteral("12,5"));
    EXPECT_EQ(lane(0).unit, QStringLiteral("steps")) << "half typed";
    QTest::keyClick(&travel, Qt::Key_Return);
    EXPECT_EQ(lane(0).unit, QStringLiteral("mm"));
    EXPECT_DOUBLE_EQ(lane(0).curves.front().scale.perStep, 12.5 / 8'192);
}

TEST_F(TrendPageTest, CurvesOfOneUnitShareAnAxis)
{
    page.showTrack({fraba, Channel::position, {}});
    page.showTrack({baumer, Channel::position, {}});
    auto &shares = find<QCheckBox>("curveAxis");
    EXPECT_EQ(view().scene().lanes.size(), 2U);
    ASSERT_TRUE(shares.isEnabled());
    QTest::mouseClick(&shares, Qt::LeftButton, {}, QPoint(5, shares.height() / 2));
    ASSERT_EQ(view().scene().lanes.size(), 1U);
    EXPECT_EQ(lane(0).curves.size(), 2U);
    advance(1s);
    EXPECT_LE(lane(0).low, 12'345);
    EXPECT_GE(lane(0).high, 1'000'000);
}

TEST_F(TrendPageTest, CurvesAreMovedAndRemoved)
{
    page.showTrack({fraba, Channel::position, {}});
    page.showTrack({baumer, Channel::position, {}});
    find<QToolButton>("curveUp").click();
    EXPECT_EQ(page.tracks().shown().front().track.place, baumer);
    find<QToolButton>("curveRemove").click();
    ASSERT_EQ(page.tracks().shown().size(), 1U);
    EXPECT_EQ(page.tracks().shown().front().track.place, fraba);
    auto &table = find<QTableView>("trendTable");
    table.selectRow(0);
    table.setFocus();
    QTest::keyClick(&table, Qt::Key_Delete);
    EXPECT_TRUE(page.tracks().shown().empty());
    EXPECT_FALSE(chart().isVisible());
}

TEST_F(TrendPageTest, EachCurveCanBeChosenByMenu)
{
    advance(200ms);
    auto *menu = find<QToolButton>("addCurve").menu();
    Q_EMIT menu->aboutToShow();
    const auto find = [](QMenu *in, const QString &text) {
        for (QAction *action : in->actions())
            if (action->text() == text)
                return action;
        return static_cast<QAction *>(nullptr);
    };
    QAction *hoist = find(menu, QStringLiteral("1.0  Hoist"));
    ASSERT_NE(hoist, nullptr);
    QAction *bits = find(hoist->menu(), QStringLiteral("Bits of OUT"));
    ASSERT_NE(bits, nullptr);
    EXPECT_EQ(bits->menu()->actions().size(), 32);
    bits->menu()->actions().at(25)->trigger();
    EXPECT_NE(find(hoist->menu(), QStringLiteral("Cams")), nullptr);
    find(hoist->menu(), QStringLiteral("Speed"))->trigger();
    EXPECT_TRUE(page.tracks().find({fraba, Channel::out, 25}));
    EXPECT_TRUE(page.tracks().find({fraba, Channel::speed, {}}));
}

TEST_F(TrendPageTest, AnOrderedJumpIsMarked)
{
    page.showTrack({fraba, Channel::position, {}});
    advance(1s);
    ASSERT_TRUE(ring.encoder(fraba).start(SetPreset{.value = 100}));
    advance(2s);
    EXPECT_FALSE(view().scene().marks.empty());
    QTest::keyClick(&chart(), Qt::Key_Up, Qt::ControlModifier);
    EXPECT_TRUE(find<QLabel>("trendCursors").text().contains(QStringLiteral("1.0: ")));
    for (int mark = 0; mark < 100; ++mark)
        QTest::keyClick(&chart(), Qt::Key_Up, Qt::ControlModifier);
    EXPECT_EQ(sentence(), QStringLiteral("There is no earlier mark."));
}

TEST_F(TrendPageTest, TheUserNotesWhatHappened)
{
    page.showTrack({baumer, Channel::position, {}});
    advance(5s);
    click(0.95);
    QTest::keyClick(&chart(), Qt::Key_M, Qt::ControlModifier);
    auto &text = find<QLineEdit>("noteText");
    ASSERT_TRUE(text.hasFocus());
    QTest::keyClicks(&text, QStringLiteral("Coupling tightened"));
    QTest::keyClick(&text, Qt::Key_Return);
    EXPECT_FALSE(text.isVisible());
    QCoreApplication::processEvents();
    EXPECT_TRUE(find<QLabel>("trendCursors").text().contains(QStringLiteral("Coupling tightened")));
    QTest::keyClick(&chart(), Qt::Key_M, Qt::ControlModifier);
    EXPECT_EQ(text.text(), QStringLiteral("Coupling tightened"));
    QTest::keyClicks(&text, QStringLiteral("Other"));
    QTest::keyClick(&text, Qt::Key_Escape);
    EXPECT_TRUE(find<QLabel>("trendCursors").text().contains(QStringLiteral("Coupling tightened")));
    QTest::keyClick(&chart(), Qt::Key_M, Qt::ControlModifier);
    text.clear();
    QTest::keyClick(&text, Qt::Key_Return);
    QCoreApplication::processEvents();
    EXPECT_FALSE(find<QLabel>("trendCursors").text().contains(QStringLiteral("Coupling")));
}

TEST_F(TrendPageTest, TheStoppedBusLeavesAGapAndNoValueNow)
{
    page.showTrack({baumer, Channel::position, {}});
    advance(2s);
    ring.bus.setRunning(false);
    advance(1s);
    EXPECT_TRUE(QTest::qWaitFor([&] { return cell(0, TrendValuesModel::now) == QStringLiteral("–"); }));
    ring.bus.setRunning(true);
    advance(1s);
    EXPECT_EQ(histories.of(baumer)->of(Channel::position).gaps().size(), 1U);
}

TEST_F(TrendPageTest, TellsHowFarBackItGoes)
{
    page.showTrack({baumer, Channel::position, {}});
    advance(3s);
    const QString text = find<QLabel>("trendMemory").text();
    EXPECT_TRUE(QTest::qWaitFor([&] {
        return find<QLabel>("trendMemory").text().contains(QStringLiteral("256 MB; enough for"));
    })) << text.toStdString();
    Q_EMIT ring.bus.valuesDropped(17);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return find<QLabel>("trendMemory").text().contains(QStringLiteral("17 cycles")); }));
}

TEST_F(TrendPageTest, WhatIsSeenIsSavedAsAPicture)
{
    page.showTrack({baumer, Channel::position, {}});
    page.showTrack({baumer, Channel::out, 25});
    advance(5s);
    const QTemporaryDir folder;
    const QString png = folder.filePath(QStringLiteral("trend.png"));
    ASSERT_TRUE(page.savePicture(png));
    const QImage image(png);
    EXPECT_EQ(image.size(), QSize(1'600, 900));
    EXPECT_EQ(image.pixelColor(2, 2), QColor(Qt::white));
    const QString svg = folder.filePath(QStringLiteral("trend.svg"));
    ASSERT_TRUE(page.savePicture(svg));
    QFile file(svg);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    EXPECT_TRUE(text.contains("2.0 position, steps"));
    EXPECT_TRUE(text.contains("polyline"));
    EXPECT_FALSE(page.savePicture(folder.filePath(QStringLiteral("no/trend.png"))));
    EXPECT_TRUE(sentence().contains(QStringLiteral("was not written")));
}

TEST_F(TrendPageTest, ItIsPrintedWithItsTable)
{
    EXPECT_FALSE(page.printedView());
    page.showTrack({baumer, Channel::position, {}});
    advance(1s);
    const auto printed = page.printedView();
    ASSERT_TRUE(printed);
    ASSERT_EQ(printed->pictures.size(), 1U);
    EXPECT_GT(printed->pictures.front().drawing.size(), 1'000U);
    EXPECT_TRUE(printed->table);
}

TEST_F(TrendPageTest, TheCurvesAreExportedWithWhatTheyAre)
{
    page.showTrack({baumer, Channel::position, {}});
    page.showTrack({fraba, Channel::out, 25});
    advance(5s);
    click(0.95);
    click(0.98, Qt::ShiftModifier);
    const QTemporaryDir folder;
    const auto exported = [&](TrendPage::Extract what) {
        const QString path = folder.filePath(QStringLiteral("trend.csv"));
        QFile::remove(path);
        page.exportTo(path, what);
        EXPECT_TRUE(QTest::qWaitFor([&] { return QFile::exists(path); }));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll();
    };
    const QByteArray all = exported(TrendPage::Extract::all);
    EXPECT_TRUE(all.startsWith("time [s],2.0 position [steps],1.0 Hoist: OUT.25"))
        << all.left(80).toStdString();
    EXPECT_GT(all.count('\n'), 4'500);
    const QByteArray between = exported(TrendPage::Extract::betweenCursors);
    const auto [a, b] = view().scene().cursors;
    EXPECT_NEAR(static_cast<double>(between.count('\n')), static_cast<double>((*b - *a) / 1ms), 5);
    EXPECT_EQ(exported(TrendPage::Extract::seen).count('\n'), all.count('\n')) << "all of it is seen";
    EXPECT_TRUE(QFile::exists(folder.filePath(QStringLiteral("trend.json"))));
    EXPECT_TRUE(sentence().contains(QStringLiteral("is written")));
}

TEST_F(TrendPageTest, AnExportThatFailsOrIsCancelledLeavesWhatWasThere)
{
    page.showTrack({baumer, Channel::position, {}});
    advance(60s);
    const QTemporaryDir folder;
    page.exportTo(folder.filePath(QStringLiteral("no/trend.csv")), TrendPage::Extract::all);
    EXPECT_TRUE(QTest::qWaitFor([&] { return sentence().contains(QStringLiteral("was not written")); }));
    const QString path = folder.filePath(QStringLiteral("trend.csv"));
    page.exportTo(path, TrendPage::Extract::all);
    EXPECT_TRUE(QTest::qWaitFor([&] { return sentence().startsWith(QStringLiteral("Writing")); }));
    Q_EMIT page.findChild<InlineMessage *>()->actionTriggered();
    EXPECT_EQ(sentence(), QStringLiteral("The export is cancelled; nothing was written."));
    EXPECT_FALSE(QFile::exists(path));
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 0);
}

TEST_F(TrendPageTest, TheTimeIsScrolledByItsBar)
{
    page.showTrack({baumer, Channel::position, {}});
    advance(100s);
    auto &bar = find<QScrollBar>("trendTime");
    EXPECT_EQ(bar.value(), bar.maximum());
    bar.setValue(0);
    EXPECT_EQ(seen().from, histories.span()->from);
    bar.setValue(bar.maximum());
    EXPECT_TRUE(view().follows());
}

} // namespace
} // namespace codewheel
