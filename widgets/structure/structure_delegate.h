// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace codewheel {

// A cell of the bus structure. What is grey, old or cut off, is pale in a chosen row. A state that has no
// room for its word is its icon alone.
class StructureDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override;
};

// A device in the bus structure: what people at the plant call it first, its place and make small behind it.
// Where there is no room, the latter are cut off first.
class NameDelegate : public StructureDelegate
{
public:
    using StructureDelegate::StructureDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
};

} // namespace codewheel
