// SPDX-License-Identifier: GPL-3.0-or-later
// A log of many rows: only those in sight are measured, whatever was shown before.
#include "widgets/look/log_table.h"

#include <QAbstractTableModel>
#include <QAction>
#include <QApplication>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr int column = 1; // that wraps
constexpr int aFew = 500; // asked for in five rounds of a small window

class CountingModel : public QAbstractTableModel
{
public:
    explicit CountingModel(int rows, int columns = 2)
        : m_rows(rows)
        , m_columns(columns)
    {}

    int rowCount(const QModelIndex &) const override { return m_rows; }
    int columnCount(const QModelIndex &) const override { return m_columns; }
    QVariant data(const QModelIndex &index, int role) const override
    {
        if (role != Qt::DisplayRole)
            return {};
        asked += index.column() == column ? 1 : 0;
        return QStringLiteral("a text that is so long that it wraps in a column of a table that is small");
    }

    mutable int asked = 0;

private:
    const int m_rows;
    const int m_columns;
};

class LogTableTest : public testing::Test
{
protected:
    LogTableTest()
    {
        table.resize(300, 200);
        table.setTextColumn(column, 10);
        follow.setCheckable(true);
        follow.setChecked(true);
        table.setFollow(follow);
    }
    void show(CountingModel &model)
    {
        model.asked = 0;
        table.setModel(&model);
        table.setTextColumn(column, 10);
        QApplication::processEvents();
    }

    CountingModel many{20'000};
    CountingModel others{10'000};
    CountingModel few{3, 4};
    QAction follow;
    LogTable table{QStringLiteral("log")};
};

TEST_F(LogTableTest, MeasuresAFewRowsOfManyInView)
{
    table.show();
    show(many);
    EXPECT_LT(many.asked, aFew);
    show(others);
    EXPECT_LT(others.asked, aFew);
    show(many);
    EXPECT_LT(many.asked, aFew);
    show(few); // the header has its rows before the table has
    EXPECT_LT(many.asked, aFew);
}

TEST_F(LogTableTest, MeasuresAFewRowsOfManyBehindAnotherTab)
{
    show(many);
    EXPECT_LT(many.asked, aFew);
    show(others);
    EXPECT_LT(others.asked, aFew);
    table.show();
    show(many);
    EXPECT_LT(many.asked, aFew);
}

} // namespace
} // namespace codewheel
