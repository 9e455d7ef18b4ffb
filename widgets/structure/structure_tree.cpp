// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure/structure_tree.h"

#include "widgets/look/grid.h"
#include "widgets/look/roles.h"
#include "widgets/structure/structure_model.h"

#include <QItemSelectionModel>
#include <QPainter>
#include <QPaintEvent>

namespace codewheel {

// Where the rows that changed are not neighbours, QTreeView paints them whole; this one stays within the
// column that changed.
void StructureTree::paintEvent(QPaintEvent *event)
{
    const QRect changed = event->region().boundingRect();
    QPaintEvent ofColumn(changed); // what did not change in it is clipped
    QTreeView::paintEvent(columnAt(changed.left()) == columnAt(changed.right()) ? &ofColumn : event);
}

// The focus alone chooses nothing: what is chosen is acted on.
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
