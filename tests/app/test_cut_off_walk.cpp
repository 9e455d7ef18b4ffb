// SPDX-License-Identifier: GPL-3.0-or-later
// What the walk over all widgets counts as cut off, and what it does not.
#include "tests/support/cut_off.h"
#include "widgets/look/may_elide.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStandardItemModel>
#include <QTabBar>
#include <QTableView>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::cutOff;

class CutOffWalk : public testing::Test
{
protected:
    CutOffWalk() { window.resize(400, 200); }

    template <class Widget>
    Widget &add(Widget *widget, const QRect &where)
    {
        widget->setParent(&window);
        widget->setGeometry(where);
        return *widget;
    }
    std::size_t found()
    {
        window.show();
        return cutOff(window).size();
    }

    QWidget window;
    QString sentence = QStringLiteral("As long as a sentence may well be");
};

TEST_F(CutOffWalk, ALabelWithRoomIsWhole)
{
    add(new QLabel(sentence), {0, 0, 390, 30});
    EXPECT_EQ(found(), 0U);
}

TEST_F(CutOffWalk, FindsWhatItsOwnWidgetClips)
{
    add(new QLabel(sentence), {0, 0, 90, 30});
    add(new QPushButton(sentence), {0, 40, 90, 30});
    EXPECT_EQ(found(), 2U);
}

TEST_F(CutOffWalk, FindsWhatIsBesideItsWindow)
{
    add(new QLabel(sentence), {350, 0, 390, 30});
    EXPECT_EQ(found(), 1U);
}

TEST_F(CutOffWalk, FindsLinesThatHaveNoRoom)
{
    auto &label = add(new QLabel(sentence), {0, 0, 90, 20});
    label.setWordWrap(true);
    EXPECT_GE(found(), 1U);
}

TEST_F(CutOffWalk, WhatCanBeScrolledToIsNotCutOff)
{
    auto &area = add(new QScrollArea, {0, 0, 290, 20});
    auto *label = new QLabel(QStringList(10, sentence).join(u'\n'));
    label->resize(label->sizeHint());
    area.setWidget(label);
    EXPECT_EQ(found(), 0U);
    area.setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    EXPECT_GE(found(), 1U) << "nobody gets there";
}

TEST_F(CutOffWalk, FindsWhatIsBeyondTheEdgeOfAForm)
{
    auto &area = add(new QScrollArea, {0, 0, 90, 90});
    auto *label = new QLabel(sentence);
    label->resize(label->sizeHint());
    area.setWidget(label);
    EXPECT_GE(found(), 1U) << "though one could scroll there";
    label->setText(QString(90, u' ') + sentence);
    label->resize(label->sizeHint());
    EXPECT_GE(found(), 1U) << "all of it is beyond";
}

TEST_F(CutOffWalk, ATableOfManyColumnsIsLookedAlong)
{
    QStandardItemModel model;
    model.appendRow({new QStandardItem(sentence), new QStandardItem(sentence)});
    auto &table = add(new QTableView, {0, 0, 190, 190});
    table.setModel(&model);
    table.resizeColumnsToContents();
    EXPECT_EQ(found(), 0U);
}

TEST_F(CutOffWalk, FindsAnElidedTabAndOneBeyondTheOthers)
{
    auto &bar = add(new QTabBar, {0, 0, 90, 30});
    bar.setElideMode(Qt::ElideRight);
    bar.setUsesScrollButtons(false);
    bar.addTab(sentence);
    EXPECT_EQ(found(), 1U);
    bar.setElideMode(Qt::ElideNone);
    bar.setUsesScrollButtons(true);
    EXPECT_GE(found(), 1U);
}

TEST_F(CutOffWalk, FindsAnItemThatItsClosedBoxHasNoRoomFor)
{
    auto &box = add(new QComboBox, {0, 0, 90, 30});
    box.addItems({QStringLiteral("short"), sentence});
    EXPECT_EQ(found(), 1U);
}

TEST_F(CutOffWalk, AnElidedCellCountsUnlessItsColumnMayElide)
{
    QStandardItemModel model;
    model.appendRow({new QStandardItem(sentence), new QStandardItem(sentence)});
    auto &table = add(new QTableView, {0, 0, 390, 190});
    table.setModel(&model);
    EXPECT_EQ(found(), 2U);
    allowEliding(table, 1);
    EXPECT_EQ(found(), 1U);
    allowEliding(table, 0);
    EXPECT_EQ(found(), 0U);
}

} // namespace
} // namespace codewheel
