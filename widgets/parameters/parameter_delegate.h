// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace codewheel {

// Paints the parameter table's cells, a value over a small detail, and edits the wanted values. Bad input
// keeps its field open, so that nothing typed is lost; Escape gives it up.
class ParameterDelegate final : public QStyledItemDelegate
{
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                          const QModelIndex &index) const override;
    void setEditorData(QWidget *editor, const QModelIndex &index) const override;
    void setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const override;
    void destroyEditor(QWidget *editor, const QModelIndex &index) const override;

Q_SIGNALS:
    // A sentence while what is typed is bad; empty when it is good or given up.
    void inputChecked(const QString &wrong) const;

protected:
    bool eventFilter(QObject *editor, QEvent *event) override;
};

} // namespace codewheel
