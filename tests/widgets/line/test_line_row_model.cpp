// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/model_tester.h"
#include "tests/widgets/line/line_bench.h"
#include "widgets/line/line_row_filter.h"
#include "widgets/line/line_row_model.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using Kind = esc::LineRow::Kind;
using test::wire;

class LineRowModelTest : public testing::Test
{
protected:
    LineRowModelTest() { model.setBegin(QDateTime(QDate(2026, 11, 21), QTime(12, 0))); }
    void add(Kind kind, const QByteArray &bytes) { model.add({at += 5ms, kind, bytes}); }
    void poll()
    {
        add(Kind::sent, wire("05P"));
        add(Kind::answer, "\r\n00001235\r\n");
    }
    QString cell(int row, int column) const { return filter.index(row, column).data().toString(); }

    Instant at{};
    LineRowModel model;
    LineRowFilter filter{model};
    const test::ModelTester modelTester{model};
    const test::ModelTester filterTester{filter};
};

TEST_F(LineRowModelTest, ARowSaysTimeDirectionTextBytesAndMeaning)
{
    add(Kind::sent, wire("05A"));
    add(Kind::answer, "\r\n4000\r\n");
    EXPECT_EQ(model.rowCount(), 0); // until they are shown together
    model.showWaiting();
    EXPECT_EQ(cell(0, LineRowModel::time), QStringLiteral("12:00:00.005"));
    EXPECT_EQ(cell(0, LineRowModel::kind), QStringLiteral("sent"));
    EXPECT_EQ(cell(0, LineRowModel::text), controlText(wire("05A"), shownControls()));
    EXPECT_EQ(cell(0, LineRowModel::bytes), QStringLiteral("1B 30 35 41 0D 0A"));
    EXPECT_EQ(cell(0, LineRowModel::meaning), QStringLiteral("05: alarms?"));
    EXPECT_EQ(cell(1, LineRowModel::kind), QStringLiteral("answer"));
    EXPECT_TRUE(cell(1, LineRowModel::meaning).startsWith(QLatin1String("4000h: ")));
    EXPECT_FALSE(filter.index(0, LineRowModel::kind).data(Qt::DecorationRole).isNull());
}

TEST_F(LineRowModelTest, WhatIsNoAnswerIsMarked)
{
    add(Kind::garbage, "?");
    add(Kind::sent, wire("05A"));
    add(Kind::echo, wire("05A"));
    add(Kind::garbage, "40");
    add(Kind::late, "\r\n4000\r\n");
    model.showWaiting();
    EXPECT_EQ(cell(0, LineRowModel::meaning), QStringLiteral("nobody asked for it: dropped"));
    EXPECT_EQ(cell(2, LineRowModel::kind), QStringLiteral("echo"));
    EXPECT_TRUE(cell(3, LineRowModel::meaning).contains(QLatin1String("\"05: alarms?\": dropped")));
    EXPECT_EQ(cell(4, LineRowModel::kind), QStringLiteral("late"));
}

TEST_F(LineRowModelTest, PollsAreHiddenButNotWhatIsWrongWithThem)
{
    poll();
    add(Kind::sent, wire("05A"));
    add(Kind::sent, wire("05P"));
    add(Kind::garbage, "x");
    model.showWaiting();
    EXPECT_EQ(model.rowCount(), 5);
    ASSERT_EQ(filter.rowCount(), 2);
    EXPECT_EQ(cell(0, LineRowModel::meaning), QStringLiteral("05: alarms?"));
    EXPECT_EQ(cell(1, LineRowModel::kind), QStringLiteral("garbage"));
    filter.hidePolls(false);
    EXPECT_EQ(filter.rowCount(), 5);
}

TEST_F(LineRowModelTest, AnExchangeThatWasTypedIsShownAlthoughItLooksLikeAPoll)
{
    poll();
    poll();
    model.showWaiting();
    model.markTyped({{5}, esc::Command::position, 0}); // shown already
    EXPECT_EQ(filter.rowCount(), 2);
    EXPECT_EQ(cell(0, LineRowModel::kind), QStringLiteral("sent, typed"));
    poll();
    model.markTyped({{5}, esc::Command::position, 0}); // not shown yet
    model.showWaiting();
    EXPECT_EQ(filter.rowCount(), 4);
    EXPECT_EQ(model.rowCount(), 6);
}

TEST_F(LineRowModelTest, HeldItKeepsWhatComesForLater)
{
    model.setHeld(true);
    add(Kind::sent, wire("05A"));
    model.showWaiting();
    EXPECT_EQ(model.rowCount(), 0);
    EXPECT_EQ(model.waiting(), 1);
    EXPECT_EQ(model.recordRows().size(), 1U);
    model.setHeld(false);
    EXPECT_EQ(model.rowCount(), 1);
}

TEST(LineRowModel, TheOldestRowsGoAndAreCounted)
{
    LineRowModel model;
    for (int i = 0; i < LineRowModel::mostRows; ++i)
        model.add({Instant{i}, Kind::sent, wire("05A")});
    model.showWaiting();
    EXPECT_EQ(model.rowCount(), LineRowModel::mostRows);
    EXPECT_EQ(model.dropped(), 0U);
    model.add({Instant{LineRowModel::mostRows}, Kind::sent, wire("05P")});
    model.showWaiting();
    EXPECT_LT(model.rowCount(), LineRowModel::mostRows);
    EXPECT_EQ(static_cast<int>(model.dropped()) + model.rowCount(), LineRowModel::mostRows + 1);
    EXPECT_EQ(model.rowAt(model.rowCount() - 1).row.what.at, Instant{LineRowModel::mostRows});
}

TEST_F(LineRowModelTest, ARecordIsShownAsItWasKept)
{
    poll();
    add(Kind::sent, wire("05A"));
    model.markTyped({{5}, esc::Command::alarms, 0});
    model.showWaiting();
    const LineRecord record{.begin = model.begin(), .port = {}, .rows = model.recordRows()};
    LineRowModel other;
    other.setRecord(record);
    EXPECT_EQ(other.recordRows(), record.rows);
    EXPECT_EQ(other.index(2, LineRowModel::meaning).data(), QStringLiteral("05: alarms?"));
}

} // namespace
} // namespace codewheel
