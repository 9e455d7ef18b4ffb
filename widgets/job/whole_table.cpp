// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/whole_table.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QScrollBar>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int mostRowsAtOnce = 12;

} // namespace

WholeTable::WholeTable(QWidget *parent)
    : QTableView(parent)
{
    connect(verticalHeader(), &QHeaderView::sectionResized, this, &WholeTable::tellHeight);
    connect(verticalHeader(), &QHeaderView::sectionCountChanged, this, &WholeTable::tellHeight);
    connect(horizontalHeader(), &QHeaderView::geometriesChanged, this, &WholeTable::tellHeight);
}

// A scroll bar of its own would take width from the rows, which would then be higher, and the table too: so
// it has one only beyond its height.
void WholeTable::tellHeight()
{
    setVerticalScrollBarPolicy(verticalHeader()->count() > mostRowsAtOnce ? Qt::ScrollBarAsNeeded
                                                                          : Qt::ScrollBarAlwaysOff);
    updateGeometry();
    Q_EMIT heightChanged();
}

int WholeTable::heightOf(int rows) const
{
    int height = horizontalHeader()->sizeHint().height() + 2 * frameWidth();
    for (int row = 0; row < std::min(rows, verticalHeader()->count()); ++row)
        height += rowHeight(row);
    return height;
}

QSize WholeTable::sizeHint() const
{
    return {QTableView::sizeHint().width(), heightOf(mostRowsAtOnce)};
}

QSize WholeTable::minimumSizeHint() const
{
    return {QTableView::minimumSizeHint().width(), heightOf(mostRowsAtOnce)};
}

// A page goes on below the rows.
void WholeTable::keyPressEvent(QKeyEvent *event)
{
    const bool isPage = event->key() == Qt::Key_PageUp || event->key() == Qt::Key_PageDown;
    if (isPage && verticalScrollBar()->maximum() == 0)
        event->ignore();
    else
        QTableView::keyPressEvent(event);
}

} // namespace codewheel
