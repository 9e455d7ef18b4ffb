// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/model_tester.h"
#include "widgets/look/fonts.h"
#include "widgets/models/table_model_base.h"

#include <QAbstractItemModel>
#include <QAbstractListModel>
#include <QModelIndex>
#include <QSignalSpy>
#include <QVariant>

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

struct Line
{
    int cycle;
    QString text;
};

class Lines : public TableModelBase<Line>
{
    int columns() const override { return 2; }
    QVariant headerCell(int column, int role) const override
    {
        if (role != Qt::DisplayRole)
            return {};
        return column == 0 ? QStringLiteral("Cycle") : QStringLiteral("Text");
    }
    QVariant cell(const Line &line, int column, int role) const override
    {
        if (role != Qt::DisplayRole)
            return {};
        return column == 0 ? QVariant(line.cycle) : QVariant(line.text);
    }
};

// With heads, and no cell() of its own.
class PlainLines : public TableModelBase<Line>
{
    std::span<const ColumnHead> heads() const override
    {
        static constexpr ColumnHead all[] = {{"Cycle", Qt::AlignRight}, {"Text"}};
        return all;
    }
    QString text(const Line &line, int column) const override
    {
        return column == 0 ? QString::number(line.cycle) : line.text;
    }
    bool isNumber(int column) const override { return column == 0; }
};

std::vector<int> cyclesOf(const Lines &lines)
{
    std::vector<int> cycles;
    for (int row = 0; row < lines.rowCount(); ++row)
        cycles.push_back(lines.index(row, 0).data().toInt());
    return cycles;
}

class TableModel : public testing::Test
{
protected:
    Lines lines;
    test::ModelTester tester{lines};
};

TEST_F(TableModel, EveryChangeKeepsViewsRight)
{
    lines.setRows({{1, {}}, {2, {}}});
    lines.append({{3, {}}, {4, {}}});
    lines.append({});
    EXPECT_EQ(cyclesOf(lines), (std::vector{1, 2, 3, 4}));
    lines.insertAt(1, {9, {}});
    lines.removeAt(3);
    EXPECT_EQ(cyclesOf(lines), (std::vector{1, 9, 2, 4}));
    lines.removeFirst(2);
    EXPECT_EQ(cyclesOf(lines), (std::vector{2, 4}));
    lines.removeFirst(7);
    EXPECT_EQ(cyclesOf(lines), std::vector<int>{});
}

TEST(PlainTable, ACellHasItsTextAsToolTipTooAndStandsAsItsHead)
{
    PlainLines lines;
    lines.setRows({{7, QStringLiteral("run")}});
    const QModelIndex cycle = lines.index(0, 0);
    const QModelIndex text = lines.index(0, 1);
    EXPECT_EQ(cycle.data().toString(), QStringLiteral("7"));
    EXPECT_EQ(text.data(Qt::ToolTipRole).toString(), QStringLiteral("run"));
    EXPECT_EQ(cycle.data(Qt::TextAlignmentRole), lines.headerData(0, Qt::Horizontal, Qt::TextAlignmentRole));
    EXPECT_TRUE(Qt::Alignment(cycle.data(Qt::TextAlignmentRole).toInt()).testFlag(Qt::AlignRight));
    EXPECT_EQ(cycle.data(Qt::FontRole).value<QFont>(), numberFont());
    EXPECT_FALSE(text.data(Qt::FontRole).isValid());
    EXPECT_FALSE(text.data(Qt::TextAlignmentRole).isValid());
}

TEST_F(TableModel, AReplacedRowIsToldAsAWhole)
{
    lines.setRows({{1, {}}, {2, QStringLiteral("before")}});
    const QSignalSpy changed(&lines, &QAbstractItemModel::dataChanged);
    lines.replace(1, {2, QStringLiteral("after")});
    ASSERT_EQ(changed.size(), 1);
    EXPECT_EQ(changed.first().at(0).toModelIndex(), lines.index(1, 0));
    EXPECT_EQ(changed.first().at(1).toModelIndex(), lines.index(1, 1));
    EXPECT_EQ(lines.index(1, 1).data().toString(), QStringLiteral("after"));
}

TEST_F(TableModel, HeadersStandOverColumnsOnly)
{
    EXPECT_EQ(lines.headerData(1, Qt::Horizontal).toString(), QStringLiteral("Text"));
    EXPECT_FALSE(lines.headerData(2, Qt::Horizontal).isValid());
    EXPECT_FALSE(lines.headerData(0, Qt::Vertical).isValid());
}

TEST_F(TableModel, RowsHaveNoChildren)
{
    lines.setRows({{1, {}}});
    EXPECT_EQ(lines.rowCount(lines.index(0, 0)), 0);
    EXPECT_EQ(lines.columnCount(lines.index(0, 0)), 0);
}

// A model that notifies too late, to check that the tester's findings fail a test.
class Liar : public QAbstractListModel
{
public:
    int count = 0;
    int rowCount(const QModelIndex &parent = {}) const override { return parent.isValid() ? 0 : count; }
    QVariant data(const QModelIndex &, int) const override { return {}; }
    void grow()
    {
        beginInsertRows({}, count, count);
        count += 2;
        endInsertRows();
    }
};

TEST(ModelTester, FailsTheTestOfAModelThatLies)
{
    testing::TestPartResultArray findings;
    {
        const testing::ScopedFakeTestPartResultReporter reporter(
            testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &findings);
        Liar liar;
        const test::ModelTester tester(liar);
        liar.grow();
    }
    EXPECT_GT(findings.size(), 0);
}

} // namespace
} // namespace codewheel
