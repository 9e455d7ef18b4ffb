// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPaintEvent>
#include <QTreeView>

namespace codewheel {

// A tree whose positions change 30 times a second. Where the rows that changed are not neighbours, QTreeView
// paints them whole; this one stays within the column that changed.
class StructureTree : public QTreeView
{
public:
    using QTreeView::QTreeView;

protected:
    void paintEvent(QPaintEvent *event) override
    {
        const QRect changed = event->region().boundingRect();
        QPaintEvent ofColumn(changed); // what did not change in it is clipped
        QTreeView::paintEvent(columnAt(changed.left()) == columnAt(changed.right()) ? &ofColumn : event);
    }
};

} // namespace codewheel
