// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

class QTableView;

namespace codewheel {

// Draws the texts of a table on as many lines as their columns need, so that nothing is cut off. For tables
// of texts alone.
class WrappedCells : public QStyledItemDelegate
{
    Q_OBJECT

public:
    // Its rows follow the widths of its columns.
    static void useIn(QTableView &table);

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    explicit WrappedCells(QTableView &table);

    const QTableView &m_table;
};

} // namespace codewheel
