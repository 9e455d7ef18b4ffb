// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_record.h"
#include "tests/support/model_tester.h"
#include "tests/widgets/kinds/esc/line/esc_line_bench.h"
#include "widgets/trace/traffic_table.h"

#include <array>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using Kind = esc::EscLineRow::Kind;
using test::wire;

constexpr int mostLineRows = static_cast<int>(EscLineRecord::mostRows);

class EscLineRowModelTest : public testing::Test
{
protected:
    EscLineRowModelTest() { filter.hideAutomatic(false); }
    void add(Kind kind, const QByteArray &bytes)
    {
        TrafficRow row = traffic.row({at += 5ms, kind, bytes});
        row.time = WallTime(QDateTime(QDate(2026, 11, 21), QTime(12, 0))).dateTime(at);
        model.add(std::move(row));
    }
    void poll()
    {
        add(Kind::sent, wire("05P"));
        add(Kind::answer, "\r\n00001235\r\n");
    }
    QString cell(int row, TrafficColumn column) const
    {
        return filter.index(row, model.columnOf(column)).data().toString();
    }

    Instant at{};
    EscLineTraffic traffic;
    TrafficModel model{lineTrafficColumns, mostLineRows};
    TrafficFilter filter{model};
    const test::ModelTester modelTester{model};
    const test::ModelTester filterTester{filter};
};

TEST_F(EscLineRowModelTest, ARowSaysTimeDirectionTextBytesAndMeaning)
{
    add(Kind::sent, wire("05A"));
    add(Kind::answer, "\r\n4000\r\n");
    EXPECT_EQ(model.rowCount(), 0); // until the waiting rows are shown
    model.showWaiting();
    EXPECT_EQ(cell(0, TrafficColumn::time), QStringLiteral("12:00:00.005"));
    EXPECT_EQ(cell(0, TrafficColumn::direction), QStringLiteral("sent"));
    EXPECT_EQ(cell(0, TrafficColumn::text), controlText(wire("05A"), shownControls()));
    EXPECT_EQ(cell(0, TrafficColumn::bytes), QStringLiteral("1B 30 35 41 0D 0A"));
    EXPECT_EQ(cell(0, TrafficColumn::meaning), QStringLiteral("05: alarms?"));
    EXPECT_EQ(cell(1, TrafficColumn::direction), QStringLiteral("answer"));
    EXPECT_TRUE(cell(1, TrafficColumn::meaning).startsWith(QLatin1String("4000h: ")));
    EXPECT_FALSE(filter.index(0, model.columnOf(TrafficColumn::direction)).data(Qt::DecorationRole).isNull());
}

// As after a bus was closed and opened again: its clock stood still, or starts at 0 again.
TEST_F(EscLineRowModelTest, TheTimeSinceTheLastRowIsTrueWhateverTheClockOfTheBusDid)
{
    static constexpr std::array columns{TrafficColumn::sinceLast};
    TrafficModel rows(columns, mostLineRows);
    const QDateTime noon(QDate(2026, 11, 21), QTime(12, 0));
    const auto addAt = [&](Instant clock, int millisecondsPastNoon) {
        TrafficRow row = traffic.row({clock, Kind::sent, wire("05A")});
        row.time = noon.addMSecs(millisecondsPastNoon);
        rows.add(std::move(row));
    };
    addAt(100ms, 100);
    addAt(102'500us, 102);
    addAt(104ms, 3'000);   // it stood still
    addAt(1ms, 4'000);     // another one
    addAt(2'000ms, 5'500); // and another one
    rows.showWaiting();
    const auto since = [&](int row) { return rows.index(row, 0).data().toString(); };
    EXPECT_EQ(since(1), QStringLiteral("2.5"));
    EXPECT_EQ(since(2), QLocale().toString(2'898.0, 'f', 1));
    EXPECT_EQ(since(3), QLocale().toString(1'000.0, 'f', 1));
    EXPECT_EQ(since(4), QLocale().toString(1'500.0, 'f', 1));
}

TEST_F(EscLineRowModelTest, WhatIsNoAnswerIsMarked)
{
    add(Kind::garbage, "?");
    add(Kind::sent, wire("05A"));
    add(Kind::echo, wire("05A"));
    add(Kind::garbage, "40");
    add(Kind::late, "\r\n4000\r\n");
    model.showWaiting();
    EXPECT_EQ(cell(0, TrafficColumn::meaning), QStringLiteral("nobody asked for it: dropped"));
    EXPECT_EQ(cell(2, TrafficColumn::direction), QStringLiteral("echo"));
    EXPECT_TRUE(cell(3, TrafficColumn::meaning).contains(QLatin1String("\"05: alarms?\": dropped")));
    EXPECT_EQ(cell(4, TrafficColumn::direction), QStringLiteral("late"));
}

TEST_F(EscLineRowModelTest, WhatTheProgramAsksByItselfIsHiddenButNotWhatIsWrongWithIt)
{
    poll();
    for (const char *asked : {"05A", "05E", "05N", "05V", "05B"}) {
        add(Kind::sent, wire(asked));
        add(Kind::answer, "\r\n4000\r\n");
    }
    add(Kind::sent, wire("05M"));
    add(Kind::sent, wire("05P"));
    add(Kind::garbage, "x");
    model.showWaiting();
    EXPECT_EQ(filter.rowCount(), 15);
    filter.hideAutomatic(true);
    ASSERT_EQ(filter.rowCount(), 2);
    EXPECT_EQ(cell(0, TrafficColumn::meaning), QStringLiteral("05: total measuring range?"));
    EXPECT_EQ(cell(1, TrafficColumn::direction), QStringLiteral("garbage"));
    filter.hideAutomatic(false);
    EXPECT_EQ(filter.rowCount(), 15);
}

TEST_F(EscLineRowModelTest, WhatWasTypedAndItsAnswerAreBold)
{
    poll();
    poll();
    model.showWaiting();
    model.markTyped(wire("05P"));
    const auto isBold = [this](int row) {
        for (const auto column : lineTrafficColumns)
            if (!model.index(row, model.columnOf(column)).data(Qt::FontRole).value<QFont>().bold())
                return false;
        return true;
    };
    EXPECT_FALSE(isBold(0));
    EXPECT_FALSE(isBold(1));
    EXPECT_TRUE(isBold(2));
    EXPECT_TRUE(isBold(3));
}

TEST_F(EscLineRowModelTest, ARowKnowsItsEncoder)
{
    add(Kind::garbage, "?");
    poll();
    model.showWaiting();
    EXPECT_EQ(model.rowAt(0).what.place, std::nullopt);
    EXPECT_EQ(model.rowAt(2).what.place, placeOnLine({5}));
}

TEST_F(EscLineRowModelTest, AnExchangeThatWasTypedIsShownAlthoughItLooksLikeAPoll)
{
    filter.hideAutomatic(true);
    poll();
    poll();
    model.showWaiting();
    model.markTyped(wire("05P")); // already shown
    EXPECT_EQ(filter.rowCount(), 2);
    EXPECT_EQ(cell(0, TrafficColumn::direction), QStringLiteral("sent, typed"));
    poll();
    model.markTyped(wire("05P")); // not shown yet
    model.showWaiting();
    EXPECT_EQ(filter.rowCount(), 4);
    EXPECT_EQ(model.rowCount(), 6);
}

TEST_F(EscLineRowModelTest, HeldItKeepsWhatComesForLater)
{
    model.setHeld(true);
    add(Kind::sent, wire("05A"));
    model.showWaiting();
    EXPECT_EQ(model.rowCount(), 0);
    EXPECT_EQ(model.waiting(), 1);
    model.setHeld(false);
    EXPECT_EQ(model.rowCount(), 1);
}

TEST_F(EscLineRowModelTest, TheOldestRowsGoAndAreCounted)
{
    for (int i = 0; i < mostLineRows; ++i)
        model.add(traffic.row({Instant{i}, Kind::sent, wire("05A")}));
    model.showWaiting();
    EXPECT_EQ(model.rowCount(), mostLineRows);
    EXPECT_EQ(model.dropped(), 0U);
    model.add(traffic.row({Instant{mostLineRows}, Kind::sent, wire("05P")}));
    model.showWaiting();
    EXPECT_LT(model.rowCount(), mostLineRows);
    EXPECT_EQ(static_cast<int>(model.dropped()) + model.rowCount(), mostLineRows + 1);
    EXPECT_EQ(model.rowAt(model.rowCount() - 1).what.at, Instant{mostLineRows});
}

TEST_F(EscLineRowModelTest, WhatTheProgramAsksByItselfDoesNotPushOutWhatWasTyped)
{
    constexpr int few = 200;
    model.setMost(few);
    filter.hideAutomatic(true);
    for (int typed = 0; typed < 3; ++typed) {
        poll();
        poll();
        model.markTyped(wire("05P"));
        poll();
        model.showWaiting();
    }
    const QPersistentModelIndex first = filter.index(0, 0);
    for (int i = 0; i < 10 * few; ++i) {
        poll();
        model.showWaiting();
        ASSERT_LE(model.rowCount(), few);
    }
    EXPECT_EQ(filter.rowCount(), 6);
    EXPECT_EQ(first.row(), 0) << "what was chosen stays chosen";
    EXPECT_EQ(model.rowAt(model.rowCount() - 1).what.at, at) << "the newest row is there";
    for (int row = 1; row < model.rowCount(); ++row)
        ASSERT_LT(model.rowAt(row - 1).what.at, model.rowAt(row).what.at);
}

TEST_F(EscLineRowModelTest, WhatWasTypedStaysWhileNobodyLooks)
{
    constexpr int few = 200;
    model.setMost(few);
    poll();
    model.markTyped(wire("05P"));
    for (int i = 0; i < 10 * few; ++i)
        poll();
    EXPECT_LE(model.waiting(), few);
    model.showWaiting();
    filter.hideAutomatic(true);
    EXPECT_EQ(filter.rowCount(), 2);
}

TEST_F(EscLineRowModelTest, WhatWasTypedIsBoundedToo)
{
    constexpr int few = 200;
    model.setMost(few);
    for (int i = 0; i < 2 * few; ++i) {
        poll();
        model.markTyped(wire("05P"));
        model.showWaiting();
        ASSERT_LE(model.rowCount(), few);
    }
    EXPECT_EQ(model.rowAt(model.rowCount() - 1).what.at, at);
}

TEST_F(EscLineRowModelTest, RowsAreCountedInTheNumbersOfTheLanguage)
{
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::English));
    for (int i = 0; i < 1234; ++i)
        add(Kind::sent, wire("05A"));
    model.showWaiting();
    const QString counts = model.countsText(model.rowCount());
    QLocale::setDefault(before);
    EXPECT_TRUE(counts.startsWith(QStringLiteral("1,234 rows"))) << counts.toStdString();
}

TEST_F(EscLineRowModelTest, HowManyRowsAreShownComesFirst)
{
    poll();
    add(Kind::sent, wire("05M"));
    model.showWaiting();
    EXPECT_EQ(model.countsText(1), QStringLiteral("1 of 3 rows shown"));
}

TEST_F(EscLineRowModelTest, OtherOptionsExplainTheRowsThereAreAnew)
{
    add(Kind::sent, wire("05E"));
    add(Kind::answer, "\r\n0098\r\n");
    model.showWaiting();
    const QString before = cell(1, TrafficColumn::meaning);
    traffic.setExplainOptions({.fractionBits = 8, .swapping = {EscLineAddress{5}}});
    model.tellMeaningsChanged();
    EXPECT_NE(cell(1, TrafficColumn::meaning), before);
}

} // namespace
} // namespace codewheel
