// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure/structure_tree.h"

#include "widgets/look/grid.h"
#include "widgets/look/roles.h"
#include "widgets/structure/structure_columns.h"
#include "widgets/structure/structure_model.h"

#include <QHeaderView>
#include <QPainter>
#include <QPaintEvent>

namespace codewheel {
namespace {

constexpr int cable = 2; // pixels

// The heads of the columns of the bus structure. Over icons without words stands nothing.
class StructureHeader : public QHeaderView
{
public:
    explicit StructureHeader(QWidget *parent)
        : QHeaderView(Qt::Horizontal, parent)
    {
        setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    }

protected:
    void initStyleOptionForIndex(QStyleOptionHeader *option, int column) const override
    {
        QHeaderView::initStyleOptionForIndex(option, column);
        if (column == StructureModel::stateColumn && sectionSize(column) <= stateIconWidth())
            option->text.clear();
    }
};

} // namespace

StructureTree::StructureTree(QWidget *parent)
    : QTreeView(parent)
{
    setHeader(new StructureHeader(this));
}

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

// The ends of a broken cable stand before the cells.
void StructureTree::dataChanged(const QModelIndex &first, const QModelIndex &last, const QList<int> &roles)
{
    QTreeView::dataChanged(first, last, roles);
    if (first.column() > StructureModel::deviceColumn)
        return;
    const QRect rows = visualRect(first) | visualRect(last);
    viewport()->update(0, rows.top(), viewport()->width(), rows.height());
}

void StructureTree::drawRow(QPainter *painter, const QStyleOptionViewItem &option,
                            const QModelIndex &index) const
{
    QTreeView::drawRow(painter, option, index);
    if (!index.data(StructureModel::isBehindBreakRole).toBool())
        return;
    const QModelIndex device = index.siblingAtColumn(StructureModel::deviceColumn);
    const int arrow = model()->hasChildren(device) ? indentation() : 0;
    drawBreak(*painter, option.rect, visualRect(device).left() - arrow);
}

// The cable between this row and the one above, and its two ends where it is cut. In a chosen row it stands
// on the ground of the others.
void StructureTree::drawBreak(QPainter &painter, const QRect &row, int left) const
{
    const QColor color = roleColor(Role::fault, palette());
    const QRect ends(left - 4 * grid::unit, row.top(), 4 * grid::unit, 3 * grid::unit);
    painter.save();
    painter.fillRect(QRect(row.left(), row.top() + cable, row.width(), 1), palette().base());
    painter.fillRect(ends, palette().base());
    painter.fillRect(QRect(row.left(), row.top(), ends.left() - row.left(), cable), color);
    painter.fillRect(QRect(left, row.top(), row.right() + 1 - left, cable), color);
    painter.setPen(QPen(color, cable));
    painter.setRenderHint(QPainter::Antialiasing);
    for (const int end : {ends.left() + grid::unit, ends.left() + 2 * grid::unit})
        painter.drawLine(end, ends.bottom() - 1, end + grid::unit, ends.top() + 1);
    painter.restore();
}

} // namespace codewheel
