// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/wrapped_cells.h"

#include "widgets/look/grid.h"
#include "widgets/look/wrapped_text.h"

#include <QApplication>
#include <QHeaderView>
#include <QPainter>
#include <QTableView>

#include <utility>

namespace codewheel {

WrappedCells::WrappedCells(QTableView &table)
    : QStyledItemDelegate(&table)
    , m_table(table)
{}

void WrappedCells::useIn(QTableView &table)
{
    table.setItemDelegate(new WrappedCells(table));
    connect(table.horizontalHeader(), &QHeaderView::sectionResized, &table,
            &QTableView::resizeRowsToContents);
}

void WrappedCells::paint(QPainter *painter, const QStyleOptionViewItem &given, const QModelIndex &index) const
{
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const QString text = std::exchange(option.text, {});
    QApplication::style()->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    const QRect inside = option.rect.adjusted(grid::unit, 0, -grid::unit, 0);
    painter->save();
    painter->setPen(option.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text));
    WrappedText(text, option.font, inside.width(), option.displayAlignment).draw(*painter, inside);
    painter->restore();
}

QSize WrappedCells::sizeHint(const QStyleOptionViewItem &given, const QModelIndex &index) const
{
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const int room = m_table.columnWidth(index.column()) - 2 * grid::unit;
    return {option.fontMetrics.horizontalAdvance(option.text) + 3 * grid::unit,
            WrappedText(option.text, option.font, room, option.displayAlignment).height() + 2 * grid::unit};
}

} // namespace codewheel
