// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeView>

namespace codewheel {

// A tree whose positions change 30 times a second, and that shows between two rows where the bus is broken.
class StructureTree : public QTreeView
{
    Q_OBJECT

public:
    explicit StructureTree(QWidget *parent = nullptr);

    void dataChanged(const QModelIndex &first, const QModelIndex &last,
                     const QList<int> &roles = {}) override;

protected:
    void focusInEvent(QFocusEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void drawRow(QPainter *painter, const QStyleOptionViewItem &option,
                 const QModelIndex &index) const override;

private:
    void drawBreak(QPainter &painter, const QRect &row, int left) const;
};

} // namespace codewheel
