// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/structure/structure_columns.h"
#include "widgets/structure/structure_model.h"

#include <QHeaderView>

namespace codewheel {

// The heads of the columns of the bus structure. Over icons without words stands nothing.
class StructureHeader : public QHeaderView
{
public:
    explicit StructureHeader(QWidget *parent)
        : QHeaderView(Qt::Horizontal, parent)
    {
        setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    }

protected:
    void initStyleOptionForIndex(QStyleOptionHeader *option, int column) const override
    {
        QHeaderView::initStyleOptionForIndex(option, column);
        if (column == StructureModel::stateColumn && sectionSize(column) <= stateIconWidth())
            option->text.clear();
    }
};

} // namespace codewheel
