// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure/structure_delegate.h"

#include "widgets/structure/structure_columns.h"
#include "widgets/structure/structure_model.h"

namespace codewheel {

void StructureDelegate::initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    if (index.column() == StructureModel::stateColumn && option->rect.width() <= stateIconWidth())
        option->text.clear();
}

} // namespace codewheel
