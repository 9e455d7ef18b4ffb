// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

class QTableView;

namespace codewheel {

// Wraps the texts of a table to the width of their columns, so that nothing is cut off. For tables of texts
// only.
class WrappedCells : public QStyledItemDelegate
{
    Q_OBJECT

public:
    // Row heights follow the widths of the columns.
    static void useIn(QTableView &table);

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    explicit WrappedCells(QTableView &table);

    const QTableView &m_table;
};

} // namespace codewheel
