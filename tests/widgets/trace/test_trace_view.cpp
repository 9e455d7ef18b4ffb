// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/model_tester.h"
#include "tests/support/old_file.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/models/traffic_model.h"
#include "widgets/trace/trace_view.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QFile>
#include <QFont>
#include <QFontMetrics>
#include <QIODevice>
#include <QLabel>
#include <QLatin1Char>
#include <QLineEdit>
#include <QMenu>
#include <QModelIndex>
#include <QScrollBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::baumer;
using test::fraba;

constexpr int mostRows = 20'000;

class TraceViewTest : public testing::Test
{
protected:
    TraceViewTest()
    {
        view.resize(900, 300);
        view.show();
        view.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&view));
        view.setEncoder(&ring.encoder(fraba));
        model().clear();
    }
    TrafficModel &model(Place number = fraba) { return *view.model(number); }
    void write(Place number, Word word)
    {
        ring.channel(number).stage(word);
        EXPECT_TRUE(ring.channel(number).write());
        ring.bus.advance(20);
    }
    QModelIndex index(int row, TrafficColumn column) { return model().index(row, model().columnOf(column)); }
    QString cell(int row, TrafficColumn column) { return index(row, column).data().toString(); }
    void key(Qt::Key which, Qt::KeyboardModifiers modifiers = Qt::ControlModifier)
    {
        table.setFocus();
        QTest::keyClick(&table, which, modifiers);
    }
    QString counts()
    {
        for (auto *label : view.findChildren<QLabel *>())
            if (label->text().contains(QLatin1String("rows")) && label->isVisible())
                return label->text();
        return {};
    }

    test::TrainingBusSession ring;
    TraceView view{ring.buses};
    QTableView &table = *view.findChild<QTableView *>();
};

TEST_F(TraceViewTest, WithoutAnEncoderItSaysWhatBelongsHere)
{
    view.setEncoder(nullptr);
    EXPECT_TRUE(view.findChild<EmptyState *>()->isVisible());
}

TEST_F(TraceViewTest, AHandshakeIsARowForEachChange)
{
    const test::ModelTester tester(model());
    write(fraba, 0x020000FF);
    ASSERT_GE(model().rowCount(), 2);
    EXPECT_EQ(cell(0, TrafficColumn::out), QStringLiteral("020000FF"));
    EXPECT_EQ(cell(0, TrafficColumn::sinceLast), QString());
    const int last = model().rowCount() - 1;
    EXPECT_EQ(cell(last, TrafficColumn::out), QStringLiteral("020000FF"));
    EXPECT_EQ(cell(last, TrafficColumn::in), QStringLiteral("C20000FF"));
    EXPECT_EQ(cell(0, TrafficColumn::meaning), QStringLiteral("Parameter 1 steps = 255: not taken yet"));
    EXPECT_EQ(cell(last, TrafficColumn::meaning), QStringLiteral("Parameter 1 steps = 255: confirmed"));
    EXPECT_GT(cell(last, TrafficColumn::sinceLast).toDouble(), 0.0);
    EXPECT_TRUE(cell(last, TrafficColumn::time).startsWith(QLatin1String("14:02:00.")));
    const QModelIndex time = index(last, TrafficColumn::time);
    EXPECT_EQ(time.data(Qt::ToolTipRole).toString(), model().dateTimeText(model().rowAt(last)));
}

// Until the encoder has taken the next read-out, IN holds the value of the previous one.
TEST_F(TraceViewTest, AnOldReadOutIsNotTakenForTheAnswerToTheNewWord)
{
    write(fraba, 0x2021'0001);
    write(fraba, 0x2021'0002);
    QStringList meanings;
    for (int row = 0; row < model().rowCount(); ++row)
        if (cell(row, TrafficColumn::in) == QLatin1String("A0002000"))
            meanings << cell(row, TrafficColumn::meaning);
    EXPECT_EQ(meanings,
              (QStringList{QStringLiteral("Read out steps \u2013 Read-out: steps = 8192"),
                           QStringLiteral("Read out revolutions \u2013 Self test, or read-out of 8192")}));
}

TEST_F(TraceViewTest, NumbersAndMeaningHaveRoomInANarrowDock)
{
    view.resize(460, 200);
    write(fraba, 0x020000FF);
    const QFontMetrics metrics{index(0, TrafficColumn::time).data(Qt::FontRole).value<QFont>()};
    for (int row = 0; row < model().rowCount(); ++row)
        for (int column = 0; column < model().columnOf(TrafficColumn::meaning); ++column)
            EXPECT_LT(metrics.horizontalAdvance(cell(row, model().columnAt(column))),
                      table.columnWidth(column));
    EXPECT_GE(table.columnWidth(model().columnOf(TrafficColumn::meaning)),
              20 * table.fontMetrics().averageCharWidth());
    EXPECT_LE(table.columnViewportPosition(model().columnOf(TrafficColumn::remark)),
              table.viewport()->width());
}

TEST_F(TraceViewTest, EachEncoderHasItsOwnRowsWhicheverIsSelected)
{
    write(baumer, 0x02000064);
    EXPECT_EQ(model().rowCount(), 0);
    EXPECT_GE(model(baumer).rowCount(), 2);
    view.setEncoder(&ring.encoder(baumer));
    EXPECT_EQ(table.model(), &model(baumer));
}

TEST_F(TraceViewTest, ARemarkIsTheUsers)
{
    const test::ModelTester tester(model());
    write(fraba, 0x020000FF);
    table.edit(index(0, TrafficColumn::remark));
    auto *editor = qobject_cast<QLineEdit *>(QApplication::focusWidget());
    ASSERT_TRUE(editor);
    QTest::keyClicks(editor, QStringLiteral("first, \"steps\""));
    QTest::keyClick(editor, Qt::Key_Return);
    QCoreApplication::processEvents();
    EXPECT_EQ(cell(0, TrafficColumn::remark), QStringLiteral("first, \"steps\""));
    EXPECT_FALSE(model().flags(index(0, TrafficColumn::out)) & Qt::ItemIsEditable);
}

TEST_F(TraceViewTest, PausedItKeepsWhatComesForLater)
{
    const test::ModelTester tester(model());
    key(Qt::Key_H);
    write(fraba, 0x020000FF);
    EXPECT_EQ(model().rowCount(), 0);
    EXPECT_TRUE(counts().contains(QLatin1String("paused, "))) << counts().toStdString();
    const int waiting = model().waiting();
    EXPECT_GE(waiting, 2);
    key(Qt::Key_H);
    EXPECT_EQ(model().rowCount(), waiting);
}

TEST_F(TraceViewTest, TheOldestRowsGoAndAreCounted)
{
    TrafficModel many(ring.bus.trafficColumns(), mostRows);
    many.setHeld(true);
    for (int i = 0; i <= mostRows; ++i)
        many.add({.at = 1ms * i, .cycle = static_cast<std::uint64_t>(i)});
    many.setHeld(false);
    EXPECT_EQ(many.dropped() + static_cast<quint64>(many.rowCount()), mostRows + 1U);
    EXPECT_LE(many.rowCount(), mostRows);
    EXPECT_EQ(many.rowAt(many.rowCount() - 1).what.cycle, static_cast<std::uint64_t>(mostRows));
    const auto add = [&many] {
        many.add({});
        many.showWaiting();
    };
    while (many.rowCount() < mostRows)
        add();
    const quint64 before = many.dropped();
    add();
    EXPECT_GT(many.dropped(), before);
    EXPECT_LE(many.rowCount(), mostRows);
}

TEST_F(TraceViewTest, KeepsAsManyRowsAsAreSet)
{
    write(fraba, 0x020000FF);
    view.setMostRows(5);
    for (Word word = 1; word < 40; ++word)
        write(fraba, word);
    EXPECT_LE(model().rowCount(), 5);
    EXPECT_GT(model().dropped(), 0u);
}

TEST_F(TraceViewTest, FollowsTheNewestRowUnlessToldNotTo)
{
    for (Word word = 1; word < 40; ++word)
        write(fraba, word);
    EXPECT_EQ(table.verticalScrollBar()->value(), table.verticalScrollBar()->maximum());
    key(Qt::Key_End);
    table.scrollToTop();
    write(fraba, 100);
    EXPECT_EQ(table.verticalScrollBar()->value(), 0);
}

TEST_F(TraceViewTest, CopiesSelectedRowsWithTabs)
{
    write(fraba, 0x020000FF);
    table.selectRow(0);
    key(Qt::Key_C);
    const QStringList lines = QApplication::clipboard()->text().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    ASSERT_EQ(lines.size(), 1);
    const QStringList cells = lines.first().split(QLatin1Char('\t'));
    ASSERT_EQ(cells.size(), 7);
    EXPECT_EQ(cells.at(model().columnOf(TrafficColumn::out)), QStringLiteral("020000FF"));
    table.clearSelection();
    key(Qt::Key_C);
    EXPECT_EQ(QApplication::clipboard()->text().count(QLatin1Char('\n')), model().rowCount());
}

// What its context menu has under this text, with all that is below it.
QAction *inMenu(const QWidget &of, const char *text)
{
    QList<QAction *> all = of.actions();
    for (const QAction *action : of.actions())
        if (action->menu() != nullptr)
            all += action->menu()->actions();
    for (QAction *action : all)
        if (plainLabel(action->text()).startsWith(QLatin1String(text)))
            return action;
    return nullptr;
}

TEST_F(TraceViewTest, CopiesOutAndInAsWordsOfAPlc)
{
    write(fraba, 0x020000FF);
    table.selectRow(model().rowCount() - 1);
    key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(QApplication::clipboard()->text(), QStringLiteral("16#0200 16#00FF\t16#C200 16#00FF\n"));
    table.clearSelection();
    key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(QApplication::clipboard()->text().count(QLatin1Char('\n')), model().rowCount());
    table.selectRow(model().rowCount() - 1);
    ASSERT_NE(inMenu(table, "Copy as two words of a PLC"), nullptr);
    ASSERT_NE(inMenu(table, "PLC: 16#0200_00FF"), nullptr);
    inMenu(table, "PLC: 16#0200_00FF")->trigger();
    EXPECT_EQ(QApplication::clipboard()->text(), QStringLiteral("16#0200_00FF\t16#C200_00FF\n"));
}

TEST_F(TraceViewTest, ExportsCommaSeparatedUtf8)
{
    write(fraba, 0x020000FF);
    model().setData(index(0, TrafficColumn::remark), QStringLiteral("a \"b\", c"));
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("trace.csv"));
    ASSERT_TRUE(view.exportTo(path));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(file.readAll()).split(QStringLiteral("\r\n"));
    EXPECT_EQ(lines.at(0), QStringLiteral("time,since_last_ms,cycle,out,in,meaning,remark,bus,place"));
    EXPECT_TRUE(lines.at(1).startsWith(QLatin1String("2026-03-01T14:02:00."))) << lines.at(1).toStdString();
    EXPECT_TRUE(lines.at(1).contains(QLatin1String(",020000FF,")));
    EXPECT_TRUE(lines.at(1).endsWith(QLatin1String(",\"a \"\"b\"\", c\",1,1.0")))
        << lines.at(1).toStdString();
    EXPECT_FALSE(view.exportTo(folder.filePath(QStringLiteral("no/such/trace.csv"))));
    EXPECT_TRUE(view.findChild<InlineMessage *>()->sentence().contains(QLatin1String("was not written")));
}

TEST_F(TraceViewTest, ARemarkIsNoFormulaInATable)
{
    write(fraba, 0x020000FF);
    model().setData(index(0, TrafficColumn::remark), QStringLiteral("=HYPERLINK(1)"));
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("trace.csv"));
    ASSERT_TRUE(view.exportTo(path));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QString row = QString::fromUtf8(file.readAll()).split(QStringLiteral("\r\n")).at(1);
    EXPECT_TRUE(row.endsWith(QLatin1String(",\"'=HYPERLINK(1)\",1,1.0"))) << row.toStdString();
}

TEST_F(TraceViewTest, AnExportWithoutRoomLeavesTheOldOne)
{
    write(fraba, 0x020000FF);
    test::OldFile old;
    EXPECT_FALSE(old.saveWithoutRoom([&](const QString &path) { return view.exportTo(path); }));
    EXPECT_TRUE(old.isThere());
    EXPECT_TRUE(view.findChild<InlineMessage *>()->sentence().endsWith(
        QLatin1String("was not written: File too large")));
}

TEST_F(TraceViewTest, WhatWasCollectedOutlivesTheConnection)
{
    write(fraba, 0x020000FF);
    const int rows = model().rowCount();
    ASSERT_TRUE(ring.bus.open(RingSession::Start::operating));
    ring.bus.advance(10);
    view.setEncoder(&ring.encoder(fraba));
    EXPECT_GE(model().rowCount(), rows);
    const int before = model().rowCount();
    write(fraba, 0x04000001);
    EXPECT_GT(model().rowCount(), before);
}

TEST_F(TraceViewTest, ARowSaysWhereAnotherConnectionBegins)
{
    write(fraba, 0x020000FF);
    const int rows = model().rowCount();
    const std::vector<Word> words = view.outWords(fraba);
    ring.buses.remove(&ring.bus);
    TrainingBus training = makeTrainingBus(ring.catalog);
    RingSession other(std::move(training.link), ring.catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 3)));
    ASSERT_TRUE(other.open(RingSession::Start::operating));
    ring.buses.add(other);
    ASSERT_EQ(model().rowCount(), rows + 1);
    EXPECT_EQ(cell(rows, TrafficColumn::meaning), QStringLiteral("Another connection begins here."));
    EXPECT_EQ(cell(rows, TrafficColumn::time), QStringLiteral("14:03:00.000"));
    for (const TrafficColumn column : {TrafficColumn::sinceLast, TrafficColumn::cycle, TrafficColumn::out})
        EXPECT_EQ(cell(rows, column), QString());
    other.advance(10);
    ASSERT_GT(model().rowCount(), rows + 1);
    EXPECT_EQ(cell(rows + 1, TrafficColumn::sinceLast), QString())
        << "the time between them is no answer time";
    EXPECT_EQ(view.outWords(fraba), words);
    const QByteArray line = model().csv(fraba).split('\n').at(rows + 1);
    EXPECT_EQ(line.count(','), 8) << line.toStdString();
    EXPECT_TRUE(line.contains(",,,,,\"Another connection begins here.\"")) << line.toStdString();
    ring.buses.remove(&other);
}

TEST_F(TraceViewTest, WhatWasClearedIsBroughtBackBeforeWhatCameSince)
{
    model().bringBack(); // the initial rows
    const int before = model().rowCount();
    write(fraba, 0x0200'00FF);
    const int rows = model().rowCount();
    ASSERT_GT(rows, before);
    const QString first = cell(0, TrafficColumn::time);
    key(Qt::Key_Delete);
    EXPECT_EQ(model().rowCount(), 0);
    write(fraba, 0);
    const int since = model().rowCount();
    key(Qt::Key_Delete); // a second time
    write(fraba, 0x0200'0100);
    const int last = model().rowCount();
    key(Qt::Key_Delete, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(model().rowCount(), rows + since + last);
    EXPECT_EQ(cell(0, TrafficColumn::time), first);
    EXPECT_EQ(cell(model().rowCount() - last, TrafficColumn::out), QStringLiteral("02000100"));
    EXPECT_FALSE(model().hasCleared());
}

TEST_F(TraceViewTest, WhatIsHeldBackIsClearedAndBroughtBackToo)
{
    key(Qt::Key_H);
    write(fraba, 0x0200'00FF);
    const int waiting = model().waiting();
    ASSERT_GT(waiting, 0);
    key(Qt::Key_Delete);
    EXPECT_EQ(model().waiting(), 0);
    key(Qt::Key_Delete, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_GE(model().rowCount(), waiting);
    key(Qt::Key_H);
}

// As many as a table holds: the newest.
TEST_F(TraceViewTest, WhatIsClearedIsBounded)
{
    const auto fill = [this](std::uint64_t from) {
        for (std::uint64_t n = 0; n < mostRows; ++n)
            model().add({.cycle = from + n});
        model().showWaiting();
    };
    fill(0);
    model().clear();
    fill(100'000);
    model().clear();
    model().bringBack();
    EXPECT_EQ(model().rowCount(), mostRows);
    EXPECT_EQ(model().rowAt(0).what.cycle, 100'000U);
}

TEST_F(TraceViewTest, GoesToTheEncoderWhoseTraceItIs)
{
    std::vector<Place> places;
    QObject::connect(&view, &TraceView::goToWanted, [&](Place place) { places.push_back(place); });
    key(Qt::Key_G);
    EXPECT_EQ(places, std::vector<Place>{fraba});
}

TEST_F(TraceViewTest, WhoeverScrollsUpIsLeftAlone)
{
    for (int i = 0; i < 40; ++i)
        write(fraba, i % 2 == 0 ? 0x80000000 : 0);
    QScrollBar &bar = *table.verticalScrollBar();
    EXPECT_EQ(bar.value(), bar.maximum());
    bar.triggerAction(QAbstractSlider::SliderToMinimum);
    write(fraba, 0x80000000);
    EXPECT_EQ(bar.value(), 0);
}

} // namespace
} // namespace codewheel
