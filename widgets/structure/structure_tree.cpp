// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure/structure_tree.h"

#include "widgets/look/grid.h"
#include "widgets/look/roles.h"
#include "widgets/structure/structure_model.h"

#include <QItemSelectionModel>
#include <QPainter>
#include <QPaintEvent>

namespace codewheel {

// If the changed rows are not adjacent, QTreeView paints them in full; this one stays within the changed
// column.
void StructureTree::paintEvent(QPaintEvent *event)
{
    const QRect changed = event->region().boundingRect();
    QPaintEvent ofColumn(changed); // clips everything else
    QTreeView::paintEvent(columnAt(changed.left()) == columnAt(changed.right()) ? &ofColumn : event);
}

// Getting the focus selects nothing: the selection has consequences.
void StructureTree::focusInEvent(QFocusEvent *event)
{
    if (currentIndex().isValid())
        QTreeView::focusInEvent(event);
    else
        QAbstractScrollArea::focusInEvent(event);
}

void StructureTree::drawRow(QPainter *painter, const QStyleOptionViewItem &option,
                            const QModelIndex &index) const
{
    QTreeView::drawRow(painter, option, index);
    if (!index.data(StructureModel::isBehindBreakRole).toBool())
        return;
    const int top = option.rect.top() + 1;
    const int left = visualRect(index.siblingAtColumn(StructureModel::deviceColumn)).left();
    const QColor color = selectionModel()->isSelected(index) ? palette().color(QPalette::HighlightedText)
                                                             : roleColor(Role::fault, palette());
    painter->save();
    painter->setPen(QPen(color, 2, Qt::DashLine));
    painter->drawLine(left, top, option.rect.right(), top);
    // the two ends of the cable
    painter->setPen(QPen(color, 2));
    painter->setRenderHint(QPainter::Antialiasing);
    const int middle = left - 2 * grid::unit;
    for (const int end : {middle - grid::unit, middle})
        painter->drawLine(end, top + grid::unit, end + grid::unit, top - 1);
    painter->restore();
}

} // namespace codewheel
