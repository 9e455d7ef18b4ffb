// SPDX-License-Identifier: GPL-3.0-or-later
// How a small table shares its width, and how the last column of a log gives way.
#include "widgets/look/fitted_columns.h"
#include "widgets/look/log_table.h"
#include "widgets/look/quiet_table.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QStandardItemModel>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class FittedColumnsTest : public testing::Test
{
protected:
    enum Column { name, sentence, number };

    FittedColumnsTest()
    {
        model.appendRow({new QStandardItem(QStringLiteral("Measuring length")),
                         new QStandardItem(QStringLiteral("What it has already is not written once more")),
                         new QStandardItem(QStringLiteral("50.000"))});
        model.setHorizontalHeaderLabels({QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("C")});
        setUpQuietTable(table, model, QStringLiteral("Values"));
        FittedColumns::useIn(table, name);
    }
    void show(int width)
    {
        table.resize(width, 200);
        table.show();
        QCoreApplication::processEvents();
    }
    bool isOnOneLine(Column column)
    {
        return table.fontMetrics().horizontalAdvance(model.index(0, column).data().toString()) <
               table.columnWidth(column);
    }
    int widths() const
    {
        return table.columnWidth(name) + table.columnWidth(sentence) + table.columnWidth(number);
    }

    QStandardItemModel model;
    QTableView table;
};

TEST_F(FittedColumnsTest, EachTextStandsOnOneLineWhereThereIsRoom)
{
    show(900);
    for (const Column column : {name, sentence, number})
        EXPECT_TRUE(isOnOneLine(column)) << column;
    EXPECT_EQ(widths(), table.viewport()->width()) << "the name has what is left over";
}

TEST_F(FittedColumnsTest, TheWidestTextTakesMoreLinesFirst)
{
    show(900);
    const int line = table.rowHeight(0);
    show(360);
    EXPECT_TRUE(isOnOneLine(name));
    EXPECT_FALSE(isOnOneLine(sentence));
    EXPECT_TRUE(isOnOneLine(number));
    EXPECT_EQ(widths(), table.viewport()->width());
    EXPECT_GT(table.rowHeight(0), line);
}

TEST_F(FittedColumnsTest, NoColumnIsNarrowerThanItsLongestWord)
{
    show(60);
    EXPECT_GT(table.columnWidth(name), table.fontMetrics().horizontalAdvance(QStringLiteral("Measuring")));
    EXPECT_TRUE(isOnOneLine(number));
}

TEST_F(FittedColumnsTest, WhatComesLaterIsMeasuredToo)
{
    show(900);
    model.item(0, number)->setText(QStringLiteral("50.000 steps, read at two minutes past two"));
    QCoreApplication::processEvents();
    EXPECT_TRUE(isOnOneLine(number));
}

TEST_F(FittedColumnsTest, AHeadingHasTheRoomThatItTakes)
{
    const QString heading = QStringLiteral("Encoder and parameter");
    model.setHorizontalHeaderLabels({QStringLiteral("A"), QStringLiteral("B"), heading});
    model.item(0, number)->setText(QStringLiteral("1"));
    show(60);
    EXPECT_GE(table.columnWidth(number),
              QFontMetrics(table.horizontalHeader()->font()).horizontalAdvance(heading));
    EXPECT_LT(table.columnWidth(number), table.horizontalHeader()->sectionSizeHint(number))
        << "which Qt measures as a bold one";
}

class ElasticColumn : public testing::Test
{
protected:
    ElasticColumn()
    {
        log.setModel(&model);
        log.setTextColumn(0, 10);
        log.setElasticColumn({.column = 1, .least = 50, .most = 120, .wantedLetters = 30});
    }
    int widthIn(int width)
    {
        log.resize(width, 200);
        log.show();
        QCoreApplication::processEvents();
        return log.columnWidth(1);
    }

    QStandardItemModel model{1, 2};
    LogTable log{QStringLiteral("Log")};
};

TEST_F(ElasticColumn, GivesWayToTheTextDownToItsLeastWidth)
{
    EXPECT_EQ(widthIn(900), 120);
    EXPECT_EQ(widthIn(200), 50);
    EXPECT_EQ(log.columnWidth(0), log.viewport()->width() - 50) << "nothing is out of sight";
}

TEST_F(ElasticColumn, ATextOfTwoLinesStandsApartFromTheNext)
{
    model.setItem(0, 0, new QStandardItem(QStringLiteral("Read out temperature, running, position 12,345")));
    widthIn(250);
    EXPECT_GE(log.rowHeight(0), 2 * log.fontMetrics().lineSpacing() + 4);
}

// Its view may show the same encoder anew.
TEST_F(ElasticColumn, TheSameModelAgainStaysChosenFrom)
{
    log.setModel(&model);
    ASSERT_NE(log.selectionModel(), nullptr);
    log.setFocus();
    log.setCurrentIndex(model.index(0, 0));
    EXPECT_EQ(log.currentIndex().row(), 0);
}

TEST_F(ElasticColumn, StaysAsItIsDragged)
{
    widthIn(900);
    log.setColumnWidth(1, 300);
    EXPECT_EQ(widthIn(800), 300);
    log.hideColumn(1);
    log.showColumn(1);
    EXPECT_EQ(widthIn(700), 300);
}

} // namespace
} // namespace codewheel
