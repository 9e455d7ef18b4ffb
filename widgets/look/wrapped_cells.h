// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

class QTableView;

namespace codewheel {

// Wraps the texts of a table to the width of their columns, so that nothing is cut off; those that may be
// elided (may_elide.h) stay on one line. For tables of texts only.
class WrappedCells : public QStyledItemDelegate
{
    Q_OBJECT

public:
    explicit WrappedCells(QTableView &table);
    // Its rows follow the widths of its columns.
    static void useIn(QTableView &table);

    struct Widths
    {
        int word = 0;      // of the longest word of the text
        int line = 0;      // of all of it
        int smallWord = 0; // of the longest word in small type
    };
    Widths widthsOf(const QModelIndex &index) const;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    QRect textRect(const QStyleOptionViewItem &option) const;
    int besideText(const QStyleOptionViewItem &option) const;

    const QTableView &m_table;
};

} // namespace codewheel
