// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/input/checked_delegate.h"

namespace codewheel {

// Paints the cells of the parameter table, a value over a small detail, and edits the wanted values. Bad
// input keeps its field open, so that nothing typed is lost; Escape discards it.
class ParameterDelegate final : public CheckedDelegate
{
    Q_OBJECT

public:
    using CheckedDelegate::CheckedDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    // What stands in small type below the value takes no second line.
    static int leastWidth(const QModelIndex &index);
    // Of the longest word of the value, and of the whole value on one line.
    static int wordWidth(const QModelIndex &index);
    static int lineWidth(const QModelIndex &index);
    void updateEditorGeometry(QWidget *editor, const QStyleOptionViewItem &option,
                              const QModelIndex &index) const override;
    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                          const QModelIndex &index) const override;
    void setEditorData(QWidget *editor, const QModelIndex &index) const override;
    void setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const override;
};

} // namespace codewheel
