// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/structure/structure_delegate.h"

namespace codewheel {

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
